# SPDX-License-Identifier: BSD-3-Clause
"""Least squares of a model's parameters with confidence, by scipy; the model is asked for many points at once, so that its runs may go side by side."""
import numpy

SHARE_OF_SCALE = 0.01  # of a parameter's scale, the step of finite differences
NOWHERE = 30.0         # what a number counts that could not be predicted, in its scatter: no way leads there
ROUNDS = 3             # of the scatter's estimate, at most
ENOUGH = 1e-3          # by which the sum of squares in scatters may still fall where a fit ends: 0.03 of a deviation
SETTLED = 0.05         # change of the scatter from round to round that needs no other [-]
ITERATIONS, LATER = 3, 4  # of the first round, as a rule, and points of a later one
REPLICAS = 12          # of the model's inputs with noise added
FEW = 8                # fewest numbers of a signal that determine their scatter
FEWEST = 4             # fewest that determine a variance
HALVINGS = 30          # in search of a scatter


class FitError(Exception):
    """Why nothing can be fitted, in one line."""


class Parameter:
    """What is fitted: `keys` of the scene set to it (or multiplied, `times`), or an offset that is added to a `signal`. It stays in low..high."""

    def __init__(self, name, start, low, high, keys=(), times=False, signal=None):
        self.name, self.start, self.low, self.high, self.keys, self.times, self.signal = name, start, low, high, list(keys), times, signal

    @property
    def scale(self):
        """A change that matters: of a bounded parameter its range, else its size [its unit]."""
        width = self.high - self.low
        return width if numpy.isfinite(width) else max(abs(self.start), 1.0)


class Fit:
    """`values` and `covariance`, `student` times the deviation is half the width of the confidence; `predicted` beside the data; `scatter` by kind of number (root mean
    square of what was fitted); `without_effect`: parameters that change nothing at the start and stay there."""

    def __init__(self, values, covariance, student, predicted, scatter, runs, without_effect):
        self.values, self.covariance, self.student, self.predicted, self.scatter, self.runs = values, covariance, student, predicted, scatter, runs
        self.without_effect = without_effect

    @property
    def half_widths(self):
        return self.student * numpy.sqrt(numpy.diag(self.covariance))


class Problem:
    """`observed`: numbers, nan where there is none; `signals`: the name of each; `fitted`: which of them count. `model(list of parameter lists)`: a list of
    predictions without offsets. `replicas(parameter list, count)`: as many predictions from inputs to which noise as large as their own was added; None where the inputs
    are exact."""

    def __init__(self, parameters, model, observed, signals, fitted, tell=lambda points, expected: None, replicas=None, kinds=None,
                 errors=0.0):
        """`tell`: called with the number of points tried and about the number of all, whenever there are more. `kinds`: of each number, whose scatter is one;
        None: the signals. `errors`: standard deviation of each number that is known, beside that scatter: of a mean of few rows that vary much."""
        self.errors = numpy.broadcast_to(errors, numpy.shape(observed))
        self.replicas, self.kinds = replicas, numpy.asarray(signals if kinds is None else kinds)
        self.parameters, self.model, self.observed, self.tell = parameters, model, numpy.asarray(observed, dtype=float), tell
        self.signals, self.rows = numpy.asarray(signals), numpy.asarray(fitted) & numpy.isfinite(self.observed)
        self.inner = [k for k, parameter in enumerate(parameters) if parameter.signal is None]
        self.offsets = numpy.array([self.signals == parameter.signal for parameter in parameters], dtype=float).reshape(len(parameters), -1).T
        self.steps = numpy.array([SHARE_OF_SCALE * parameter.scale for parameter in parameters])
        self.known, self.runs, self.expected, self.last_slopes = {}, 0, 0, None
        self.scatter = {}
        self.moved = list(self.inner)  # those that change something

    def ask(self, points):
        """Predictions without offsets at points of all parameters; what is known is not run again."""
        keys = [tuple(float(point[k]) for k in self.inner) for point in points]
        new = list(dict.fromkeys(key for key in keys if key not in self.known))
        self.known.update(zip(new, map(numpy.asarray, self.model([list(key) for key in new]) if new else [])))
        self.runs += len(new)
        if new:
            self.tell(self.runs, max(self.expected, self.runs))
        return [self.known[key] for key in keys]

    def starts(self):
        """Of the parameters that the model is asked with."""
        return [self.parameters[k].start for k in self.inner]

    def predict(self, x):
        return self.ask([x])[0] + self.offsets @ x

    def slopes(self, x):
        """Forward differences, backward at an upper bound; of an offset 1. Within a step of where they were taken last they are no better elsewhere."""
        if self.last_slopes is not None and (numpy.abs(x - self.last_slopes[0]) <= self.steps)[self.inner].all():
            return self.last_slopes[1]
        steps = numpy.array([step if value + step <= parameter.high else -step for value, step, parameter in zip(x, self.steps, self.parameters)])
        moved = [numpy.where(numpy.arange(len(x)) == k, x + steps, x) for k in self.moved]
        base, *others = self.ask([x, *moved])
        matrix = self.offsets.copy()
        for k, other in zip(self.moved, others):
            matrix[:, k] = (other - base) / steps[k]
        self.last_slopes = x.copy(), matrix
        return matrix

    def leave_out_idle(self, x):
        """Parameters that change no number that is fitted are not moved any more."""
        matrix = self.slopes(x)[self.rows]
        self.moved = [k for k in self.moved if numpy.nan_to_num(matrix[:, k], nan=1.0).any()]

    def plan_points(self, later, is_first=False):
        """About how many points it takes in all, with this number of later rounds left; after the first round if `is_first`."""
        self.expect(self.runs + later * LATER + is_first * ITERATIONS * (1 + len(self.moved)) + (REPLICAS if self.replicas else 0))

    def expect(self, points):
        """How many it takes in all, about."""
        self.expected = points
        self.tell(self.runs, points)

    def weights(self):
        return 1.0 / numpy.hypot([self.scatter[name] for name in self.kinds[self.rows]], self.errors[self.rows])

    def residuals(self, x):
        off = (self.predict(x) - self.observed)[self.rows]
        return numpy.where(numpy.isfinite(off), off * self.weights(), NOWHERE)

    def jacobian(self, x):
        matrix = self.slopes(x)[self.rows] * self.weights()[:, None]
        return numpy.where(numpy.isfinite(matrix), matrix, 0.0)


def fit(problem, level=0.95):
    """A Fit, or a FitError. The scatter of each signal is found in rounds, from what is left; residuals that hang together (a model's error, not noise) count for as many
    independent ones as their autocorrelation leaves, which widens the confidence."""
    from scipy.stats import t as student_t  # what an earlier fit found is applied without SciPy
    parameters, names = problem.parameters, sorted(set(problem.kinds[problem.rows]))
    x = numpy.array([parameter.start for parameter in parameters], dtype=float)
    rounds = ROUNDS if len(names) > 1 or problem.errors.any() else 1  # a single scatter moves no minimum
    problem.plan_points(rounds - 1, True)
    if not numpy.isfinite(problem.predict(x)[problem.rows]).any():
        raise FitError("nothing can be predicted at the parameters' start values")
    problem.leave_out_idle(x)
    problem.scatter = {name: max(float(numpy.nanstd(problem.observed[problem.rows & (problem.kinds == name)])), 1e-9) for name in names}
    for left in range(rounds, 0, -1):
        problem.plan_points(min(left, rounds - 1), left == rounds)
        x, before = minimum(problem, x), dict(problem.scatter)
        off = problem.predict(x) - problem.observed
        problem.scatter = scatters(problem, off)
        if all(abs(problem.scatter[name] / before[name] - 1.0) < SETTLED for name in names):
            break
    matrix = problem.slopes(x)
    information = numpy.zeros((len(x), len(x)))
    shares = numpy.full(len(off), numpy.nan)
    shares[problem.rows] = problem.weights()
    independent = 0.0
    for name in names:
        rows = problem.rows & (problem.kinds == name) & numpy.isfinite(off)
        apart = hang_together((off * shares)[rows])
        independent += rows.sum() / apart
        weighted = matrix[rows] * shares[rows][:, None]
        information += weighted.T @ weighted / apart
    freedom = max(independent - len(x), 1.0)
    covariance = inverse(information) * independent / freedom + spread_by_inputs(problem, x, matrix)
    return Fit(x, covariance, float(student_t.ppf(0.5 + 0.5 * level, freedom)), problem.predict(x), dict(problem.scatter), problem.runs,
               [parameters[k].name for k in problem.inner if k not in problem.moved])


def scatters(problem, off):
    """Of each kind the root mean square of what is left beyond the known errors. A few numbers may be fitted exactly, which does not determine their scatter: they get the share of their size
    that is left of the other kinds."""
    left, sizes, counts = {}, {}, {}
    for name in problem.scatter:
        rows = problem.rows & (problem.kinds == name) & numpy.isfinite(off)
        counts[name] = int(rows.sum())
        left[name] = scatter_beyond(off[rows], problem.errors[rows]) if counts[name] else 0.0
        sizes[name] = float(numpy.sqrt(numpy.mean(problem.observed[rows]**2))) if counts[name] else 0.0
    enough = [name for name in left if counts[name] >= min(FEW, max(counts.values()))]
    share = max(left[name] / max(sizes[name], 1e-9) for name in enough)
    return {name: max(left[name] if name in enough else max(left[name], share * sizes[name]), 1e-9) for name in left}


def scatter_beyond(off, errors):
    """The scatter s of numbers with known errors e by which they are as far off as they should be: mean of off^2/(s^2 + e^2) = 1. Without errors the root mean square."""
    low, high = 0.0, float(numpy.sqrt(numpy.mean(off**2)))
    if not errors.any():
        return high
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        if numpy.mean(off**2 / numpy.maximum(middle**2 + errors**2, 1e-300)) > 1.0:
            low = middle
        else:
            high = middle
    return high


def spread_by_inputs(problem, x, matrix):
    """Covariance of the parameters by noise of what the model is fed with, a gauge's for one: it moves the predictions, and what is fitted to them follows. Of replicas
    whose inputs have as much noise again; so few count for t's variance, n/(n - 2)."""
    if problem.replicas is None:
        return numpy.zeros((len(x), len(x)))
    point = [x[k] for k in problem.inner]
    base = problem.ask([x])[0]
    changes = numpy.array([answer - base for answer in problem.replicas(point, REPLICAS)])[:, problem.rows]
    changes = changes[numpy.isfinite(changes).any(axis=1)]
    if len(changes) < FEWEST:
        return numpy.full((len(x), len(x)), numpy.inf)
    weighted = matrix[problem.rows] * problem.weights()[:, None]
    sizes = numpy.maximum(numpy.sqrt(numpy.nansum(weighted**2, axis=0)), 1e-300)
    moved = numpy.linalg.lstsq(numpy.nan_to_num(weighted / sizes), numpy.nan_to_num(changes * problem.weights()).T, rcond=None)[0] / sizes[:, None]
    return moved @ moved.T / (len(changes) - 2)


def minimum(problem, begin):
    """The parameters of least squares from these on; those without effect stay."""
    from scipy.optimize import least_squares
    free = numpy.array([k not in problem.inner or k in problem.moved for k in range(len(begin))])

    def whole(part):
        x = begin.copy()
        x[free] = part
        return x
    bounds = [[getattr(p, side) for p, is_free in zip(problem.parameters, free) if is_free] for side in ("low", "high")]
    return whole(least_squares(lambda part: problem.residuals(whole(part)), begin[free], lambda part: problem.jacobian(whole(part))[:, free], bounds=bounds,
                               x_scale="jac", xtol=1e-6, ftol=max(ENOUGH / problem.rows.sum(), 1e-8)).x if free.any() else begin[free])


def inverse(information):
    """In the parameters' own scales; infinite where the data do not determine it."""
    sizes = numpy.sqrt(numpy.diag(information))
    known = sizes > 0.0
    covariance = numpy.diag(numpy.where(known, 0.0, numpy.inf))
    scaled = information[numpy.ix_(known, known)] / numpy.outer(sizes[known], sizes[known])
    covariance[numpy.ix_(known, known)] = numpy.linalg.pinv(scaled) / numpy.outer(sizes[known], sizes[known])
    return covariance


def hang_together(series):
    """How many of a series' values are as good as one: 1 + 2 sum of its autocorrelations up to where they end (Sokal's window of five times that)."""
    count = len(series)
    if count < 8 or not numpy.var(series) > 0.0:
        return 1.0
    spectrum = numpy.fft.rfft(series - series.mean(), 2 * count)
    correlation = numpy.fft.irfft(spectrum * numpy.conj(spectrum))[:count]
    sums = 2.0 * numpy.cumsum(correlation / correlation[0]) - 1.0
    window = numpy.flatnonzero(numpy.arange(count) >= 5.0 * sums)
    return float(max(1.0, sums[window[0] if len(window) else count - 1]))
