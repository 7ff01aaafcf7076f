# SPDX-License-Identifier: BSD-3-Clause
"""Which room of the sources includes which, and what the order of the rooms forbids.

A room is a folder of src/ and of include/drill_rig_sim/ by the same name, with its sub-folders.
"""
import os
import re

import tokens

# from the ground up: a room includes rooms before it alone
ORDER = ('math', 'well', 'contact', 'string', 'rig', 'hydraulics', 'scene', 'model', 'solve', 'reference', 'compared', 'accuracy', 'instruments', 'crew', 'sim', 'realtime', 'fmi',
         'ros', 'rviz', 'tools', 'python')
OF_ROS = ('ros', 'rviz')
OF_SUNDIALS = ('solve', 'reference', 'compared')
# the one file of realtime/ that knows the simulator: what a frame hands out
FRAME_OUTPUT = 'include/drill_rig_sim/realtime/frame_output.h'
# the one file of ros/ that has no ROS in it, so that rooms after it may include it
RUN_BAG = 'include/drill_rig_sim/ros/run_bag.h'

PUBLIC = 'include/drill_rig_sim/'
MANUAL = 'src/manual/'  # texts, in no room
INCLUDE = re.compile(r'\s*#\s*include\s*[<"]([^>"]+)[>"]')
ROS_HEADER = re.compile(r'(ros|roslib|roscpp|rosbag|rosconsole|rosgraph|rostest|xmlrpcpp|\w+_msgs|\w+_srvs|tf|tf2|tf2_\w+|actionlib'
                        r'|class_loader|diagnostic_updater|dynamic_reconfigure|message_filters|nodelet|pluginlib|rviz|topic_tools|urdf)/')
SUNDIALS_HEADER = re.compile(r'(arkode|cvodes?|idas?|kinsol|nvector|sundials'
                             r'|sun(adaptcontroller|domeigest|linsol|matrix|memory|nonlinsol))/')


class Include:
    """One line of a file: `header` as written, `target` the file of this package that it names, None where it is another's."""

    def __init__(self, file, line, header, target):
        self.file, self.line, self.header, self.target = file, line, header, target
        self.room, self.target_room = room_of(file), target and room_of(target)

    def place(self):
        return '%s:%d' % (self.file, self.line)


def room_of(file):
    """The room that a file of src/ or include/ belongs to; empty where it lies in none."""
    for top in (PUBLIC, 'src/'):
        if file.startswith(top) and '/' in file[len(top):]:
            return file[len(top):].split('/')[0]
    return ''


def headers(text):
    """(line, header as written) of each include; those in comments and in texts do not count."""
    for match in tokens.TOKEN.finditer(text):
        written = INCLUDE.match(match.group()) if match.lastgroup == 'directive' else None
        if written:
            yield text.count('\n', 0, match.start()) + 1, written.group(1)


def find(texts):
    """All includes of {file: text}, files named from the top of the package. Read are those of src/ and include/."""
    found = []
    for file in sorted(texts):
        if not file.startswith(('src/', 'include/')):
            continue
        for line, header in headers(texts[file]):
            beside = os.path.normpath(os.path.join(os.path.dirname(file), header))
            target = next((path for path in (beside, 'include/' + header) if path in texts), None)
            found.append(Include(file, line, header, target))
    return found


def generated(files):
    """The headers that are made from messages, services and actions."""
    names = set()
    for file in files:
        folder, name = os.path.split(file)
        stem, kind = os.path.splitext(name)
        if folder == 'msg' and kind == '.msg':
            names.add('drill_rig_sim/%s.h' % stem)
        if folder == 'srv' and kind == '.srv':
            names.update('drill_rig_sim/%s%s.h' % (stem, part) for part in ('', 'Request', 'Response'))
        if folder == 'msg/actions':
            names.update('drill_rig_sim/%s%s.h' % (stem, part) for part in ('Action', 'Goal', 'Result', 'Feedback'))
    return names


def fault(include, messages):
    """What is wrong with an include; None where nothing is."""
    room, target, header = include.room, include.target_room, include.header
    if include.file == RUN_BAG and (target in OF_ROS or header in messages or ROS_HEADER.match(header)):
        return '%s includes %s: it has no ROS in it, for the sake of tools/' % (os.path.basename(RUN_BAG), header)
    if include.target is None:
        if header in messages or ROS_HEADER.match(header):
            return None if room in OF_ROS else '%s/ includes %s: ROS is for %s alone' % (room, header, folders(OF_ROS))
        if SUNDIALS_HEADER.match(header):
            return None if room in OF_SUNDIALS else '%s/ includes %s: SUNDIALS is for %s alone' % (room, header, folders(OF_SUNDIALS))
        return 'there is no %s' % header if header.startswith('drill_rig_sim/') else None
    if room == target or room not in ORDER or target not in ORDER:
        return None  # a room that is not in the order is reported once, by faults()
    if ORDER.index(target) > ORDER.index(room):
        return '%s/ includes %s: %s/ comes later in the order of the rooms' % (room, header, target)
    if target in OF_ROS and room not in OF_ROS and include.target != RUN_BAG:
        return '%s/ includes %s, and ROS with it: that is for %s alone' % (room, header, folders(OF_ROS))
    if room == 'realtime' and target != 'math' and include.file != FRAME_OUTPUT:
        return 'realtime/ includes %s: of drilling it knows %s alone' % (header, os.path.basename(FRAME_OUTPUT))
    return None


def folders(rooms):
    return ' and '.join(room + '/' for room in rooms)


def faults(texts):
    """A line for each include that the order forbids, and for each file outside the rooms."""
    messages = generated(texts)
    lines = []
    for file in sorted(texts):
        if file.startswith(('src/', 'include/')) and not file.startswith(MANUAL) and room_of(file) not in ORDER:
            lines.append('%s:1: in no room of the order: %s' % (file, ', '.join(ORDER)))
    for include in find(texts):
        wrong = fault(include, messages)
        if wrong:
            lines.append('%s: %s' % (include.place(), wrong))
    return lines


def arrows(texts):
    """{room: {room that it includes: how often}} for every room that there is."""
    table = {room_of(file): {} for file in texts if file.startswith(('src/', 'include/')) and not file.startswith(MANUAL)}
    for include in find(texts):
        if include.target and include.target_room != include.room:
            row = table[include.room]
            row[include.target_room] = row.get(include.target_room, 0) + 1
    return table


def rank(room):
    """The order, and behind it what is not in it."""
    return ORDER.index(room) if room in ORDER else len(ORDER)


def as_text(table):
    """A line for each room, from the ground up."""
    lines = []
    for room in sorted(table, key=rank):
        row = ', '.join('%s %d' % (other, table[room][other]) for other in sorted(table[room], key=rank))
        lines.append('%-10s -> %s' % (room, row or '(none)'))
    return '\n'.join(lines) + '\n'


def as_dot(table):
    """The same for graphviz: the ground at the bottom, an arrow upwards in red."""
    rooms = sorted(table, key=rank)
    lines = ['digraph rooms {', '  rankdir=TB;', '  node [shape=box, fontname="sans-serif"];',
             '  edge [fontname="sans-serif", fontsize=9];']
    lines += ['  "%s";' % room for room in reversed(rooms)]
    for room in reversed(rooms):
        for other in sorted(table[room], key=rank):
            colour = ', color=red, constraint=false' if rank(other) > rank(room) else ''
            lines.append('  "%s" -> "%s" [label="%d"%s];' % (room, other, table[room][other], colour))
    return '\n'.join(lines + ['}']) + '\n'
