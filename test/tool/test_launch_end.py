#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""How roslaunch ends with a controller: quietly where the law has reached its goal, as a node that died where it has not."""
import os
import re
import socket
import subprocess
import tempfile
import unittest

LAW = '''from drill_rig_sim.law import Commands


class Law:
    period, done, given_up = 0.1, False, ""

    def __init__(self, reason):
        self.reason = reason

    def step(self, readings):
        self.done = readings.t > 2.0
        self.given_up = self.reason if self.done else ""
        return Commands(flow=0.01)
'''
LAUNCH = '''<launch>
  <include file="$(find drill_rig_sim)/launch/rig.launch">
    <arg name="scene" value="quick.yaml"/>
    <arg name="clock" value="%(clock)s"/>
    <arg name="headless" value="true"/>
  </include>
  <node ns="rig" pkg="drill_rig_sim" type="controller.py" name="controller" output="screen" required="true">
    <param name="law" value="%(law)s"/>
    <param name="lockstep" value="%(lockstep)s"/>
    <rosparam>
      settings: %(settings)s
    </rosparam>
  </node>
</launch>
'''


def free_port():
    with socket.socket() as place:
        place.bind(('localhost', 0))
        return place.getsockname()[1]


class LaunchEnd(unittest.TestCase):
    def launched(self, lockstep, settings='{reason: ""}', law='law.py:Law'):
        """What roslaunch prints, and its exit status."""
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, 'law.py'), 'w', encoding='utf-8') as of_law:
                of_law.write(LAW)
            file = os.path.join(folder, 'law.launch')
            with open(file, 'w', encoding='utf-8') as launch:
                launch.write(LAUNCH % {'law': os.path.join(folder, law) if '.py' in law else law, 'settings': settings,
                                       'lockstep': str(lockstep).lower(), 'clock': 'lockstep' if lockstep else 'realtime'})
            port = free_port()
            done = subprocess.run(['roslaunch', '-p', str(port), file], env={**os.environ, 'ROS_MASTER_URI': 'http://localhost:%d' % port}, timeout=100,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        return done.stdout, done.returncode

    def test_a_goal_that_is_reached_ends_it_quietly(self):
        for lockstep in (True, False):
            printed, status = self.launched(lockstep)
            self.assertRegex(printed, re.compile('^done$', re.MULTILINE))
            self.assertNotIn('has died', printed)
            self.assertNotIn('\033[31m', printed)
            self.assertEqual(0, status, printed)

    def test_a_law_that_gave_up_is_reported(self):
        printed, _ = self.launched(True, '{reason: no way on}')
        self.assertIn('given up: no way on', printed)
        self.assertIn('has died', printed)

    def test_a_wrong_parameter_is_one_line(self):
        for law, settings, line in (('autodriller', '{rpm: 60}', 'parameter ~settings: Autodriller needs set_points, stiffness, rop, flow, to_depth'),
                                    ('law.py:Law', '{reson: ""}', 'parameter ~settings: Law has no reson; allowed: reason'),
                                    ('law.py:Law', 'none', "parameter ~settings is 'none'; allowed is names with values"),
                                    ('autodriler', '{}', "parameter ~law is 'autodriler'; allowed: autodriller, slide_steering")):
            printed, _ = self.launched(True, settings, law)
            self.assertIn(line, printed)
            self.assertNotRegex(printed, 'File ".*drill_rig_sim')  # Debian 11's rospy prints a traceback of its own at the end of a process


if __name__ == '__main__':
    unittest.main()
