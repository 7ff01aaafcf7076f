#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What drill replay says before and while it plays a record: its progress, and connections that cannot be found."""
import io
import os
import unittest
from contextlib import redirect_stderr

import numpy
from drill_rig_sim import replay_command
from drill_rig_sim.field.pipe import standstills
from drill_rig_sim.field.record import RecordError, read_record
from drill_rig_sim.field.replay import check, play
from drill_rig_sim.field.start import simulator_of
from drill_rig_sim.sim import Simulator
from in_folder import InFolder

QUICK = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))), "config/scenes/quick.yaml")


class Said(InFolder):
    def test_progress_is_shown_on_a_terminal(self):
        class Terminal(io.StringIO):
            def isatty(self):
                return True
        for stream, said in ((Terminal(), "drill replay: 100 of 400 s played, 11 s, about 33 s left\n"), (io.StringIO(), "")):
            progress = replay_command.Progress()
            progress.began = progress.printed = progress.printed - 11.0
            with redirect_stderr(stream):
                progress(100.0, 400.0)
                progress(101.0, 400.0)
            self.assertEqual(said, stream.getvalue())
        seen = []
        play(Simulator(QUICK), read_record(self.file("still.csv", "time,reading_block_height,reading_hook_load\n0,20,2e5\n2,20,2e5\n")), tell=lambda done, whole: seen.append((done, whole)))
        self.assertEqual(sorted(seen), seen)
        self.assertAlmostEqual(seen[-1][1], seen[-1][0], delta=0.2)

    def test_a_scene_in_the_place_of_the_record_is_refused(self):
        with self.assertRaisesRegex(RecordError, r"quick\.yaml: is YAML, .* needed: the record before the scene"):
            read_record(QUICK)

    def test_remarks_name_the_scene_that_was_given(self):
        """Not the file that holds it with the start of the record."""
        with open(QUICK, encoding="utf-8") as text:
            scene = text.read().replace("hole_depth: 100.0", "hole_depth: 110.0\n  project: straight").replace("to: 100.0", "to: 110.0")
        file = self.file("projected.yaml", scene)
        with self.assertLogs("drill_rig_sim") as logged:
            simulator_of(file, scene, None, {"start.bit_depth": 105.0})
        self.assertEqual(["%s: the survey was projected 10 m" % file], [line.getMessage().partition(" (")[0] for line in logged.records])

    def test_connections_without_a_bit_depth_are_refused(self):
        """The block pulls a stand, comes back empty and pulls the next one."""
        columns = self.file("m.yaml", "time: {column: t, unit: s}\nblock_height: {column: b, unit: m}\nhook_load: {column: h, unit: kN}\n")
        moves = ((100, 0.28, 900.0), (30, 0.0, 200.0), (40, -0.7, 200.0), (100, 0.28, 900.0))
        rows = [(speed, load) for seconds, speed, load in moves for _ in range(seconds)]
        heights = numpy.concatenate(([2.0], 2.0 + numpy.cumsum([speed for speed, _ in rows])))
        for empty, refused in ((200.0, True), (600.0, False)):
            text = "".join("%d,%.3f,%g\n" % (k, heights[k], empty if load == 200.0 else load) for k, (_, load) in enumerate(rows))
            record = read_record(self.file("pulled.csv", "t,b,h\n" + text), columns)
            if refused:
                with self.assertRaisesRegex(RecordError, r"has no bit_depth, and the block moves by 2[78]\.. m with less than half of the usual hook load \(first: at 13"):
                    check(record)
            else:
                check(record)

    def test_gaps(self):
        """Each is played through; one line says how many there are and how."""
        for missing, said, played in (((), [], []), ((range(40, 60),), ["a gap of 21 s from 39 s on"], ["1 gaps, 21 s in all: block"]),
                                      ((range(10, 20), range(40, 60)), ["a gap of 21 s from 39 s on, the longest of 2, of 32 s in all"], ["2 gaps, 32 s in all: block"])):
            rows = [k for k in range(80) if not any(k in part for part in missing)]
            record = read_record(self.file("g.csv", "time,reading_block_height,reading_hook_load\n" + "".join("%d,20,2e5\n" % k for k in rows)))
            self.assertEqual(said, [line.partition(": ")[2] for line in record.remarks if "gap" in line])
            lines = [line.partition(": ")[2] for line in play(Simulator(QUICK), record).remarks if "straight lines" in line]
            self.assertEqual(played, [line[:len(played[0])] for line in lines])

    def test_pipe_that_is_moved_in_a_gap_is_refused(self):
        columns = self.file("m.yaml", "time: {column: t, unit: s}\nblock_height: {column: b, unit: m}\nhook_load: {column: h, unit: kN}\nbit_depth: {column: d, unit: m}\n")
        rows = [(5 * k + 200 * (k > 20), 20.0 - 8.0 * (k > 20), 900.0, 1000.0 - 6.0 * (k > 20)) for k in range(40)]
        text = "t,b,h,d\n" + "".join("%g,%g,%g,%g\n" % row for row in rows)
        record = read_record(self.file("gap.csv", text), columns)
        with self.assertRaisesRegex(RecordError, r"at 305.0 s bit_depth jumps by -6.00 m, in a gap of 205 s in which pipe was moved, added or removed; needed: a part of the record before or after it"):
            standstills(record)
        self.assertEqual([], standstills(record, in_parts=True))


if __name__ == "__main__":
    unittest.main()
