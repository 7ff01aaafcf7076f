# SPDX-License-Identifier: BSD-3-Clause
"""Dask distributed does the work: on this machine's cores, on a running cluster, or on workers that Slurm starts."""
import contextlib
import importlib.util
import ipaddress
import itertools
import multiprocessing.resource_tracker
import os
import shutil
import signal
import subprocess
import sys
import time
import urllib.parse

import dask
import distributed
from drill_rig_sim.campaign.runner import DIED, Runner

PLUGIN = "drill_campaign"
PAGE = "127.0.0.1:0"  # Dask's own page, only for this machine; it needs bokeh
AHEAD = 3  # tasks that wait beside each that is done: a worker is never idle, and the scheduler's memory stays small
FOR_GOOD = "365 days"  # of a wait
LOGGED = 1000  # entries of Dask's logs, which are not read here and grow by kilobytes a run
AT_ONCE, MOST_AT_ONCE = 0.2, 20  # so long runs last that go in one task [s], and how many they are at most


class EngineError(Exception):
    """Why there are no workers, in one line."""


class RunnerPlugin(distributed.WorkerPlugin):
    """Gives every worker, also one that comes later, its runner."""
    name = PLUGIN

    def __init__(self, blueprint):
        self.blueprint, self.runner = blueprint, None

    def setup(self, worker):
        self.runner = Runner(self.blueprint)

    def teardown(self, worker):
        if self.runner is not None:
            self.runner.end()


def several(rows, identity, verified):
    """On a worker: how long they took [s], and of each run, or its audit, as runner.run() answers, and which worker it was."""
    worker, began = distributed.get_worker(), time.monotonic()
    answers = [(*worker.plugins[PLUGIN].runner.run(row, identity, verified), worker.address) for row in rows]
    return time.monotonic() - began, answers


def keys_of_logs():
    """Of what a scheduler keeps for its developers. A key of another version is a warning of Dask."""
    of_2024 = "distributed.admin.low-level-log-length"
    if dask.config.get(of_2024, None) is not None:
        return [of_2024]
    return ["distributed.scheduler.transition-log-length", "distributed.scheduler.events-log-length"]


def connect(scheduler=None, slurm=0, workers=0):
    """A client and what is to be closed after it. Without arguments: as many processes on this machine as it has cores for us."""
    dask.config.set({"distributed.worker.daemon": False, "distributed.comm.timeouts.connect": "20s", "distributed.admin.log-format": "%(levelname)s %(message)s",
                     **dict.fromkeys(keys_of_logs(), LOGGED),
                     # a dead worker is started again by its nanny; the cluster would close that nanny if 15 s after one death another worker was just starting
                     "distributed.deploy.lost-worker-timeout": FOR_GOOD,
                     "distributed.nanny.pre-spawn-environ.DASK_LOGGING__DISTRIBUTED": "critical"})  # what older workers left behind is no news
    if scheduler is not None:
        return client_of(address_checked(scheduler)), []
    if slurm:
        return on_slurm(slurm)
    with deaf_to_ctrl_c():
        cluster = distributed.LocalCluster(n_workers=workers or len(os.sched_getaffinity(0)), threads_per_worker=1, processes=True, host="127.0.0.1",
                                           dashboard_address=PAGE, worker_dashboard_address=PAGE, memory_limit=None, silence_logs=50)
    return distributed.Client(cluster), [cluster]


def page(client):
    """The address of Dask's own page where it can be shown, else None. It needs bokeh, which Debian does not have."""
    return client.dashboard_link if importlib.util.find_spec("bokeh") else None


@contextlib.contextmanager
def deaf_to_ctrl_c():
    """Threads that begin meanwhile, and all processes that they start, never see Ctrl-C, which is for the campaign; here it waits."""
    multiprocessing.resource_tracker.ensure_running()  # it lets Ctrl-C through again where it begins
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def address_checked(address):
    """Beyond this machine TLS is asked for: a task is code."""
    parts = urllib.parse.urlsplit(address)
    if parts.scheme not in ("tcp", "tls") or not parts.hostname or not parts.port:
        raise EngineError("%s: is not an address, needed: tcp://HOST:PORT of this machine, or tls://HOST:PORT" % address)
    if parts.scheme == "tcp" and not is_here(parts.hostname):
        raise EngineError("%s: is another machine: needed: tls://HOST:PORT, with certificates by Dask's configuration (distributed.comm.tls)" % address)
    if parts.scheme == "tls" and security() is None:
        raise EngineError("%s: there are no certificates, needed: Dask's configuration of them (distributed.comm.tls.ca-file, client.cert, client.key)" % address)
    return address


def client_of(address):
    """Of a running scheduler."""
    try:
        return distributed.Client(address, security=security(), timeout="20s")
    except (TypeError, ValueError) as error:  # a configuration that is no whole one
        raise EngineError("%s: %s" % (address, " ".join(str(error).split()))) from error


def is_here(host):
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return host == "localhost"


def security():
    found = distributed.Security()
    return found if found.tls_client_cert else None


def on_slurm(number):
    """A scheduler here, and as many workers by sbatch, each of one core. They find it by a file in this folder, and end with it."""
    if not shutil.which("sbatch"):
        raise EngineError("--slurm: the command sbatch was not found")
    if security() is None:
        raise EngineError("--slurm: workers are on other machines: needed: certificates by Dask's configuration (distributed.comm.tls)")
    cluster = distributed.LocalCluster(n_workers=0, host="tls://0.0.0.0", security=security(), dashboard_address=PAGE, silence_logs=50)
    client = distributed.Client(cluster)
    script = slurm_script(number, cluster.scheduler_address)
    done = subprocess.run(["sbatch", "--parsable"], input=script, capture_output=True, text=True, check=False)
    if done.returncode:
        cluster.close()
        raise EngineError("--slurm: sbatch: %s" % " ".join(done.stderr.split()))
    job = done.stdout.strip().split(";")[0]
    return client, [SlurmJob(job), cluster]


def slurm_script(number, address):
    return "\n".join(["#!/bin/sh", "#SBATCH --job-name=drill_campaign --ntasks=%d --cpus-per-task=1" % number, "export PYTHONPATH=%s" % ":".join(sys.path[1:]),
                      "exec srun %s -m distributed.cli.dask_worker %s --nthreads 1 --nworkers 1 --dashboard-address %s --death-timeout 60" % (sys.executable, address, PAGE)]) + "\n"


class SlurmJob:
    """Workers that end with the campaign."""

    def __init__(self, job):
        self.job = job

    def close(self):
        subprocess.run(["scancel", self.job], check=False, capture_output=True)


def work(client, blueprint, tasks, identity, take, verified=False):
    """Does tasks (key, row), a few more than there are workers at a time; take(key, row, answer) with each answer, in the order of their ends. `verified`: audits of them."""
    client.register_worker_plugin(RunnerPlugin(blueprint), PLUGIN)
    suspects = []

    def taken(key, row, answer):
        if answer is None:
            suspects.append((key, row))
        else:
            take(key, row, answer)

    asked = identity, verified
    send_all(client, iter(tasks), asked, (1 + AHEAD) * max(1, len(client.scheduler_info()["workers"])), taken)
    # workers died, of one of the runs that they had: running them one after the other shows which
    for key, row in list(suspects):
        send_all(client, iter([(key, row)]), asked, 1, lambda key, row, answer: take(key, row, answer or (DIED, "its workers died, one after the other", {}, 0.0, "")))


def send_all(client, tasks, asked, ahead, taken):
    """Short runs go several at a time, for handing one over costs some milliseconds. `asked`: of several() beside the rows."""
    finished, sent, done, seconds = distributed.as_completed(), {}, 0, 0.0

    def send():
        size = int(min(MOST_AT_ONCE, max(1.0, AT_ONCE * done / seconds))) if done else 1
        runs = list(itertools.islice(tasks, size))
        if runs:
            name = runs[0][0] + "-audit" * asked[1]
            sent[name] = runs
            finished.add(client.submit(several, [row for _, row in runs], *asked, key=name, pure=False))

    for _ in range(ahead):
        send()
    for future in finished:
        runs, answer = sent.pop(future.key), answer_of(future)
        took, answers = answer or (0.0, [None] * len(runs))
        done, seconds = done + (answer is not None) * len(runs), seconds + took
        for (key, row), one in zip(runs, answers):
            taken(key, row, one)
        future.release()
        send()


def answer_of(future):
    """None of runs whose workers died, one after the other."""
    try:
        return future.result()
    except distributed.scheduler.KilledWorker:
        return None
    except Exception as error:  # pylint: disable=broad-except
        if future.status == "error":  # of Dask or of our own code, not of a run
            raise EngineError("%s: %s" % (type(error).__name__, " ".join(str(error).split())))
        raise EngineError("the scheduler was lost")
