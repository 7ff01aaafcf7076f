# SPDX-License-Identifier: BSD-3-Clause
"""Situations of a driller on the page of `drill web`: each with what the page must show, and pictures on two screens in both systems of units."""
from browser import picture, resize
from drill_rig_sim.msg import WinchCommand
from drill_rig_sim.srv import InjectFaultRequest
from rig_test import wait_until, winch

SCREENS = ((1280, 800), (1920, 1080))
STUCK_AT = 900.0  # [m]


def look(page, name):
    """Pictures that a person has to look at, of what is seen now; nothing may be cut off."""
    for width, height in SCREENS:
        resize(page.browser, width, height)
        for units in ("si", "oilfield"):
            picture(page.browser, "web_%s_%d_%s" % (name, width, units))
            cut = page.cut("#numbers") + page.cut("#alarms")
            if cut:
                raise AssertionError("%s, %d pixels, %s: not shown whole: %s" % (name, width, units, cut))
            page.click("#units")
    resize(page.browser, *SCREENS[0])


class Situations:
    """For a test of the page: `page`, `browser`, `rig`, and `state()`."""

    def fault(self, kind, clear=False, depth=0.0):
        self.rig.must(self.rig.inject_fault(fault=kind, clear=clear, depth=depth))

    def test_a_connection(self):
        self.page.click("#tare")
        self.page.wait_text("#answer", "tare: ")
        stands = self.state().stand_count
        self.page.click("#connection")
        self.browser.switch_to.alert.accept()
        self.page.wait_text("#law_status", "^connection: ")
        wait_until(lambda: self.state().in_slips, "the slips")
        self.page.wait_text("#number_wob .figure", "^–$")
        self.assertEqual("–", self.page.text("#number_pressure .below").split()[1])
        look(self.page, "connection")
        self.page.click("#speed_20")
        self.page.wait_text("#law_status", "stopped|given up", 600.0)
        self.assertEqual((stands + 1, False), (self.state().stand_count, self.state().in_slips))
        self.page.click("#speed_1")
        self.page.click("#tab_tally")
        self.page.wait_text("#connections", "1")
        look(self.page, "tally")

    def test_a_stuck_pipe_is_pulled(self):
        self.page.click("#tare")
        self.page.wait_text("#answer", "tare: ")
        self.fault(InjectFaultRequest.STUCK_PIPE, depth=STUCK_AT)
        self.page.click("#tab_time_log")
        pull = self.rig.publisher("winch/command", WinchCommand)
        try:
            before = self.state().hook_load

            def is_pulled():
                pull.publish(winch(0.02))
                return self.state().hook_load > before + 1.5e5
            wait_until(is_pulled, "an over-pull")
            pull.publish(winch(0.0, brake=True))
            self.page.wait_text("#number_wob .label", "^Over-pull")
            self.page.wait_text("#number_wob .figure", r"^\d{3}")  # kN: the page shows the pull's end, not its beginning
            self.page.wait_text("#number_wob .below", "to yield")
            look(self.page, "over_pull")

            def is_slack():
                pull.publish(winch(-0.02))
                return self.state().hook_load < before
            wait_until(is_slack, "the string hangs as before")
        finally:
            pull.publish(winch(0.0, brake=True))
            self.fault(InjectFaultRequest.STUCK_PIPE, clear=True)

    def look_at_a_stall(self):
        """While it drills."""
        self.fault(InjectFaultRequest.MOTOR_STALL)
        self.page.wait_text("#alarms", "[Mm]otor stalled")
        look(self.page, "stall")
        self.fault(InjectFaultRequest.MOTOR_STALL, clear=True)
        self.page.click("#tab_alarm_log")
        look(self.page, "alarms")
        self.page.click("#tab_time_log")
