# SPDX-License-Identifier: BSD-3-Clause
"""drill_campaign PLAN.yaml: does its runs that are not done yet, into one SQLite file. drill_campaign report, export, scene, play FILE: looks at them."""
import argparse
import contextlib
import os
import sys
import time

from drill_rig_sim.campaign import again, audits
from drill_rig_sim.campaign.plan import read_plan
from drill_rig_sim.campaign.plan_checks import first_rig
from drill_rig_sim.campaign.plan_text import PlanError
from drill_rig_sim.campaign.results import AUDITS, RUNS, Locked, Results, ResultsError
from drill_rig_sim.campaign.runner import GOOD as RUN_GOOD
from drill_rig_sim.units import SYSTEMS

GOOD, SOME_BAD, BAD_INPUT, BROKEN = 0, 1, 2, 3
KEEP_EVERY = 0.5  # longest that results wait before they are in the file, unless another program holds it [s]
SHORT_PATIENCE = 1.0  # so long is waited for that one, which holds up the campaign [s]


class Said(Exception):
    """The end of the command, and why."""


def parser():
    top = argparse.ArgumentParser(prog="drill_campaign", description=__doc__, epilog="Exit status: 0 all runs ended well, 1 some did not (their rows say why), "
                                  "2 bad input, 3 the workers were lost or a signal came: finished runs are kept, the same command continues.")
    top.add_argument("plan", help="the plan's file; or report, export, scene, play with the results' file")
    top.add_argument("--results", metavar="FILE", help="default: the plan's name with .sqlite, in this folder")
    top.add_argument("--workers", type=int, default=0, metavar="N", help="processes on this machine; default: one a core")
    top.add_argument("--scheduler", metavar="ADDRESS", help="of a running Dask cluster, tcp://HOST:PORT")
    top.add_argument("--slurm", type=int, default=0, metavar="N", help="workers started by sbatch")
    top.add_argument("--again", action="store_true", help="repeat the runs that did not end well")
    top.add_argument("--check", action="store_true", help="read the plan, build the first run's rig and controller, say what there is to do, and end")
    return top


def looks():
    """The parsers of the commands that look at results."""
    found = {}
    for name, text in (("report", "one page of a campaign's results"), ("export", "its rows as CSV"), 
                       ("scene", "the files that show one of its runs: scene, survey, and with a controller that and a launch file"),
                       ("play", "one of its runs once more in this process, without bounds: the same to the last bit; exit status 1 where it ends otherwise")):
        found[name] = argparse.ArgumentParser(prog="drill_campaign " + name, description=text)
        found[name].add_argument("results", help="the campaign's SQLite file")
    for name, default in (("report", "beside it"), ("export", "beside it"), ("scene", "run_K.yaml")):
        found[name].add_argument("--out", metavar="FILE", help="default: " + default)
    found["report"].add_argument("--units", choices=SYSTEMS, default="si", help="of outputs whose quantity is known; the results' file and export stay in SI")
    for name in ("scene", "play"):
        found[name].add_argument("--run", type=int, required=True, metavar="K", help="number of the run, from 0 on")
    found["play"].add_argument("--csv", metavar="FILE", help="the time series, as drill run --csv has it")
    return found


class Progress:
    """A line on a terminal, each half second; in a pipe one each ten."""

    def __init__(self, left, out=sys.stderr, good=(RUN_GOOD,)):
        self.left, self.done, self.bad, self.out, self.good = left, 0, 0, out, good
        self.began, self.printed = time.monotonic(), 0.0

    def count(self, status):
        self.done += 1
        self.bad += status not in self.good
        if time.monotonic() - self.printed > (0.5 if self.out.isatty() else 10.0):
            self.tell()

    def tell(self, last=False):
        self.printed = time.monotonic()
        rate = self.done / max(self.printed - self.began, 1e-9)
        to_go = clock((self.left - self.done) / rate) if self.done else "?"
        line = "%d of %d done, %d of them bad, %.3g a second, %s to go" % (self.done, self.left, self.bad, rate, to_go)
        ends = "\n" if last or not self.out.isatty() else "\x1b[K\r"
        print(line, end=ends, file=self.out, flush=True)


def clock(seconds):
    return "%d:%02d:%02d" % (seconds // 3600, seconds // 60 % 60, seconds % 60)


def campaign(options):
    plan = read_plan(options.plan)
    identity = first_rig(plan)
    keys = [plan.blueprint.key_of(row, identity) for row in plan.rows]
    file = options.results or os.path.splitext(os.path.basename(options.plan))[0] + ".sqlite"
    if options.check:
        print("%s: %d runs, %d of them different; build %s, kernel %s" % (options.plan, len(keys), len(set(keys)), identity[0][:8], identity[1]))
        return GOOD
    with contextlib.closing(Results(file)) as results:
        return fill(results, plan, keys, identity, options)


def fill(results, plan, keys, identity, options):
    """Does the runs of these keys that the file does not have yet, and the audits."""
    results.describe(keys, name=plan.blueprint.name, plan=plan.text, factors=plan.names, outputs=list(plan.blueprint.outputs), sample=plan.sample,
                     report=plan.report, audit=plan.audit, identity=identity, blueprint=plan.blueprint.parts())
    if options.again:
        results.forget_bad(keys)
    there = results.done()
    todo = list({key: (key, row) for key, row in zip(keys, plan.rows) if key not in there}.values())
    print("%s: %d runs, %d to do" % (results.file, len(keys), len(todo)), flush=True)
    if todo:
        do(plan.blueprint, todo, identity, results, options)
    audit(plan.blueprint, identity, results, options)
    return print_outcome(results, len(keys))


def audit(blueprint, identity, results, options):
    """Verifies the runs that are chosen for it and are not verified yet."""
    rows, there = list(results.rows()), results.done(AUDITS)
    numbers = audits.chosen(rows, results.about())
    todo = [(row["key"], row["values"]) for row in rows if row["number"] in numbers and row["key"] not in there]
    if todo:
        print("%s: %d runs are audited with two finer models each, %d to do" % (results.file, len(numbers), len(todo)), flush=True)
        do(blueprint, todo, identity, results, options, AUDITS)


class Kept:
    """Answers on their way into a table of the file, every KEEP_EVERY; while another program holds that, they wait."""

    def __init__(self, results, progress, table=RUNS):
        self.results, self.progress, self.table = results, progress, table
        self.rows, self.number, self.since, self.said = [], 0, time.monotonic(), False

    def take(self, key, row, answer):
        status, reason, outputs, cpu, worker = answer
        self.rows.append((key, row, status, reason, outputs, cpu, worker))
        self.progress.count(status)
        if time.monotonic() - self.since > KEEP_EVERY:
            self.keep_if_free()

    def keep_if_free(self):
        try:
            self.keep(patience=SHORT_PATIENCE)
        except Locked as error:
            self.since = time.monotonic()
            if not self.said:
                print("drill_campaign: %s: results are written later" % error, file=sys.stderr)
            self.said = True

    def keep(self, **patience):
        self.results.add(self.rows, table=self.table, **patience)
        self.number += len(self.rows)
        self.rows, self.since = [], time.monotonic()


def do(blueprint, todo, identity, results, options, table=RUNS):
    """Does the runs `todo`, or their audits, into a table of the results."""
    from drill_rig_sim.campaign import engine  # needs Dask
    progress = Progress(len(todo), good=(RUN_GOOD, "right", "warned"))
    kept = Kept(results, progress, table)
    try:
        with contextlib.ExitStack() as at_end:
            client, open_things = engine.connect(options.scheduler, options.slurm, options.workers)
            for thing in [*reversed(open_things), client]:
                at_end.callback(thing.close)
            at_end.callback(progress.tell, last=True)
            at_end.callback(kept.keep)  # before all else
            if engine.page(client):
                print("Dask's page: %s" % engine.page(client), flush=True)
            engine.work(client, blueprint, todo, identity, kept.take, verified=table == AUDITS)
    except (engine.EngineError, OSError, ResultsError) as error:
        raise Said("%s; %d %s are done, the same command continues" % (error, kept.number, table)) from error


def print_outcome(results, number):
    counts, first = {}, {}
    for row in results.rows():
        counts[row["status"]] = counts.get(row["status"], 0) + 1
        first.setdefault(row["status"], row)
    print("%d of %d runs are in the results: %s" % (sum(counts.values()), number, ", ".join("%d %s" % (n, status) for status, n in sorted(counts.items()))))
    for status in sorted(set(first) - {RUN_GOOD}):
        print("%s, first run %d: %s" % (status, first[status]["number"], first[status]["reason"]))
    audited = list(results.audits())
    if audited:
        print("; ".join(filter(None, ("%d runs were audited: %s" % (len(audited), audits.summary(row["status"] for row in audited)), audits.unmeasured(audited)))))
    return GOOD if counts.get(RUN_GOOD, 0) == number else SOME_BAD


def look(name, words):
    options = looks()[name].parse_args(words)
    with contextlib.closing(Results(options.results, write=False)) as results:
        return shown(name, results, options)


def shown(name, results, options):
    base = os.path.splitext(options.results)[0]
    if name == "export":
        file = options.out or base + ".csv"
        results.write_csv(file)
        print(file)
    elif name == "report":
        from drill_rig_sim.campaign import report
        print(report.write_page(results, options.out or base + ".html", options.units))
    elif name == "scene":
        print("\n".join(again.write_files(results, options.run, options.out or "run_%d.yaml" % options.run)))
    else:
        same, lines = again.play(results, options.run, options.csv)
        print("\n".join(lines))
        return GOOD if same else SOME_BAD
    return GOOD


def main(words=None):
    words = sys.argv[1:] if words is None else words
    try:
        if words[:1] and words[0] in looks():
            return look(words[0], words[1:])
        return campaign(parser().parse_args(words))
    except (PlanError, ResultsError, OSError) as error:
        print("drill_campaign: %s" % error, file=sys.stderr)
        return BAD_INPUT
    except ImportError as error:
        print("drill_campaign: %s; campaigns need Debian's python3-distributed and python3-scipy" % error, file=sys.stderr)
        return BROKEN
    except (Said, KeyboardInterrupt) as error:
        print("drill_campaign: %s" % (str(error) or "stopped: finished runs are kept, the same command continues"), file=sys.stderr)
        return BROKEN


if __name__ == "__main__":
    sys.exit(main())
