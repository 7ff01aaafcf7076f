# SPDX-License-Identifier: BSD-3-Clause
"""The cells of the operations matrix: wells, strings, what is done with them. A cell is one scene.

Wells are ordinary, not chosen for what the simulator does well; operations are those of a day on the rig, with their usual speeds.
"""

import math


def arc(md_from, inclination_from, md_to, inclination_to, azimuth=0.0):
    """Stations of a constant build, 30 m apart at most."""
    pieces = max(1, round((md_to - md_from) / 30.0))
    return [[md_from + (md_to - md_from) * k / pieces, inclination_from + (inclination_to - inclination_from) * k / pieces, azimuth]
            for k in range(pieces + 1)]


class Well:
    def __init__(self, stations, depth, cased):
        self.stations = stations
        self.depth = depth
        self.cased = cased  # down to here friction is that of casing [m]


WELLS = {
    'vertical 1 km': Well([[0, 0, 0], [1000, 0, 0]], 1000.0, 300.0),
    'J 2 km': Well([[0, 0, 0]] + arc(400, 0, 1000, 60) + [[2000, 60, 0]], 2000.0, 1000.0),
    'S 2 km': Well([[0, 0, 0]] + arc(300, 0, 700, 40) + arc(1300, 40, 1650, 5) + [[2000, 5, 0]], 2000.0, 700.0),
    'horizontal 1.2 km': Well([[0, 0, 0]] + arc(100, 0, 370, 90) + [[1200, 90, 0]], 1200.0, 370.0),
    'horizontal 3 km': Well([[0, 0, 0]] + arc(1000, 0, 1600, 90) + [[3000, 90, 0]], 3000.0, 1600.0),
    'extended 5 km': Well([[0, 0, 0]] + arc(300, 0, 1100, 80) + [[5000, 80, 0]], 5000.0, 1500.0),
}


def pipe(name, outer, inner, mass, tool_joint, joints='fill', joint=9.5):
    return {'name': name, 'type': 'pipe', 'joints': joints, 'joint_length': joint, 'outer_diameter': outer, 'inner_diameter': inner,
            'linear_mass': mass, 'tool_joint_diameter': tool_joint}


def collar(outer, inner, mass, joints=2):
    return {'name': 'collar', 'type': 'collar', 'joints': joints, 'joint_length': 9.4, 'outer_diameter': outer, 'inner_diameter': inner, 'linear_mass': mass}


def bit(diameter):
    return {'name': 'bit', 'type': 'bit', 'length': 0.3, 'mass': 40.0, 'diameter': diameter, 'side_cutting': 0.02,
            'torque': {'static': 0.5, 'kinetic': 0.4}}


MOTOR = [{'name': 'motor', 'type': 'mud_motor', 'length': 7.6, 'outer_diameter': 0.1715, 'inner_diameter': 0.1, 'linear_mass': 140.0,
          'bend_deg': 1.15, 'bit_to_bend': 1.8, 'displacement_per_rev': 0.014, 'stall_torque': 9000.0},
         {'name': 'stabilizer', 'type': 'stabilizer', 'length': 1.5, 'outer_diameter': 0.1651, 'inner_diameter': 0.0714, 'linear_mass': 150.0,
          'blade_diameter': 0.2127}]
STRINGS = {
    '5 in': (0.2159, [bit(0.2159), collar(0.1651, 0.0714, 136.0), pipe('drill_pipe', 0.127, 0.1086, 31.9, 0.168)]),
    '5 in, motor': (0.2159, [bit(0.2159)] + MOTOR + [collar(0.1651, 0.0714, 136.0, 1), pipe('drill_pipe', 0.127, 0.1086, 31.9, 0.168)]),
    '5 1/2 in': (0.2159, [bit(0.2159), collar(0.1651, 0.0714, 136.0), pipe('drill_pipe', 0.1397, 0.1214, 38.0, 0.178)]),
    # 4 in in the lower part of a 6 1/8 in hole, 5 in in the casing above
    '4 in': (0.1556, [bit(0.1556), collar(0.1207, 0.0571, 70.0), pipe('slim_pipe', 0.1016, 0.0848, 23.0, 0.133, 60),
                      pipe('drill_pipe', 0.127, 0.1086, 31.9, 0.168)]),
}
# Drag of a mud of 20 mPa s on pipe that vibrates at 4 Hz: the shear layer sqrt(2 nu/w) is 1.2 mm thick, so pi (D_o + D_i) sqrt(rho mu w/2) = 12.8 N s/m
# per m along the pipe, and times the radius squared, 0.05 N m s/rad per m, about it; 0.02 in steady turning.
MUD = {'density': 1200.0, 'axial_damping': 12.0, 'lateral_damping': 20.0, 'torsional_damping': 0.02}
CONTACT = {'stribeck_speed': 0.05}
DRILLABILITY = 1.0e-8  # 1.8 to 11 m/h at 20 to 60 kN and 14 rad/s


class Operation:
    """`program`: lines of the scene's program; `stuck_at` from the well's depth [m]. `off`: how far the bit begins off bottom [m]; `weight`: on bottom with this on bit [N].
    `irregular`: from when to when statistics are compared [s]; what comes after them, which hangs on where in its slip the string was stopped, is
    not. `slides`: the same in wells where pipe that slides sticks and slips; `bent`: with a bent motor, which knocks about as it turns.
    `layers`: how far below the bottom hard rock begins [m]. `every`: between samples [s]."""

    def __init__(self, program, duration, off=30.0, weight=None, irregular=None, slides=None, bent=None, layers=None, every=0.1):
        self.program = program
        self.duration = duration
        self.off = off
        self.weight = weight
        self.irregular, self.slides, self.bent = irregular, slides, bent
        self.layers = layers
        self.every = every


def turn(rpm, at=0.0, **more):
    return dict({'at': at, 'top_drive_speed_rpm': rpm}, **more)


def move(speed, at, **more):
    return dict({'at': at, 'block_velocity': speed}, **more)


def trip(speed, rpm):
    """Up (+) or down (-) from 5 s on (20 s if turned), over 4 m or 30 s."""
    begins = 20.0 if rpm else 5.0
    ends = begins + min(30.0, max(8.0, 4.0 / abs(speed)))
    return Operation(([turn(rpm)] if rpm else []) + [move(speed, begins), move(0.0, ends)], ends + 5.0, slides=None if rpm else (begins, ends))


ROCKING = [turn((30.0 if k % 2 == 0 else -30.0), 1.0 + 3.0 * k) for k in range(6)] + [turn(0.0, 19.0)]  # 1.5 turns each way
OPERATIONS = {
    'rotate 60': Operation([turn(60)], 30.0),
    'rotate 120': Operation([turn(120)], 30.0),
    'rotate 180': Operation([turn(180)], 30.0),
    'pick up 0.02': trip(0.02, 0), 'pick up 0.1': trip(0.1, 0), 'pick up 0.3': trip(0.3, 0),
    'slack off 0.02': trip(-0.02, 0), 'slack off 0.1': trip(-0.1, 0), 'slack off 0.3': trip(-0.3, 0),
    'pick up 0.1, 120': trip(0.1, 120), 'pick up 0.3, 120': trip(0.3, 120),
    'slack off 0.1, 120': trip(-0.1, 120), 'slack off 0.3, 120': trip(-0.3, 120),
    'reverse': Operation([move(0.1, 2.0), move(-0.1, 20.0), move(0.0, 35.0)], 40.0, slides=(2.0, 35.0)),
    'back-ream': Operation([turn(100, flow=0.03), move(0.1, 15.0)], 45.0),
    'rock': Operation(ROCKING, 25.0, slides=(1.0, 19.0), bent=(1.0, 19.0)),
    'tag 0.05': Operation([turn(60, flow=0.03), move(-0.05, 10.0), move(0.0, 32.0)], 40.0, off=1.0, irregular=(29.0, 40.0), every=0.02),
    'tag 0.3': Operation([turn(60, flow=0.03), move(-0.3, 10.0), move(0.0, 13.5)], 25.0, off=1.0, irregular=(13.3, 25.0), every=0.02),
    'drill rotating': Operation([turn(120, flow=0.03), move(-0.002, 5.0)], 60.0, weight=30e3, bent=(5.0, 60.0)),
    'drill sliding': Operation([{'at': 0.0, 'flow': 0.03}, move(-0.003, 5.0)], 60.0, weight=30e3),
    'slide 25 min': Operation([{'at': 0.0, 'flow': 0.03}, move(-0.003, 5.0)], 1500.0, weight=30e3, slides=(5.0, 1500.0), every=2.0),
    'over-feed and stall': Operation([{'at': 0.0, 'flow': 0.03}, move(-0.02, 5.0), move(0.0, 40.0)], 60.0, weight=30e3, slides=(5.0, 60.0)),
    'pump off and on': Operation([turn(100, flow=0.03), {'at': 20.0, 'flow': 0.0}, {'at': 35.0, 'flow': 0.03}], 50.0, weight=30e3, bent=(5.0, 50.0)),
    'into hard rock': Operation([turn(120, flow=0.03), move(-0.004, 5.0)], 60.0, weight=30e3, layers=0.05),
    # gripped 90 m above the bottom: 60 m above the bit
    'stuck': Operation([{'at': 2.0, 'stuck_at': -90.0}, move(0.05, 5.0), move(0.0, 11.0), {'at': 20.0, 'free': True}], 35.0, slides=(20.0, 35.0)),
    'drill off': Operation([turn(120, flow=0.03)], 60.0, weight=60e3),
}


class Cell:
    def __init__(self, well, string, operation):
        self.well, self.string, self.operation = well, string, operation
        self.name = '%s / %s / %s' % (well, string, operation)
        self.file = ''.join(c if c.isalnum() else '_' for c in self.name)

    @property
    def what(self):
        return OPERATIONS[self.operation]

    def scene(self):
        well, what = WELLS[self.well], self.what
        diameter, string = STRINGS[self.string]
        start = {'block_height': 20.0, 'bit_depth': well.depth - what.off}
        if what.weight:
            start = {'block_height': 20.0, 'weight_on_bit': what.weight}
        rock = {'drillability': DRILLABILITY}
        if what.layers:
            rock = dict(rock, to_tvd=self.tvd() + what.layers)
            layers = [rock, {'to_tvd': 10000.0, 'drillability': 0.2 * DRILLABILITY}]
        else:
            layers = [dict(rock, to_tvd=10000.0)]
        return {'name': 'cell', 'well': {'stations': well.stations, 'hole_depth': well.depth, 'sections': [
            {'to': self.cased(), 'diameter': 0.2224, 'friction': 0.2}, {'to': well.depth, 'diameter': diameter, 'friction': 0.28}]},
            'formation': layers, 'mud': MUD, 'contact': CONTACT, 'string': string,
            'rig': {'hoisting': {'max_hook_load': 4.0e6}}, 'start': start, 'program': [self.placed(line) for line in what.program]}

    def placed(self, line):
        return dict(line, stuck_at=WELLS[self.well].depth + line['stuck_at']) if 'stuck_at' in line else line

    def cased(self):
        """Down to here [m]; a slim hole begins where only the slim pipe comes."""
        well = WELLS[self.well]
        return max(well.cased, well.depth - 500.0) if self.string == '4 in' else well.cased

    def tvd(self):
        """Of the hole's bottom [m]: only wells that end straight ask, by minimum curvature within half a metre."""
        out, stations = 0.0, WELLS[self.well].stations
        for (a, i, _), (b, j, _) in zip(stations, stations[1:]):
            middle = math.radians(0.5 * (i + j))
            half = 0.5 * math.radians(j - i)
            out += (b - a) * math.cos(middle) * (math.sin(half) / half if half else 1.0)
        return out

    def length(self):
        return WELLS[self.well].depth

    def irregular(self):
        """From when to when statistics are compared [s]; None: the series are."""
        what = self.what
        bent = what.bent if 'motor' in self.string else None
        slides = None if self.well.startswith('vertical') else what.slides
        return what.irregular or bent or slides


def cells_of(wells, strings, operations):
    return [Cell(well, string, operation) for well in wells for string in strings for operation in operations]


CELLS = (
    cells_of(['vertical 1 km'], ['5 in'], ['rotate 120', 'rotate 180', 'pick up 0.3', 'slack off 0.3', 'reverse', 'tag 0.05', 'tag 0.3', 'drill rotating',
                                           'pump off and on', 'into hard rock', 'drill off', 'stuck'])
    + cells_of(['vertical 1 km'], ['5 in, motor'], ['drill sliding', 'over-feed and stall', 'rock', 'slide 25 min'])
    + cells_of(['J 2 km'], ['5 in'], ['rotate 60', 'rotate 120', 'rotate 180', 'pick up 0.02', 'pick up 0.1', 'pick up 0.3', 'slack off 0.02', 'slack off 0.1',
                                      'slack off 0.3', 'pick up 0.1, 120', 'slack off 0.1, 120', 'reverse', 'back-ream', 'rock', 'tag 0.05', 'tag 0.3',
                                      'drill rotating', 'drill off', 'stuck'])
    + cells_of(['J 2 km'], ['5 in, motor'], ['drill rotating', 'drill sliding', 'slide 25 min', 'over-feed and stall', 'pump off and on'])
    + cells_of(['J 2 km'], ['5 1/2 in'], ['rotate 120', 'rotate 180', 'pick up 0.1', 'slack off 0.1', 'pick up 0.3, 120'])
    + cells_of(['J 2 km'], ['4 in'], ['rotate 120', 'pick up 0.1', 'slack off 0.1', 'slack off 0.3', 'drill rotating'])
    + cells_of(['S 2 km'], ['5 in'], ['rotate 60', 'rotate 120', 'pick up 0.1', 'pick up 0.3', 'slack off 0.1', 'slack off 0.3', 'reverse', 'tag 0.3',
                                      'into hard rock'])
    + cells_of(['S 2 km'], ['5 in, motor'], ['drill sliding', 'slide 25 min', 'over-feed and stall'])
    + cells_of(['horizontal 1.2 km'], ['5 in'], ['rotate 60', 'rotate 120', 'rotate 180', 'pick up 0.1', 'slack off 0.1', 'slack off 0.3', 'pick up 0.1, 120',
                                                 'slack off 0.1, 120', 'slack off 0.3, 120', 'back-ream', 'rock', 'drill rotating', 'stuck'])
    + cells_of(['horizontal 1.2 km'], ['5 in, motor'], ['drill sliding', 'slide 25 min'])
    + cells_of(['horizontal 1.2 km'], ['5 1/2 in'], ['rotate 120', 'rotate 180', 'pick up 0.1, 120', 'slack off 0.1, 120', 'slack off 0.1'])
    + cells_of(['horizontal 1.2 km'], ['4 in'], ['rotate 120', 'slack off 0.1', 'slack off 0.1, 120'])
    + cells_of(['horizontal 3 km'], ['5 in'], ['rotate 60', 'rotate 120', 'pick up 0.1', 'slack off 0.1', 'pick up 0.1, 120', 'slack off 0.1, 120', 'rock',
                                               'drill rotating'])
    + cells_of(['horizontal 3 km'], ['5 in, motor'], ['drill sliding', 'slide 25 min'])
    + cells_of(['extended 5 km'], ['5 in'], ['rotate 60', 'rotate 120', 'pick up 0.1', 'slack off 0.1', 'back-ream', 'drill rotating'])
    + cells_of(['extended 5 km'], ['5 in, motor'], ['slide 25 min'])
    + cells_of(['extended 5 km'], ['5 1/2 in'], ['rotate 120', 'pick up 0.1'])
)

# Seconds each: of every kind one, in ./test/run.
FAST = {'vertical 1 km / 5 in / pick up 0.3', 'vertical 1 km / 5 in / tag 0.05', 'vertical 1 km / 5 in / pump off and on', 'horizontal 1.2 km / 5 in / rotate 120',
        'horizontal 1.2 km / 5 1/2 in / rotate 180', 'horizontal 1.2 km / 5 in / slack off 0.3, 120', 'J 2 km / 5 in / pick up 0.3'}
