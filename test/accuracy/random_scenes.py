# SPDX-License-Identifier: BSD-3-Clause
"""Scenes drawn at random: wells, strings, muds and operations in the ranges of the trade. The same seed draws the same scenes; no list of them is kept, so
that nothing can be tuned to it.

A scene is named by its seed and number; its first line says what it is and for how long it is played, as of those of foreign/scenes.
"""
import math
import random

# hole, collar's and pipe's diameters: outer and inner [m], mass in air [kg/m]; tool joint [m]
SIZES = (
    {'hole': 0.1556, 'collar': (0.1207, 0.0571, 70.0), 'pipe': (('4 in', 0.1016, 0.0848, 23.0, 0.133), ('3.5 in', 0.0889, 0.0702, 21.2, 0.1207))},
    {'hole': 0.2159, 'collar': (0.1651, 0.0714, 136.0), 'pipe': (('5 in', 0.127, 0.1086, 31.9, 0.168), ('5.5 in', 0.1397, 0.1214, 38.0, 0.178))},
    {'hole': 0.3112, 'collar': (0.2032, 0.0714, 224.0), 'pipe': (('5 in', 0.127, 0.1086, 31.9, 0.168), ('5.5 in', 0.1397, 0.1214, 38.0, 0.178))},
)


class Path:
    """Stations [m, deg, deg] of a hole that begins vertical."""

    def __init__(self, draw, depth):
        self.draw, self.depth = draw, depth
        azimuth = round(draw.uniform(0.0, 360.0), 2)
        self.stations = [[0.0, 0.0, azimuth]]

    def to(self, md, inclination, azimuth=None, rough=0.0):
        """On to `md`, not beyond the well's depth, at a constant rate, with stations every 30 m that a driller missed by `rough` [deg]."""
        md0, inclination0, azimuth0 = self.stations[-1]
        azimuth = azimuth0 if azimuth is None else azimuth
        md = min(md, self.depth)
        if md - md0 < 1.0:  # it is there
            self.stations[-1][0] = max(md, md0)
            return
        pieces = max(1, round((md - md0) / 30.0))
        for k in range(1, pieces + 1):
            share = k / pieces
            at = inclination0 + share * (inclination - inclination0) + self.draw.gauss(0.0, rough)
            self.stations.append([round(md0 + share * (md - md0), 2), round(max(at, 0.0), 2), round((azimuth0 + share * (azimuth - azimuth0)) % 360.0, 3)])


def vertical(draw, depth):
    path = Path(draw, depth)
    path.to(depth, 0.0)
    return 'vertical', path


def crooked(draw, depth):
    path = Path(draw, depth)
    path.to(100.0, 0.0)
    wander = draw.uniform(0.3, 1.0)
    while path.stations[-1][0] < depth - 1.0:
        path.to(path.stations[-1][0] + 30.0, min(3.0, abs(path.stations[-1][1] + draw.gauss(0.0, wander))), path.stations[-1][2] + draw.gauss(0.0, 20.0))
    return 'crooked vertical', path


def j_shaped(draw, depth):
    path = Path(draw, depth)
    kick_off, held = draw.uniform(0.1, 0.4) * depth, draw.uniform(15.0, 65.0)
    path.to(kick_off, 0.0)
    path.to(kick_off + held / draw.uniform(2.0, 5.0) * 30.0, held)
    path.to(depth, path.stations[-1][1], rough=draw.choice((0.0, 0.1, 0.3)))
    return 'J', path


def s_shaped(draw, depth):
    path = Path(draw, depth)
    held, rate = draw.uniform(15.0, 40.0), draw.uniform(2.0, 4.0)
    path.to(0.15 * depth, 0.0)
    path.to(0.15 * depth + held / rate * 30.0, held)
    path.to(max(path.stations[-1][0] + 60.0, 0.55 * depth), path.stations[-1][1])
    path.to(path.stations[-1][0] + path.stations[-1][1] / rate * 30.0, draw.uniform(0.0, 8.0))
    path.to(depth, path.stations[-1][1])
    return 'S', path


def horizontal(draw, depth):
    path = Path(draw, depth)
    rate, landed = draw.uniform(5.0, 10.0), draw.uniform(84.0, 91.0)
    kick_off = draw.uniform(0.15, 0.5) * depth
    path.to(kick_off, 0.0)
    path.to(min(kick_off + landed / rate * 30.0, depth - 60.0), landed)
    path.to(depth, landed, rough=draw.choice((0.0, 0.1, 0.3)))
    return 'horizontal', path


def turning(draw, depth):
    path = Path(draw, depth)
    held = draw.uniform(20.0, 50.0)
    path.to(0.2 * depth, 0.0)
    path.to(0.2 * depth + held / draw.uniform(2.0, 4.0) * 30.0, held)
    path.to(0.75 * depth, held, path.stations[-1][2] + draw.choice((-1, 1)) * draw.uniform(20.0, 80.0))
    path.to(depth, path.stations[-1][1])
    return 'turning', path


PATHS = (vertical, crooked, j_shaped, s_shaped, horizontal, turning)


def bit_of(draw, diameter):
    kinetic = round(draw.uniform(0.25, 0.45), 2)
    if draw.random() < 0.5:
        torque = {'static': round(kinetic + draw.uniform(0.05, 0.15), 2), 'kinetic': kinetic}
    else:
        torque = {'model': 'stribeck', 'static': round(kinetic + draw.uniform(0.0, 0.1), 2), 'kinetic': kinetic, 'speed_rpm': round(draw.uniform(15.0, 40.0))}
    return {'name': 'bit', 'type': 'bit', 'length': 0.3, 'mass': 40.0, 'diameter': diameter, 'torque': torque}


def string_of(draw, size):
    """What it is in words, and its parts."""
    outer, inner, mass = size['collar']
    name, pipe_outer, pipe_inner, pipe_mass, tool_joint = draw.choice(size['pipe'])
    parts, words = [bit_of(draw, size['hole'])], []
    body = {'outer_diameter': outer, 'inner_diameter': inner, 'linear_mass': mass}
    for k in range(draw.choice((0, 0, 1, 2))):
        parts.append(dict({'name': 'stabilizer%d' % (k + 1), 'type': 'stabilizer', 'length': 1.5, 'blade_diameter': round(size['hole'] - 0.0064, 4)}, **body))
        if k == 0:
            parts.append(dict({'name': 'pony', 'type': 'collar', 'joints': 1, 'joint_length': 4.6}, **body))
        words = ['%d stabilisers' % (k + 1)] if k else ['stabiliser']
    parts.append(dict({'name': 'collar', 'type': 'collar', 'joints': draw.randint(2, 12), 'joint_length': 9.4}, **body))
    heavy = draw.choice((0, 0, 6, 12))
    if heavy and size['hole'] > 0.2:
        parts.append({'name': 'hwdp', 'type': 'pipe', 'joints': heavy, 'joint_length': 9.5, 'outer_diameter': 0.1397, 'inner_diameter': 0.0857, 'linear_mass': 85.0,
                      'tool_joint_diameter': 0.178})
        words.append('%d heavyweight' % heavy)
    parts.append({'name': 'drill_pipe', 'type': 'pipe', 'joints': 'fill', 'joint_length': 9.5, 'outer_diameter': pipe_outer, 'inner_diameter': pipe_inner,
                  'linear_mass': pipe_mass, 'tool_joint_diameter': tool_joint})
    return ', '.join(words + [name]), parts


def turn(draw, at):
    return {'at': at, 'top_drive_speed_rpm': draw.randint(40, 180), 'ramp': draw.choice((1, 3, 6))}


def move(at, speed):
    return {'at': round(at, 1), 'block_velocity': round(speed, 3), 'ramp': 1}


def tripping(draw, flow):
    """Off bottom: up or down, perhaps turning, and a stop."""
    speed = draw.choice((-1, 1)) * draw.uniform(0.03, 0.4)
    lines, begins = [], 3.0
    if draw.random() < 0.4:
        lines, begins = [dict(turn(draw, 0.0), flow=flow)], 15.0
    ends = begins + draw.uniform(10.0, 25.0)
    lines += [move(begins, speed), move(ends, 0.0)]
    return 'trip %.2g m/s%s' % (speed, ' turning' if begins > 3.0 else ''), ends + 10.0, draw.uniform(15.0, 60.0), None, lines


def turning_off_bottom(draw, flow):
    lines = [dict(turn(draw, 0.0), flow=flow), turn(draw, 25.0)]
    return 'turn %d, %d rpm' % tuple(line['top_drive_speed_rpm'] for line in lines), 50.0, draw.uniform(5.0, 30.0), None, lines


def drilling(draw, flow):
    weight = round(draw.uniform(10e3, 60e3), -3)
    lines = [dict(turn(draw, 0.0), flow=flow), move(6.0, -draw.uniform(0.001, 0.006))]
    if draw.random() < 0.4:
        lines += [move(30.0, 0.0), turn(draw, 40.0)]
    return 'drill %.0f kN at %d rpm' % (1e-3 * weight, lines[0]['top_drive_speed_rpm']), 60.0, None, weight, lines


def tagging(draw, flow):
    speed, off = draw.uniform(0.03, 0.2), draw.uniform(0.3, 1.0)
    begins = 8.0
    lines = [dict(turn(draw, 0.0), flow=flow), move(begins, -speed), move(begins + off / speed, -draw.uniform(0.002, 0.01)), {'at': round(begins + off / speed + 10.0, 1), 'brake': True},
             move(begins + off / speed + 22.0, 0.15)]
    return 'tag %.2g m/s, pick up' % speed, begins + off / speed + 32.0, off, None, lines


OPERATIONS = (tripping, tripping, turning_off_bottom, drilling, drilling, tagging)


def drawn(seed, number):
    """First line and scene."""
    draw = random.Random('%s %s' % (seed, number))
    size, depth = draw.choice(SIZES), round(draw.uniform(600.0, 2100.0), 0)
    kind, path = draw.choice(PATHS)(draw, depth)
    words, parts = string_of(draw, size)
    what, seconds, off, weight, lines = draw.choice(OPERATIONS)(draw, round(draw.uniform(0.02, 0.04), 4))
    shoe, cased, opened = round(draw.uniform(0.2, 0.6) * depth, 0), round(draw.uniform(0.12, 0.25), 2), round(draw.uniform(0.2, 0.36), 2)
    mud = {'density': round(draw.uniform(1030.0, 1700.0), -1)}
    if draw.random() < 0.5:
        mud['viscosity'] = round(draw.uniform(0.005, 0.06), 3)
    start = {'block_height': 20.0}
    start.update({'weight_on_bit': weight} if weight else {'bit_depth': round(depth - off, 2)})
    scene = {'name': 'random_%s_%s' % (seed, number),
             'well': {'stations': path.stations, 'hole_depth': depth,
                      'sections': [{'to': shoe, 'diameter': size['hole'] + 0.0065, 'friction': cased}, {'to': depth, 'diameter': size['hole'], 'friction': opened}]},
             'formation': [{'to_tvd': 20000.0, 'drillability': float('%.2g' % (1e-9 * math.exp(draw.uniform(1.0, 3.0))))}], 'mud': mud, 'string': parts,
             'rig': {'hoisting': {'max_hook_load': 5.0e6}}, 'start': start, 'program': lines}
    return '# %s %.0f m, %.1f in hole, %s; %s; for %.0f s' % (kind, depth, size['hole'] / 0.0254, words, what, math.ceil(seconds)), scene
