# SPDX-License-Identifier: BSD-3-Clause
"""The height of a recorded block as a trajectory in time: the noise of its gauge does not move it back and forth, and its speed has no jumps."""
import numpy

BAND = 3.0           # of the gauge's noise in standard deviations, half the band in which the trajectory lies
WIDEST = 0.06        # half the band at most [m]: what moves more is the block
STEADY = 0.1         # of a change of speed, what a speed that counts as constant may change from row to row
FINEST = 5e-4        # of resolutions that matter [m]
SEEN = 0.01          # of the way between two rows, what of a ramp can be seen
FINE = 1e-3          # half a band of a gauge by which the trajectory need not be smoothed [m]
TURNS = 5e-4         # speed of a block that moves [m/s]
STANDS = 0.2         # of the speed before and behind: slower, the block stands where its gauge allows it
LOWER_HALF = 0.3246  # mean size of the smaller half of normal numbers, in their standard deviations
ROUNDED = 4.0        # a corner is rounded on each side over this number of half bands, divided by its change of speed [s]: by one half band at most


class Course:
    """Of rows [s], [m], true to half a `band` [m]. Straight between corners (a taut string), these rounded; where the band is FINE, cubics between the rows.
    `acceleration`: the largest at a corner between rows [m/s2]. Beyond the ends it stays."""

    def __init__(self, times, heights, band, acceleration=numpy.inf):
        acceleration = acceleration if band >= FINE else numpy.inf
        corners, at_corners = taut(times, heights - band, heights + band)
        at_corners = with_stops(times[corners], at_corners, band)
        self.corners, at_corners, steady = between_rows(times, corners, at_corners) if band >= FINE else (times[corners], at_corners, corners < 0)
        self.straight = lambda at: numpy.interp(at, self.corners, at_corners)  # without rounded corners
        slopes = numpy.diff(at_corners) / numpy.diff(self.corners)
        self.before, self.after = numpy.concatenate(([0.0], slopes)), numpy.concatenate((slopes, slopes[-1:]))  # speeds at the corners, from rest [m/s]
        slow, fast = numpy.sort(numpy.abs([self.before, self.after]), axis=0)
        self.turns = self.corners[((self.before * self.after < 0.0) | (slow < STANDS * fast)) & (fast > TURNS)]  # where the block starts, stops or turns back
        self.heights = rounded(times, self.corners, at_corners, band, acceleration)  # at the rows [m]
        self.knots = with_ramps(times, self.heights) if band < FINE else with_corners(times, self.corners, at_corners, steady, band, acceleration)

    def __call__(self, at):
        return smooth(at, *self.knots)


def half_band(gauge, heights):
    """Half the width [m] of the band around `heights`, which were made of a gauge's, in which the true trajectory lies: by the gauge's resolution or its noise."""
    step = resolution(gauge)
    noise = min(scatter(heights[::every]) for every in (1, 2, 3))  # what a resolution does to a constant speed may look like noise in every row
    return float(min(0.51 * step if noise < step else BAND * noise, WIDEST))


def resolution(values):
    """The step of which all changes of a gauge are multiples; 0 where there is none above FINEST [as the values], and where all rows change by the same."""
    every = numpy.unique(numpy.abs(numpy.diff(values)))
    steps = every[every > FINEST]
    least = float(steps[0]) if len(steps) and len(every) > 1 else 0.0
    while least > FINEST:  # Euclid's algorithm
        left = numpy.abs(steps - least * numpy.round(steps / least))
        left = left[left > 0.2 * FINEST]
        if not len(left):
            return least
        least = float(left.min())
    return 0.0


def scatter(values):
    """Standard deviation of noise, by the smaller half of the third differences: the larger ones are where the block starts and stops [as the values]."""
    third = numpy.sort(numpy.abs(numpy.diff(values, 3)))
    return float(third[:(len(third) + 1) // 2].mean()) / LOWER_HALF / numpy.sqrt(20.0) if len(third) > 7 else 0.0


def taut(times, low, high):
    """The shortest line between two bounds, which turns back least often: the rows of its corners and its heights there."""
    corners, heights = [0], [0.5 * (low[0] + high[0])]
    k, least, most, at_least, at_most = 1, -numpy.inf, numpy.inf, 0, 0
    while k < len(times):
        way = times[k] - times[corners[-1]]
        above, below = (high[k] - heights[-1]) / way, (low[k] - heights[-1]) / way
        if below > most or above < least:
            corner, height = (at_most, high[at_most]) if below > most else (at_least, low[at_least])
            corners.append(corner)
            heights.append(height)
            k, least, most = corner + 1, -numpy.inf, numpy.inf
            continue
        if above <= most:
            most, at_most = above, k
        if below >= least:
            least, at_least = below, k
        k += 1
    end = len(times) - 1
    if corners[-1] < end:
        way = times[end] - times[corners[-1]]
        slope = numpy.clip((0.5 * (low[end] + high[end]) - heights[-1]) / way, least, most)
        corners.append(end)
        heights.append(heights[-1] + slope * way)
    return numpy.array(corners), numpy.array(heights)


def between_rows(rows, corners, heights):
    """Times and heights of a taut line's corners, and whether the speed is steady before and behind each. Where a steady speed goes over into another in one interval
    between rows, in one sense, it changes once: where the two lines meet."""
    at, slopes = rows[corners], numpy.diff(heights) / numpy.diff(rows[corners])
    found, k = [(at[0], heights[0], False)], 1
    while k < len(slopes):
        before, after = slopes[k - 1], slopes[min(k + 1, len(slopes) - 1)]
        if corners[k + 1] == corners[k] + 1 and (slopes[k] - before) * (after - slopes[k]) > 0.0 and between_steady(corners, slopes, k - 1, k + 1):
            moved = at[k] + (at[k + 1] - at[k]) * (slopes[k] - after) / (before - after)
            found.append((moved, heights[k] + before * (moved - at[k]), True))
            k += 2
            continue
        found.append((at[k], heights[k], between_steady(corners, slopes, k - 1, k)))
        k += 1
    if k < len(at):
        found.append((at[k], heights[k], False))
    return tuple(map(numpy.array, zip(*found)))


def between_steady(corners, slopes, before, after):
    """Whether two lines of these speeds are longer than an interval between rows, or as steep as the next one."""
    alike = STEADY * abs(slopes[after] - slopes[before])
    return all(corners[k + 1] > corners[k] + 1 or (0 <= beside < len(slopes) and abs(slopes[beside] - slopes[k]) <= alike)
               for k, beside in ((before, before - 1), (after, after + 1)))


def with_stops(times, heights, band):
    """The heights of a taut line's corners, where a block that creeps through the band between faster moves is held still. Friction would act to one side
    of a block that creeps, and its gauge does not show the creeping."""
    heights, k = heights.copy(), 0
    speed = numpy.abs(numpy.diff(heights) / numpy.diff(times))
    slow = (numpy.abs(numpy.diff(heights)) <= 2.0 * band) & (band > 0.0)
    while k < len(slow):
        end = k
        while end < len(slow) and slow[end] and abs(heights[end + 1] - heights[k]) <= 2.0 * band and (end == k or speed[end] < STANDS * speed.max()):
            end += 1
        around = [speed[j] for j in (k - 1, end) if 0 <= j < len(slow)]
        if end > k and around and abs(heights[end] - heights[k]) < STANDS * min(around) * (times[end] - times[k]):
            heights[k:end + 1] = 0.5 * (heights[k] + heights[end])
        k = max(end, k + 1)
    return heights


def reach_of(times, slopes, band, acceleration):
    """Change of the speed at each corner [m/s], and by how much before and behind it is rounded [s]."""
    bends = numpy.diff(numpy.concatenate((slopes[:1], slopes, slopes[-1:])))
    sides = 0.5 * numpy.diff(times)
    room = numpy.minimum(numpy.concatenate((sides[:1], sides)), numpy.concatenate((sides, sides[-1:])))
    return bends, numpy.minimum(numpy.maximum(ROUNDED * band / numpy.maximum(numpy.abs(bends), 1e-12), 0.5 * numpy.abs(bends) / acceleration), room)


def with_corners(rows, times, heights, steady, band, acceleration):
    """Times and heights of rows, and of where the speed begins and ends to change at a corner between steady speeds; beside them the speed where it is known, else nan."""
    slopes = numpy.diff(heights) / numpy.diff(times)
    own = numpy.flatnonzero(steady)
    reach = reach_of(times, slopes, band, acceleration)[1][own]
    at = numpy.concatenate((times[own] - reach, times[own] + reach, times[own], rows))
    mean = 0.5 * (slopes[own - 1] + slopes[own])
    known = numpy.concatenate((slopes[own - 1], slopes[own], mean, numpy.full(len(rows), numpy.nan)))
    at, first = numpy.unique(at, return_index=True)
    return at, rounded(at, times, heights, band, acceleration), known[first]


def rounded(at, times, heights, band, acceleration):
    """Heights on straight lines between corners, each of which is a parabola near it."""
    bends, reach = reach_of(times, numpy.diff(heights) / numpy.diff(times), band, acceleration)
    near = numpy.searchsorted(0.5 * (times[1:] + times[:-1]), at)
    beyond = numpy.maximum(reach[near] - numpy.abs(at - times[near]), 0.0)
    return numpy.interp(at, times, heights) + bends[near] * beyond**2 / (4.0 * numpy.maximum(reach[near], 1e-12))


def with_ramps(times, heights):
    """Times and heights of rows, and of the places between them where one steady speed ends and another begins: where a ramp of the speed begins and ends that is seen
    in two intervals between rows; in one, where a ramp begins or ends that is as long as it leaves room for. Beside them the speed where it is known, else nan."""
    speed, width = numpy.diff(heights) / numpy.diff(times), numpy.diff(times)
    speeds = numpy.full(len(times), numpy.nan)
    if len(speed) < 5:
        return times, heights, speeds
    long = long_ramps(speed, width)
    found, places, there = short_ramps(times, heights, speed, width, [k for first, _, _ in long for k in (first, first + 1)])
    known = numpy.full(len(found), numpy.nan)
    for first, begins, ends in long:
        before, after, middle = speed[first - 1], speed[first + 2], times[first + 1]
        speeds[first + 1] = before + (after - before) * begins / (begins + ends)
        found = numpy.append(found, (first, first + 1))
        places = numpy.append(places, (middle - begins, middle + ends))
        there = numpy.append(there, (heights[first] + before * (width[first] - begins), heights[first + 2] - after * (width[first + 1] - ends)))
        known = numpy.append(known, (before, after))
    order = numpy.argsort(found)
    return tuple(numpy.insert(rows, found[order] + 1, new[order]) for rows, new in ((times, places), (heights, there), (speeds, known)))


def long_ramps(speed, width):
    """(k, begins, ends): of a ramp that begins in interval k, so long before its end, and ends in the next, so long after its beginning [s]. What the block went in
    the two, beyond the speed before it and short of the speed after it, gives both: each is the triangle of a part of the ramp."""
    found = []
    for k in range(2, len(speed) - 3):
        before, after = speed[k - 1], speed[k + 2]
        change = after - before
        if change == 0.0 or max(abs(before - speed[k - 2]), abs(after - speed[k + 3])) >= STEADY * abs(change):
            continue
        beyond, short = (speed[k] - before) / change * width[k], (after - speed[k + 1]) / change * width[k + 1]
        if beyond < SEEN * width[k] or short < SEEN * width[k + 1]:
            continue
        lasts = 2.0 * (numpy.sqrt(beyond) + numpy.sqrt(short))**2
        begins, ends = numpy.sqrt(2.0 * lasts * beyond), numpy.sqrt(2.0 * lasts * short)
        if begins <= width[k] and ends <= width[k + 1]:
            found.append((k, begins, ends))
    return found


def short_ramps(times, heights, speed, width, passed):
    """Intervals in which a ramp begins or ends at a place between the rows, the places and the heights there. Those of `passed` are none."""
    k = numpy.setdiff1d(numpy.arange(2, len(speed) - 2), passed)
    before, after = speed[k - 1], speed[k + 1]
    change = numpy.where(before == after, 1.0, before - after)
    share = (speed[k] - after) / change  # of the way between the rows at the first speed, if that changed at once
    steady = numpy.maximum(numpy.abs(before - speed[k - 2]), numpy.abs(after - speed[k + 2])) < STEADY * numpy.abs(change)
    found = k[steady & (before != after) & (share > SEEN) & (share < 1.0 - SEEN) & (numpy.abs(share - 0.5) > 0.05)]
    share = (speed[found] - speed[found + 1]) / (speed[found - 1] - speed[found + 1])
    early = share < 0.5
    places = times[found] + numpy.where(early, 2.0 * share, 2.0 * share - 1.0) * width[found]
    there = numpy.where(early, heights[found + 1] - speed[found + 1] * (times[found + 1] - places), heights[found] + speed[found - 1] * (places - times[found]))
    return found, places, there


def smooth(at, times, values, known):
    """Cubics between the rows without overshoot: a block that stops does not come back. Beyond the end it stays. `known`: slopes, nan where they are not."""
    slopes = numpy.where(numpy.isnan(known), slopes_of(times, values), known)
    k = numpy.clip(numpy.searchsorted(times, at, side="right") - 1, 0, len(times) - 2)
    width = times[k + 1] - times[k]
    u = numpy.clip((at - times[k]) / width, 0.0, 1.0)
    return ((1.0 + 2.0 * u) * (1.0 - u)**2 * values[k] + u**2 * (3.0 - 2.0 * u) * values[k + 1] +
            u * (1.0 - u)**2 * width * slopes[k] - u**2 * (1.0 - u) * width * slopes[k + 1])


def slopes_of(times, values):
    """At the rows, of the parabola through a row and two neighbours that bends least: before it, around it or behind it, for drawworks change their acceleration
    abruptly (ENO). Where the speed has not one sign on both sides 0, and at most three times the smaller one (Fritsch and Carlson)."""
    sides = numpy.diff(values) / numpy.diff(times)
    before, after = numpy.concatenate((sides[:1], sides)), numpy.concatenate((sides, sides[-1:]))
    left, right = numpy.diff(times, prepend=times[0] - 1.0), numpy.diff(times, append=times[-1] + 1.0)
    bend = (after - before) / (left + right)  # half the second derivative around each row
    bends = numpy.array([bend, numpy.concatenate((bend[:1], bend[:-1])), numpy.concatenate((bend[1:], bend[-1:]))])
    found = numpy.array([before + bend * left, before + bends[1] * left, after - bends[2] * right])
    slopes = numpy.take_along_axis(found, numpy.argmin(numpy.abs(bends), axis=0)[None], axis=0)[0]
    most = 3.0 * numpy.minimum(numpy.abs(before), numpy.abs(after))
    return numpy.where(before * after > 0.0, numpy.sign(before) * numpy.clip(numpy.sign(before) * slopes, 0.0, most), 0.0)
