# SPDX-License-Identifier: BSD-3-Clause
"""What a model with fitted parameters predicts, in the band that the confidence of the fit and the scatter of its data leave."""
import numpy


class Prediction:
    """By the model's numbers: `predicted`, and half the width of the 95 % band: `confidence` only by the parameters, `band` with the scatter of a single number. Not
    a number where nothing was predicted, infinite where the band depends on what the fit's data do not determine: `untold`, names of parameters and of signals that were
    wholly held out."""

    def __init__(self, model, problem, fitted, values):
        """`values` of the fit's parameters; those of `fitted` are not looked at."""
        matrix = problem.slopes(values)
        known = numpy.isfinite(numpy.diag(fitted.covariance))
        covariance = fitted.covariance[numpy.ix_(known, known)]
        variance = numpy.einsum("ki,ij,kj->k", matrix[:, known], covariance, matrix[:, known])
        needs_untold = (numpy.nan_to_num(matrix[:, ~known], nan=1.0) != 0.0).any(axis=1)
        scatter = numpy.array([fitted.scatter[signal] for signal in problem.signals])
        self.groups, (self.axis, self.places) = model.groups, model.axis
        self.signals, self.observed, self.predicted = problem.signals, problem.observed, problem.predict(values)
        self.confidence = numpy.where(needs_untold, numpy.inf, fitted.student * numpy.sqrt(numpy.maximum(variance, 0.0)))
        self.band = numpy.hypot(self.confidence, fitted.student * numpy.hypot(scatter, problem.errors))
        self.untold = [p.name for p, is_known, column in zip(problem.parameters, known, matrix.T) if not is_known and numpy.nan_to_num(column, nan=1.0).any()]
        self.untold += ["the scatter of %s" % signal for signal in dict.fromkeys(map(str, problem.signals)) if not numpy.isfinite(fitted.scatter[signal])]

    @property
    def off(self):
        """Recorded less predicted."""
        return self.observed - self.predicted

    def parts(self):
        """Rows that can be compared, of each group (signal of a record, motion of a table) that has some."""
        compared = numpy.isfinite(self.off)
        return {str(group): rows for group in dict.fromkeys(self.groups) for rows in [numpy.flatnonzero(compared & (self.groups == group))] if len(rows)}

    def summary(self):
        """Of each group: how many rows, what is off, mean, root mean square and largest, and the share of rows within the band; None where that is
        unknown."""
        return {group: {"rows": len(rows), "mean": float(self.off[rows].mean()), "rms": float(numpy.sqrt((self.off[rows]**2).mean())),
                        "largest": float(numpy.abs(self.off[rows]).max()), "within": self.within(rows)}
                for group, rows in self.parts().items()}

    def within(self, rows):
        known = rows[numpy.isfinite(self.band[rows])]
        return float((numpy.abs(self.off[known]) <= self.band[known]).mean()) if len(known) else None

    def as_json(self):
        columns = {"recorded": self.observed, "predicted": self.predicted, "difference": self.off, "confidence_95": self.confidence, "band_95": self.band}
        return {"summary": self.summary(), "untold": self.untold,
                "rows": {group: {self.axis: self.places[rows].tolist(), **{name: values[rows].tolist() for name, values in columns.items()}} for group, rows in self.parts().items()}}
