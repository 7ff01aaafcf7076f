#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The page of `drill web` in headless Chromium beside a node: numbers, units, control and its dead-man, autodriller, the node killed and back."""
import collections
import os
import re
import signal
import tempfile

import rosbag
from browser import (PROGRAMS, Bridge, Page, blank_charts, chrome, hung, on_paper, paper, picture, processes_below, processor_time, renderers_of,
                     resize)
from drill_rig_sim.msg import RigState
from rig_test import PACKAGE_DIR, Rig, needs, rospy, run, time, unittest, wait_until
from rosgraph import Master
from situations import Situations, look
from xmlrpc.client import ServerProxy

KEPT = 1000             # messages of rig_state
KLBF = 4448.2216152605  # [N]
BRAKE_AT_LAST = 3.0     # by the bridge's clock after a page's last order, on a loaded machine; test_web_server.py holds the bound itself [s]


def lost(link):
    """Whether the page's link says that the node is not there."""
    return link.startswith(("no node publishes /rig/rig_state", "no data for", "waiting for the node"))


def seconds_of(clock):
    """Of the page's clock, as 0:01:02 at 1.0×."""
    hours, minutes, seconds = re.match(r"(\d+):(\d+):(\d+)", clock).groups()
    return 3600 * int(hours) + 60 * int(minutes) + int(seconds)


class Web(Situations, unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        if not os.environ.get("DRILL_RIG_SIM_BROWSER"):
            raise unittest.SkipTest("the page in Chromium is tested by ./test/run --browser")
        try:
            needs(cls("test_numbers"), *PROGRAMS)
            import selenium  # noqa: F401  pylint: disable=unused-import
            import aiohttp  # noqa: F401  pylint: disable=unused-import
        except ImportError as missing:
            raise unittest.SkipTest("%s is not installed: ./test/run --browser" % missing.name) from missing
        cls.rig = Rig()
        cls.states = collections.deque(maxlen=KEPT)
        rospy.Subscriber("/rig/rig_state", RigState, cls.states.append, tcp_nodelay=True)
        cls.bridge = Bridge("--control")
        cls.browser = chrome()

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()
        cls.bridge.close()

    def setUp(self):
        resize(self.browser, 1280, 800)
        self.page = Page(self.browser, self.bridge.address)
        self.page.wait_text("#link", "^running$")
        self.page.errors()  # those of the test before count no more

    def state(self):
        """The latest."""
        wait_until(lambda: self.states, "rig_state")
        return self.states[-1]

    def states_of_next(self, seconds):
        """Those of so much simulated time from now on."""
        begin = self.state().header.stamp
        wait_until(lambda: (self.state().header.stamp - begin).to_sec() > seconds, "%g s" % seconds)
        return [state for state in tuple(self.states) if state.header.stamp > begin]

    def test_numbers(self):
        state = self.state()
        wait_until(lambda: self.page.figure("hook_load") is not None, "a hook load")
        self.assertAlmostEqual(self.page.figure("hook_load"), 1e-3 * state.hook_load, delta=15.0)
        self.assertAlmostEqual(self.page.figure("bit_depth"), state.bit_depth, delta=0.02)
        self.assertIn("set", self.page.text("#number_rpm"))
        wait_until(lambda: self.page.coloured("#time_log .track:nth-child(3) canvas") > 1000, "curves of the time log")
        self.assertEqual([], self.page.errors())

    def test_every_sheet_is_drawn(self):
        for name in ("time_log", "depth_log", "well", "string", "broomstick", "tally", "slides", "alarm_log"):
            self.page.click("#tab_" + name)
            self.assertTrue(self.page.one("#" + name).is_displayed(), name)
        self.page.click("#tab_well")
        wait_until(lambda: self.page.coloured("#well canvas") > 500, "the well")
        self.page.click("#tab_string")
        self.page.wait_text("#string_summary", "simulated values along the string")
        self.page.click("#tab_broomstick")
        self.page.click("#work_out")
        self.page.wait_text("#broomstick_status", "Thick: friction of the scene")
        self.assertEqual([], self.page.errors())

    def test_units(self):
        wait_until(lambda: self.page.figure("hook_load") is not None, "a hook load")
        self.page.click("#units")
        self.page.wait_text("#number_hook_load .unit", "klbf")
        wait_until(lambda: abs(self.page.figure("hook_load") * KLBF - self.state().hook_load) < 15e3, "the hook load in klbf")
        self.assertEqual("psi", self.page.text("#number_pressure .unit"))
        self.assertEqual("Block speed [ft/min]", self.page.text("label:has(#set_block_speed)"))
        self.assertEqual("19.7", self.page.one("#set_block_speed").get_attribute("value"))  # 0.1 m/s
        self.page.fill("#set_block_speed", "39.4")
        self.assertEqual([], self.page.cut("#numbers"))
        picture(self.browser, "web_oilfield_1280")
        self.page.click("#units")
        self.page.wait_text("#number_hook_load .unit", "kN")
        self.assertEqual("0.200", self.page.one("#set_block_speed").get_attribute("value"))  # what was edited stays the same speed
        self.assertEqual([], self.page.cut("#numbers"))

    def mouse(self):
        from selenium.webdriver import ActionChains
        return ActionChains(self.browser)

    def press(self, button):
        self.mouse().release().click_and_hold(self.page.one(button)).perform()

    def test_the_block_moves_while_the_button_is_held(self):
        """On a loaded machine the dead-man may end a press before the block has moved so far: then it is pressed again."""
        before = self.state().block_height

        def held():
            if "held" not in self.page.one("#raise").get_attribute("class"):
                self.press("#raise")
            return self.state().block_height > before + 0.05
        wait_until(held, "the block moves up")
        self.mouse().release().perform()
        wait_until(lambda: self.state().brake_set, "the brake")

    def press_and_hang(self, renderers):
        """Whether the block moved while the page hung with its button held; the brake is set then. The page is not asked for anything between press
        and hang: on a loaded machine it answers later than the dead-man ends the press."""
        self.browser.execute_script("document.querySelector('#answer').textContent = ''")
        self.press("#raise")
        with hung(renderers):
            states = self.states_of_next(BRAKE_AT_LAST)
            wait_until(lambda: self.state().brake_set, "the brake")
        return any(not state.brake_set for state in states)

    def test_dead_man(self):
        """The brake is set while a page hangs with its button held, and stays when the page comes back. How long it takes is the bridge's word."""
        renderers = renderers_of(self.browser)
        self.page.remember("#answer")  # a page that hangs for long is sent another text soon after
        wait_until(lambda: self.press_and_hang(renderers), "a page that hangs while the block moves")
        pattern = r"brake set ([\d.]+) s after the page's last command"
        said = wait_until(lambda: next(filter(None, (re.search(pattern, text) for text, _, _ in self.page.remembered())), None), pattern)
        self.assertLess(float(said.group(1)), BRAKE_AT_LAST)
        self.assertTrue(all(state.brake_set for state in self.states_of_next(1.0)), "the block moves again by a press that had ended")
        self.mouse().release().perform()

    def test_set_points_follow_until_they_are_edited(self):
        self.page.click("#set_rpm")
        self.page.fill("#set_rpm", "45")
        self.assertIn("edited", self.page.one("#set_rpm").get_attribute("class"))
        self.assertNotAlmostEqual(self.state().top_drive.speed, 4.71, delta=0.1)
        self.page.one("#set_rpm").send_keys("\ue007")
        wait_until(lambda: abs(self.state().top_drive.speed - 4.712) < 0.01, "45 rpm in force")
        self.page.wait_text("#number_rpm", "set 45.0")
        self.page.fill("#set_rpm", "99")
        self.page.one("#set_rpm").send_keys("\ue00c")
        wait_until(lambda: self.page.one("#set_rpm").get_attribute("value") == "45.0", "Escape takes back")

    def test_autodriller(self):
        self.page.click("#speed_5")
        for name, text in (("weight", "60"), ("rop", "40"), ("rpm", "60"), ("flow", "1800"), ("to_depth", "1010")):
            self.page.fill("#set_law_" + name, text)
        self.page.click("#start_law")
        self.page.wait_text("#law_status", "^(?!stopped)")
        wait_until(lambda: abs(self.state().top_drive.speed - 6.283) < 0.01, "the law's rotary speed")
        wait_until(lambda: abs(self.state().mud_pump.flow - 0.03) < 1e-4, "the law's flow")
        self.page.wait_text("#law_status", "drilling, .* leads", 600.0)
        self.page.click("#tab_time_log")
        look(self.page, "drilling")
        self.page.fill("#set_law_rpm", "70")
        self.page.click("#set_law")
        wait_until(lambda: abs(self.state().top_drive.speed - 7.33) < 0.01, "the law follows")
        self.pictures()
        self.look_at_a_stall()
        self.page.click("#stop_law")
        self.page.wait_text("#law_status", "stopped")
        wait_until(lambda: self.state().brake_set, "the brake")
        self.page.click("#speed_1")

    def pictures(self):
        """While it drills: screens that a person has to look at."""
        for width, height, theme in ((1280, 800, "dark"), (1920, 1080, "light"), (390, 844, "light")):
            resize(self.browser, width, height, mobile=width < 500)
            while self.page.text("#theme") != theme:
                self.page.click("#theme")
            for sheet in ("time_log", "depth_log", "well", "string"):
                self.page.click("#tab_" + sheet)
                picture(self.browser, "web_%s_%s_%d" % (sheet, theme, width))
        resize(self.browser, 1280, 800)
        self.page.click("#tab_time_log")
        if os.environ.get("UPDATE_README") == "1":
            picture(self.browser, "web", os.path.join(PACKAGE_DIR, "src", "tools", "pictures"))
        with on_paper(self.browser):
            self.assertEqual([], blank_charts(self.browser))
        pdf = paper(self.browser)
        self.assertTrue(pdf.startswith(b"%PDF"))
        if os.environ.get("DRILL_RIG_SIM_PICTURES"):
            with open(os.path.join(os.environ["DRILL_RIG_SIM_PICTURES"], "web_print.pdf"), "wb") as out:
                out.write(pdf)

    def test_a_wrong_token_is_refused(self):
        self.browser.get(self.bridge.address[:-3] + "/")
        self.assertIn("no valid token", self.browser.find_element("css selector", "body").text)
        self.assertEqual(["403"], [re.search(r"status of (\d+)", one).group(1) for one in self.page.errors()])

    def test_node_killed_and_back(self):
        """What stands on the page after the node's end is never shown as the present, however soon another node comes."""
        self.page.click("#speed_20")
        wait_until(lambda: seconds_of(self.page.text("#clock")) > 60, "a minute: no new node is so old when it is seen first")
        before = seconds_of(self.page.text("#clock"))
        self.page.remember("#link")
        process = ServerProxy(Master(rospy.get_name()).lookupNode("/rig/rig_simulator")).getPid(rospy.get_name())[2]
        os.kill(process, signal.SIGKILL)
        wait_until(lambda: any(lost(text) for text, _, _ in self.page.remembered()), "the page has noticed")
        picture(self.browser, "web_killed")
        wait_until(lambda: self.page.remembered()[-1][0] == "running", "numbers again")
        seen = self.page.remembered()
        gone = next(n for n, (text, _, _) in enumerate(seen) if lost(text))
        back = next(n for n in range(gone, len(seen)) if seen[n][0] == "running")
        self.assertTrue(all("stale" in classes for _, classes, _ in seen[gone:back]), seen)
        self.assertNotIn("stale", seen[back][1])
        self.assertLess(seconds_of(seen[back][2]), before, "the old node's numbers are shown as the present")

    def test_a_bag(self):
        wait_until(lambda: len(self.states) > 100, "readings")
        states = tuple(self.states)
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "run.bag")
            with rosbag.Bag(file, "w") as bag:
                for state in states:
                    bag.write("/rig/rig_state", state, state.header.stamp)
            bridge = Bridge(file)
            try:
                page = Page(self.browser, bridge.address)
                page.wait_text("#link", "^recorded$")
                self.assertAlmostEqual(page.figure("hook_load"), 1e-3 * states[-1].hook_load, delta=0.06)
                self.assertFalse(page.one("#control").is_displayed())
                self.assertEqual([], page.errors())
            finally:
                bridge.close()

    def test_twenty_times_real_time(self):
        """Processor time of drill web and of Chromium by simulated time, which tests beside change little; on an idle machine it is less."""
        self.page.click("#speed_20")
        time.sleep(3.0)
        browsers = processes_below(self.browser.service.process.pid)
        begin, bridge, browser = self.state().header.stamp, processor_time(self.bridge.process.pid), sum(map(processor_time, browsers))
        time.sleep(15.0)
        simulated = (self.state().header.stamp - begin).to_sec()
        shares = [20.0 * spent / simulated for spent in (processor_time(self.bridge.process.pid) - bridge, sum(map(processor_time, browsers)) - browser)]
        print("20 simulated seconds a second: drill web %.0f %% of a core, Chromium %.0f %%; simulated %.1f times real time; redraws of the page a second: %d" % (
            100.0 * shares[0], 100.0 * shares[1], simulated / 15.0, self.browser.execute_async_script("""
            const done = arguments[0], begin = performance.now(); let n = 0;
            requestAnimationFrame(function count(now) { n++; now - begin < 1000 ? requestAnimationFrame(count) : done(n); });""")), flush=True)
        self.page.click("#speed_1")
        self.assertLess(shares[0], 0.25)
        self.assertEqual([], self.page.errors())


if __name__ == "__main__":
    run(Web)
