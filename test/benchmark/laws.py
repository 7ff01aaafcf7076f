# SPDX-License-Identifier: BSD-3-Clause
"""What each law costs: instructions of a frame by callgrind, counted inside Simulator::frame() alone, over nodes and steps.

Both trees run the same scene on the same mesh with the same method and step, so that what differs is what a step of a node costs. Instructions do not
depend on what else the machine does.
"""
import collections
import json
import os
import re
import subprocess

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
JOINT = '9.5'  # [m]
STEP = '0.01'  # [s]
Scene = collections.namedtuple('Scene', 'name path duration')  # path: from the source; duration: simulated [s]
SCENES = (Scene('bent motor turned and lowered, 0.7 km', 'config/scenes/bohai.yaml', 12.0),
          Scene('horizontal 5 km, picked up', 'test/operations/scenes/horizontal_5_km.yaml', 3.0))
# (what, source file, function): all that is called from it counts; a sum where there are several
PARTS = (('frame', (('sim/simulator.cpp', 'Simulator::frame('),)),
         ('motion of the nodes', (('model/kernels/motion_kernel.cpp', 'move('),)),
         ('beams, inertia, drag of the mud', (('model/forces/free_string.cpp', 'add_free_string('),)),
         ('places in the hole', (('model/places.cpp', 'find_in_hole('),)),
         ('of these between nodes', (('model/places.cpp', 'find_span('),)),
         ('wall and friction, at nodes', (('model/forces/wall.cpp', 'add_sticking('),)),
         ('wall and friction, between nodes', (('model/forces/span_wall.cpp', 'add_span_wall<'),)),
         ('squeeze films', (('model/forces/squeeze_film.cpp', 'add_squeeze_film('),)),
         ('bit and rock', (('model/forces/bit.cpp', 'add_drilling('), ('model/extend_hole.cpp', 'extend_hole('))),
         ('rig: lines, block, mast, top drive', (('model/forces/hoisting.cpp', 'add_hoisting('), ('model/forces/guide_rail.cpp', 'add_rail('),
                                                 ('model/forces/top_drive.cpp', 'add_top_drive('))),
         ('linear system', (('math/block_tridiagonal.cpp', 'BlockTridiagonal::solve('), ('math/block_tridiagonal.cpp', 'BlockTridiagonal::solve_again('))),
         ('start of a step', (('model/stage.cpp', 'begin_step('),)),
         ('energy balance', (('solve/halving_integrator.cpp', 'open_books('), ('solve/halving_integrator.cpp', 'close_books('))),
         ('warnings', (('sim/accuracy_watch.cpp', 'watch_model('), ('sim/string_watch.cpp', 'StringWatch::look('))))


def run(drill, scene, duration, folder, level='beam3d'):
    """Inclusive instructions by (source file, signature), and what `drill run --json` tells."""
    out, summary = os.path.join(folder, 'callgrind.laws'), os.path.join(folder, 'laws.json')
    subprocess.run(['valgrind', '--tool=callgrind', '--callgrind-out-file=' + out, '--toggle-collect=drill_rig_sim::Simulator::frame*', drill, 'run', scene,
                    '--duration', '%g' % duration, '--element-length', JOINT, '--step', STEP, '--integrator', 'bdf2', '--set', 'numerics.level=' + level, '--json', summary],
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True)
    told = subprocess.run(['callgrind_annotate', '--inclusive=yes', '--threshold=100', out], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=True,
                          universal_newlines=True).stdout
    with open(summary) as file:
        return table_of(told), json.load(file)


def table_of(annotated):
    """Rows of callgrind_annotate as {(file below src, signature): instructions}; a file may stand there by two paths, or as ???."""
    rows = {}
    for line in annotated.splitlines():
        match = re.match(r'\s*([\d,]+) \([\d. ]+%\)\s+(?:(?:\S*?/)?src/)?(\?\?\?|[^:/]+/[^:]+):(.*?)( \[[^\]]*\])?$', line)
        if match:
            key = (match.group(2), match.group(3))
            rows[key] = max(rows.get(key, 0), int(match.group(1).replace(',', '')))
    return rows


def count(rows, pieces):
    """Of pieces (file, function), the file None for a function whose name is that of no other."""
    return sum(n for (file, signature), n in rows.items() for end, function in pieces
               if end in (file, None) and ('::' + function) in signature and '{lambda' not in signature)


def measure(tree, folder):
    """By scene and part: instructions a node and step. A scene that the tree does not have is this one's."""
    drill = os.path.join(tree, 'build/devel/lib/drill_rig_sim/drill')
    found = {}
    for scene in SCENES:
        path = next(path for path in (os.path.join(tree, scene.path), os.path.join(SOURCE, scene.path)) if os.path.exists(path))
        rows, summary = run(drill, path, scene.duration, folder)
        if not count(rows, PARTS[0][1]):
            raise SystemExit('run: %s has no line numbers, by which files are found: build it with -DCMAKE_CXX_FLAGS=-g1' % drill)
        found[scene.name] = [count(rows, pieces) / (summary['nodes'] * summary['steps']) for _, pieces in PARTS]
    return found


def text(mine, theirs):
    """A table; `theirs`: of an older tree, or empty. What a tree has not, or another way, has a dash."""
    head = [name for scene in SCENES for name in ([scene.name] + ([scene.name + ', before'] if scene.name in theirs else []))]
    rows = ['| instructions a node and step | ' + ' | '.join(head) + ' |', '| --- ' * (len(head) + 1) + '|']
    for k, (what, _) in enumerate(PARTS):
        values = [side[scene.name][k] for scene in SCENES for side in (mine, theirs) if scene.name in side]
        rows.append('| %s | %s |' % (what, ' | '.join('%.0f' % value if value else '-' for value in values)))
    return '\n'.join(rows) + '\n'
