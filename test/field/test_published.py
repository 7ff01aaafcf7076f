#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Published records of other rigs are read as they are and replayed: see README.md. Skipped where they are absent."""
import datetime
import os
import sys
import tempfile
import unittest

import numpy
import yaml
from drill_rig_sim.field.models import scene_and_survey
from drill_rig_sim.field.record import read_record
from drill_rig_sim.field.replay import play
from drill_rig_sim.field.start import simulator_of, start_keys
from drill_rig_sim.field.window import between

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "../tool")]
import skips  # noqa: E402

FOLDER = os.environ.get("DRILL_RIG_SIM_RECORDS", os.path.join(HERE, "../../../shared/data/records"))
FT, KGF, KLBF, PSI, GALLON, RPM = 0.3048, 9.80665, 4448.2216152605, 6894.757293168, 3.785411784e-3, numpy.pi / 30.0
REPLAYED = 10.0  # [s]


def published(name):
    return os.path.join(FOLDER, name)


def absent(name):
    return unittest.skipUnless(os.path.isfile(published(name)), "%s is absent" % name)


def begin(*date):
    return datetime.datetime(*date, tzinfo=datetime.timezone.utc).timestamp()


class Published(unittest.TestCase):
    def rows(self, record, **expected):
        """The first rows of signals, as they were read by eye [SI]."""
        for signal, values in expected.items():
            numpy.testing.assert_allclose(record.signals[signal][:len(values)], values, rtol=1e-9, err_msg=signal)

    def replayed(self, record):
        """In a long vertical hole: what is off is a number."""
        with open(os.path.join(HERE, "hoist.yaml"), encoding="utf-8") as text:
            scene = yaml.safe_load(text)
        scene["string"] = [part for part in scene["string"] if part["name"] != "tubing"]
        scene["well"] = {"stations": [[0, 0, 0], [5000, 0, 0]], "sections": [{"to": 5000, "diameter": 0.2168, "friction": 0.25}]}
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "scene.yaml")
            with open(path, "w", encoding="utf-8") as out:
                yaml.safe_dump(scene, out)
            text, survey = scene_and_survey(path)
            part = between(record, 0.0, REPLAYED)
            found = play(simulator_of(path, text, survey, start_keys(text, part, "record")[0]), part).table()
        self.assertEqual({"hook_load", "torque", "stand_pipe_pressure"}, set(found))
        self.assertTrue(all(numpy.isfinite(row["rms"]) for row in found.values()), found)

    @absent("TSPP1.csv")
    def test_units_after_a_blank(self):
        record = read_record(published("TSPP1.csv"))
        self.assertEqual(begin(2007, 7, 6, 19, 23, 52), record.begin)
        self.rows(record, time=[0.0, 4.0, 8.0, 12.0], hook_load=[KGF * 105976.3008, KGF * 105943.5287], block_height=[40.6752552, 40.6600152],
                  top_drive_speed=[RPM * 89.0] * 2, torque=[4.745363, 5.423272], bit_depth=[376.0195299, 376.0347318], hole_depth=[376.0792707, 376.0859382],
                  stand_pipe_pressure=[407844.7163, 408119.6448], flow=[2.96874343 / 60.0] * 2)
        self.replayed(record)

    @absent("2019_0301_05.wts.csv")
    def test_rows_of_a_gas_detector(self):
        record = read_record(published("2019_0301_05.wts.csv"), os.path.join(HERE, "mud_logger.yaml"))
        self.assertEqual(begin(2019, 3, 1, 5, 12, 47), record.begin)
        self.rows(record, time=[0.0, 1.0, 2.0, 3.0, 4.0, 5.0], hook_load=[KLBF * 307.154615625, KLBF * 306.85524375, KLBF * 306.45608125],
                  block_height=[16.7800006866455, 16.75, 16.75, 16.7299995422363], top_drive_speed=[RPM * 93.0000042915344],
                  torque=[FT * 1e-3 * KLBF * 3242.68758789062, FT * 1e-3 * KLBF * 3845.67485351562], bit_depth=[3779.30004882813] * 5 + [3779.39990234375],
                  hole_depth=[3883.19995117188], stand_pipe_pressure=[PSI * 949.73115], flow=[GALLON / 60.0 * 312.012398056686])
        self.assertIn("rows hold none of the signals and are left out (first: ", "\n".join(record.remarks))
        self.replayed(record)


if __name__ == "__main__":
    skips.main()
