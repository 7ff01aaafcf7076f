# SPDX-License-Identifier: BSD-3-Clause
"""A feed of rows that drives a simulated rig while it comes, as field.follow and field.replay do with a whole record."""
import numpy
from drill_rig_sim.control import Deaf, Readings, asked, frames_of, hand_over
from drill_rig_sim.field.follow import Connection, Follow
from drill_rig_sim.field.pipe import STILL, Standstill, check_directions, check_scale, compared, pipe_events, run
from drill_rig_sim.field.record import COMPARED, Record, RecordError, long_step
from drill_rig_sim.field.replay import LONGEST_GAP, Warnings
from drill_rig_sim.units import GRAVITY

SHOWN = COMPARED + ("bit_depth",)  # with residuals
LAG = 4      # rows that the simulation is behind: by these the way of the block between two rows is known
FIRST = 6    # rows before it begins
KEPT = 60    # rows before the present one that are kept
MOST_REFUSED = 20  # rows on end, after which the feed is given up
UNSURE = 10  # rows after which a step of the bit's depth without the block is a slip, if the bit stands
NEEDED = ("block_height", "bit_depth")  # in every row


class Rows(Record):
    """The last rows of a feed as a record whose time begins at `base`."""

    def __init__(self, name, rows, base):  # pylint: disable=super-init-not-called
        self.name, self.begin, self.offset, self.remarks = name, None, 0.0, []
        names = list(dict.fromkeys(signal for row in rows for signal in row.values))
        columns = {signal: numpy.array([row.values.get(signal, numpy.nan) for row in rows]) for signal in names}
        self.signals = {"time": numpy.array([row.time for row in rows]), **{signal: values for signal, values in columns.items() if numpy.isfinite(values).any()}}
        self.time = self.signals["time"] - base


class FeedFollow(Follow):
    """Follows a record that grows, whose first rows are later cut off, while the block moves. `apart`: of the bit, simulated less recorded, but for slips of the depth tracking [m]."""

    from_rest = False

    def __init__(self, record, rig, say):
        self.say, self.passed, self.played = say, set(), -numpy.inf
        self.apart = rig.state.bit_depth - float(record.at("bit_depth", record.time[0]))
        super().__init__(record, rig)
        self.begin = rig.drum_height - self.course[0]

    def take(self, record):
        super().take(record)
        self.depths = record.at("bit_depth", self.times)

    def connections_in(self, record):
        """Those that are still to be made; what is no whole number of joints is reported and not made."""
        found = []
        for still in self.stands:
            when = record.signals["time"][still.left]
            if still.end == len(record.time) - 1 or when <= self.played:
                continue  # not finished, or made
            try:
                doing = still.connection(self.rig.joint_length)
            except ValueError as error:
                if when not in self.passed:
                    self.say("at %.1f s %s: not made" % (when, error))
                    self.passed.add(when)
                    self.apart -= still.length
                continue
            if doing is not None:
                found.append(Connection(int(round(record.time[still.left] / self.period)), int(round(record.time[still.back] / self.period)), doing))
                found[-1].when = when
        return found

    def depth_after(self, readings, connection):
        self.played = connection.when
        self.say("connection at %.1f s: %s" % (connection.when, connection))
        return self.depths[connection.back] + self.apart

    def shift(self, record, cut, periods):
        """Goes on with a record that begins `cut` rows and `periods` steps later."""
        height = self.heights[cut]
        self.k -= periods
        self.take(record)
        self.begin += height - self.heights[0]
        self.clock.clear()


class Live:
    """The simulation behind a feed. `rows`: the first of it, `name`: of the feed, `say(text)`: a line on what is reported, `show(time, row)`: of each row that was
    played, its time since the first [s] and by signal measured and simulated value [SI]; measured nan where the rows cannot be compared."""

    def __init__(self, name, rig, rows, say, show):
        self.name, self.rig, self.say, self.show = name, rig, say, show
        self.rows, self.base, self.shown, self.refused = rows, 0.0, 0, 0
        self.times, self.values, self.slips = [0.0], [self.readings()], {}
        self.law, self.answer, self.warnings = FeedFollow(self.record(rows), rig, say), "", Warnings()
        self.every = frames_of(self.law.period, rig.rate)
        self.hold = numpy.inf  # the simulation waits there until the rows say what is done with the pipe [s]
        self.look(self.record(rows))

    def record(self, rows):
        return Rows(self.name, rows, self.base)

    def readings(self):
        return [getattr(self.rig.state, signal) for signal in SHOWN]

    def take(self, row):
        """The next row; what can be played with it is played. RecordError where the feed makes no sense for long."""
        why = self.why_not(row)
        if why:
            self.say("%s is refused: %s" % (row.place, why))
            self.refused += row.time != self.rows[-1].time  # clocks of whole seconds repeat theirs
            if self.refused >= MOST_REFUSED:
                raise RecordError("%s: %d rows in sequence were refused; last: %s: %s" % (self.name, self.refused, row.place, why))
            return
        self.refused = 0
        record = self.record(self.rows)
        if row.time - self.rows[-1].time > long_step(record.time):
            self.say("a gap of %.4g s from %.1f s on: bridged by straight lines" % (row.time - self.rows[-1].time, self.rows[-1].time))
        self.rows.append(row)
        record = self.record(self.rows)
        self.law.take(record)
        self.look(record)
        self.play(self.rows[-1 - LAG].time)
        self.forget()

    def why_not(self, row):
        """Why a row cannot be; "" where it can."""
        last = self.rows[-1].time
        if not last < row.time <= last + LONGEST_GAP:
            return "its time is %.9g s, that of the row before %.9g s; needed: later by up to a day" % (row.time, last)
        missing = [signal for signal in NEEDED if not numpy.isfinite(row.values.get(signal, numpy.nan))]
        if missing:
            return "has no %s" % " and ".join(missing)
        try:
            pipe_events(self.record(self.rows + [row]))
        except RecordError as error:
            return str(error).partition(": ")[2]
        return ""

    def look(self, record):
        """Slips of the depth tracking, reported once, and what is not decided yet."""
        bit, self.hold = record.at("bit_depth", record.time), self.into_slips(record)
        for event in pipe_events(record):
            if isinstance(event, Standstill):
                if event.end == len(bit) - 1 and event.left < event.back:
                    self.hold = min(self.hold, record.signals["time"][event.left])
                continue
            when = record.signals["time"][event.row]
            if when in self.slips:
                continue
            if len(bit) - event.row < UNSURE and (numpy.abs(bit[event.row:] - bit[event.row]) < STILL).all():
                self.hold = min(self.hold, record.signals["time"][event.row - 1])
                continue
            self.slips[when] = event.length
            self.law.apart -= event.length
            self.say("at %.1f s the bit depth changes by %.2f m while the block does not: taken as a slip of the depth tracking" % (when, event.length))

    def into_slips(self, record):
        """When the load at the end of the rows began to leave the hook while the bit stands [s]: perhaps the string is in the slips; inf where it hangs."""
        if "hook_load" not in record:
            return numpy.inf
        bit, loads = (record.at(signal, record.time) for signal in ("bit_depth", "hook_load"))
        hangs = self.values[-1][SHOWN.index("hook_load")]
        low = run((loads < 0.5 * (GRAVITY * self.rig.block_mass + hangs))[::-1])  # nearer to the block alone
        k = last = len(loads) - low
        if not 0 < low < len(loads) or numpy.ptp(bit[last:]) > STILL:
            return numpy.inf
        while k > max(last - LAG, 0) and loads[k - 1] > loads[k]:
            k -= 1
        return record.signals["time"][k]

    def play(self, until):
        """To a time of the feed [s], unless it holds before."""
        last = min(int((min(until, self.hold) - self.base) / self.law.period + 1e-6), len(self.law.times) - 2)
        while self.law.k < last:
            self.step()
        self.compare()

    def step(self):
        rig, law = self.rig, self.law
        self.answer = hand_over(rig, asked(law, Readings(rig.state.t, rig.state.readings, Deaf, self.answer)))
        rig.step(frames=self.every)
        if numpy.isfinite(law.clock[-1]):
            self.times.append(self.base + law.clock[-1])
            self.values.append(self.readings())
            self.warnings.look(rig, self.times[-1])

    def compare(self):
        """Shows the rows that were played."""
        record = self.record(self.rows)
        names = [signal for signal in SHOWN if signal in record]
        recorded = compared(record, names, self.law.stands)
        values = numpy.array(self.values)
        while self.shown < len(self.rows) and self.rows[self.shown].time <= self.times[-1] + 1e-6:
            time = self.rows[self.shown].time
            self.show(time, {name: (float(recorded[name][self.shown]), float(numpy.interp(time, self.times, values[:, SHOWN.index(name)]))) for name in names})
            self.shown += 1

    def forget(self):
        """Rows long played, once they are as many again as those that are kept; not within a standstill, whose whole is needed."""
        cut = self.shown - KEPT
        if cut < KEPT or any(still.begin <= cut <= still.end for still in self.law.stands):
            return
        check_directions(self.record(self.rows))
        check_scale(self.record(self.rows))
        periods = int((self.rows[cut].time - self.base) / self.law.period)
        self.base += periods * self.law.period
        self.rows, self.shown = self.rows[cut:], self.shown - cut
        self.law.shift(self.record(self.rows), cut, periods)
        first = max(int(numpy.searchsorted(self.times, self.rows[self.shown - 1].time)) - 1, 0)
        self.times, self.values = self.times[first:], self.values[first:]

    def finish(self):
        """Plays what is left when the feed has ended."""
        check_directions(self.record(self.rows))
        check_scale(self.record(self.rows))
        if self.hold < numpy.inf:
            self.say("ends while pipe is handled: not played from %.1f s on" % self.hold)
        self.play(self.rows[-1].time)
        for line in self.warnings.lines():
            self.say(line)
