#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Campaigns on Dask, with two worker processes on localhost: the same results with any number of workers and any of them killed; Slurm by a stand-in."""
import importlib.util
import os
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest

if not all(map(importlib.util.find_spec, ("distributed", "scipy"))):
    print("skipped: Dask is not installed (python3-distributed, python3-scipy: ./test/run --campaigns)")
    sys.exit(77)
from drill_rig_sim.campaign import engine
from drill_rig_sim.campaign.results import Results
from test_campaign_parts import drill_campaign

HERE = os.path.dirname(os.path.abspath(__file__))
SOURCE = os.path.dirname(os.path.dirname(HERE))
QUICK = os.path.join(SOURCE, "config/scenes/quick.yaml")
PATIENCE = 240.0  # [s]
RUNS = 12
PLAN = """scene: %s
duration: 0.5
controller: {class: "%s/laws.py:Law", parameters: {slow: "%%s"}}
factors:
  - {name: rpm, key: controller.rpm, from: 30.0, to: 90.0}
  - {name: fault, key: controller.fault, values: ["", error]}
  - {name: friction, key: "well.sections[*].friction", values: [0.2, -1.0, 0.3]}
sample: {kind: latin_hypercube, runs: %d, seed: 2}
outputs: {turned: "%s/laws.py:turned", torque: largest.truth.torque}
""" % (QUICK, HERE, RUNS, HERE)
SBATCH = """#!/bin/sh
sed -n 's/^exec srun //p' >"$0.command"
cat "$0.command" | sed 's/^/exec /' >"$0.script"
for k in 1 2; do sh "$0.script" >/dev/null 2>&1 & echo $! >>"$0.pids"; done
echo 4711
"""


class Campaigns(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.slow = os.path.join(folder.name, "slow")  # runs are slow while it is there; all tests name the same file, for it is part of the plan
        cls.results = os.path.join(folder.name, "undisturbed.sqlite")

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.processes = []
        self.addCleanup(self.end)

    def end(self):
        for process in self.processes:
            if process.poll() is None:
                process.kill()
            process.communicate()

    def place(self, name):
        return os.path.join(self.folder, name)

    def plan(self, text=PLAN, name="plan"):
        with open(self.place(name + ".yaml"), "w", encoding="utf-8") as out:
            out.write(text % self.slow)
        return self.place(name + ".yaml")

    def slow_plan(self):
        """Its runs take seconds until go_on()."""
        with open(self.slow, "w", encoding="utf-8"):
            self.addCleanup(self.go_on)
        return self.plan()

    def go_on(self):
        if os.path.exists(self.slow):
            os.remove(self.slow)

    def start(self, *words, **more):
        process = subprocess.Popen([sys.executable, "-m", "drill_rig_sim.campaign.command", *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                   cwd=self.folder, **more)
        self.processes.append(process)
        return process

    def run_to_its_end(self, *words, **more):
        process = self.start(*words, **more)
        out, told = process.communicate(timeout=PATIENCE)
        return process.returncode, out, told

    def csv(self, name):
        with open(self.place(name), "w", encoding="utf-8"):
            pass
        results = Results(self.place(name.replace(".csv", ".sqlite")), write=False)
        results.write_csv(self.place(name))
        results.close()
        with open(self.place(name), encoding="utf-8") as text:
            return text.read()

    def undisturbed(self):
        """The plan's results as CSV, by one worker that is left alone. They are computed once for all tests; undisturbed.sqlite is a copy."""
        if not os.path.exists(self.results):
            status, out, told = self.run_to_its_end(self.plan(), "--workers", "1", "--results", self.place("undisturbed.sqlite"))
            self.assertEqual(1, status, told)
            self.assertIn("%d of %d runs are in the results" % (RUNS, RUNS), out)
            shutil.copy(self.place("undisturbed.sqlite"), self.results)
        shutil.copy(self.results, self.place("undisturbed.sqlite"))
        return self.csv("undisturbed.csv")

    def wait(self, until, what):
        deadline = time.monotonic() + PATIENCE
        while not until():
            self.assertLess(time.monotonic(), deadline, what)
            time.sleep(0.02)

    def rows_in(self, name):
        if not os.path.exists(self.place(name)) or not os.path.getsize(self.place(name)):
            return 0
        results = Results(self.place(name), write=False)
        try:
            return len(results.done())
        finally:
            results.close()

    # --- as it is started

    def test_the_script_and_its_installed_relay_run_a_campaign(self):
        """Workers' processes read the program again that started them: that is no second campaign."""
        relays = [os.path.join(prefix, "lib/drill_rig_sim/drill_campaign") for prefix in os.environ.get("CMAKE_PREFIX_PATH", "").split(":")]
        programs = [os.path.join(SOURCE, "src/tools/drill_campaign"), *filter(os.path.isfile, relays)]
        text = PLAN.replace("[\"\", error]", "[\"\"]").replace("[0.2, -1.0, 0.3]", "[0.2]").replace("runs: %d" % RUNS, "runs: 2")
        for program in programs:
            with self.subTest(program):
                file = self.place("%d.sqlite" % programs.index(program))
                done = subprocess.run([sys.executable, program, self.plan(text=text), "--workers", "1", "--results", file], capture_output=True, text=True, cwd=self.folder,
                                      timeout=PATIENCE, check=False)
                self.assertEqual((0, "%s: 2 runs, 2 to do\n2 of 2 runs are in the results: 2 good\n" % file), (done.returncode, done.stdout), done.stderr)
                self.assertNotIn("Traceback", done.stderr)

    # --- the same results

    def test_results_are_the_same_by_one_two_and_four_workers(self):
        for workers in (2, 4):
            status, out, told = self.run_to_its_end(self.plan(), "--workers", str(workers), "--results", self.place("%d.sqlite" % workers))
            self.assertEqual(1, status, told)
            self.assertIn("%d of %d runs are in the results" % (RUNS, RUNS), out)
            self.assertEqual(self.undisturbed(), self.csv("%d.csv" % workers))
        for said in (",good,", ",controller,", ",refused,"):
            self.assertIn(said, self.undisturbed())

    def test_what_is_done_is_not_done_again(self):
        before = self.undisturbed()
        shutil.copy(self.place("undisturbed.sqlite"), self.place("plan.sqlite"))
        status, out, told = self.run_to_its_end(self.plan(), "--workers", "2")
        self.assertEqual(1, status, told)
        self.assertIn("%d runs, 0 to do" % RUNS, out)
        more = PLAN.replace("runs: %d" % RUNS, "runs: %d" % (RUNS + 1)).replace("latin_hypercube", "sobol")
        self.run_to_its_end(self.plan(text=more), "--workers", "1")
        status, out, _ = self.run_to_its_end(self.plan(text=more.replace("runs: 13", "runs: 15")), "--workers", "1")
        self.assertIn("15 runs, 2 to do", out)
        self.run_to_its_end(self.plan(), "--workers", "1")
        self.assertEqual(before, self.csv("plan.csv"))

    # --- killed workers

    def test_a_client_that_is_killed_loses_nothing(self):
        client = self.start(self.slow_plan(), "--workers", "2")
        self.wait(lambda: self.rows_in("plan.sqlite") > 2, "a few rows")
        client.kill()
        self.go_on()
        client.communicate()
        there = self.rows_in("plan.sqlite")
        self.assertLess(there, RUNS)
        status, out, told = self.run_to_its_end(self.plan(), "--workers", "1")
        self.assertEqual(1, status, told)
        to_do = int(re.search(r"runs, (\d+) to do", out).group(1))
        self.assertEqual((RUNS, RUNS), (there + to_do, self.rows_in("plan.sqlite")))
        self.assertEqual(self.undisturbed(), self.csv("plan.csv"))

    def test_all_listens_on_localhost_alone_and_a_signal_ends_it_and_the_same_command_goes_on(self):
        client = self.start(self.slow_plan(), "--workers", "1")
        self.wait(lambda: self.rows_in("plan.sqlite") > 0, "a row")
        self.assertEqual({"0100007F"}, listening_addresses(client.pid))
        client.send_signal(signal.SIGINT)
        _, told = client.communicate(timeout=PATIENCE)
        self.assertEqual(3, client.returncode)
        self.assertIn("the same command continues", told)

    def test_ctrl_c_ends_it_without_a_traceback_and_what_was_left_behind_is_no_news(self):
        """A terminal sends it to workers and runners too."""
        client = self.start(self.slow_plan(), "--workers", "2", start_new_session=True)
        self.wait(lambda: self.rows_in("plan.sqlite") > 0, "a row")
        os.killpg(client.pid, signal.SIGKILL)
        client.communicate()
        client = self.start(self.slow_plan(), "--workers", "2", start_new_session=True)
        there = self.rows_in("plan.sqlite")
        self.wait(lambda: self.rows_in("plan.sqlite") > there, "a row more")
        os.killpg(client.pid, signal.SIGINT)
        _, told = client.communicate(timeout=PATIENCE)
        self.assertEqual(3, client.returncode, told)
        self.assertEqual([], [line for line in told.splitlines() if not re.match(r"\d+ of \d+ done, |drill_campaign: stopped: ", line)])

    def cluster(self):
        """Scheduler and two workers, as by hand; address and processes."""
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        address = "tcp://127.0.0.1:%d" % port
        log = open(self.place("cluster.log"), "a", encoding="utf-8")
        self.addCleanup(log.close)
        commands = [["distributed.cli.dask_scheduler", "--host", "127.0.0.1", "--port", str(port), "--no-dashboard"]] + 2 * [
            ["distributed.cli.dask_worker", address, "--nthreads", "1", "--no-dashboard", "--host", "127.0.0.1", "--death-timeout", "30"]]
        started = [subprocess.Popen([sys.executable, "-m", *words], cwd=self.folder, stdout=log, stderr=log,
                                    env=dict(os.environ, DASK_DISTRIBUTED__WORKER__DAEMON="False")) for words in commands]
        self.processes += started
        return address, started

    def test_a_worker_that_is_killed_loses_nothing(self):
        address, cluster = self.cluster()
        client = self.start(self.slow_plan(), "--scheduler", address)
        self.wait(lambda: self.rows_in("plan.sqlite") > 1, "a few rows")
        pids = subprocess.run(["pgrep", "-P", str(cluster[1].pid)], capture_output=True, text=True, check=False).stdout.split()
        for pid in [cluster[1].pid, *map(int, pids)]:
            try:
                os.kill(pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
        self.go_on()
        _, told = client.communicate(timeout=PATIENCE)
        self.assertEqual((1, RUNS), (client.returncode, self.rows_in("plan.sqlite")), told)
        self.assertEqual(self.undisturbed(), self.csv("plan.csv"))

    def test_a_scheduler_that_is_killed_loses_nothing(self):
        address, cluster = self.cluster()
        client = self.start(self.slow_plan(), "--scheduler", address)
        self.wait(lambda: self.rows_in("plan.sqlite") > 1, "a few rows")
        cluster[0].kill()
        self.go_on()
        _, told = client.communicate(timeout=PATIENCE)
        self.assertEqual(3, client.returncode, told)
        there = self.rows_in("plan.sqlite")
        status, out, told = self.run_to_its_end(self.plan(), "--workers", "1")
        self.assertEqual(1, status, told)
        self.assertIn("%d to do" % (RUNS - there), out)
        self.assertEqual(RUNS, self.rows_in("plan.sqlite"))

    def test_a_run_that_kills_its_workers_is_a_row(self):
        text = PLAN.replace("values: [\"\", error]", "values: [\"\", kill_worker]").replace("values: [0.2, -1.0, 0.3]", "values: [0.2]").replace("runs: 12", "runs: 2")
        # two deaths instead of Dask's four blame a run; a worker that is not back at once must not be given up
        told_to_dask = {"DASK_DISTRIBUTED__SCHEDULER__ALLOWED_FAILURES": "1", "DASK_DISTRIBUTED__DEPLOY__LOST_WORKER_TIMEOUT": "10ms"}
        status, out, told = self.run_to_its_end(self.plan(text=text), "--workers", "1", env=dict(os.environ, **told_to_dask))
        self.assertEqual(1, status, told)
        self.assertIn("1 died, 1 good", out)

    # --- other machines

    def test_other_machines_are_asked_for_tls(self):
        for k, (address, said) in enumerate((("tcp://192.0.2.7:8786", "is another machine: needed: tls://"), ("http://localhost:1", "is not an address"), ("tcp://localhost", "is not an address"))):
            status, _, told = drill_campaign(self.plan(), "--scheduler", address, "--results", self.place("%d.sqlite" % k))
            self.assertEqual(3, status)
            self.assertIn(said, told)

    def test_slurm_starts_and_ends_the_workers(self):
        certificate = self.place("certificate.pem")
        subprocess.run(["openssl", "req", "-x509", "-newkey", "rsa:2048", "-nodes", "-keyout", certificate, "-out", self.place("c"), "-days", "1", "-subj", "/CN=localhost"],
                       check=True, capture_output=True)
        with open(certificate, "a", encoding="ascii") as out, open(self.place("c"), encoding="ascii") as more:
            out.write(more.read())
        for name, text in (("sbatch", SBATCH), ("scancel", "#!/bin/sh\necho $1 >$0.job\nkill $(cat ${0%scancel}sbatch.pids) || true\n")):
            with open(self.place(name), "w", encoding="utf-8") as out:
                out.write(text)
            os.chmod(self.place(name), 0o755)
        tls = {"DASK_DISTRIBUTED__COMM__TLS__%s" % name: certificate for name in ("CA_FILE", "SCHEDULER__CERT", "WORKER__CERT", "CLIENT__CERT")}
        path = {"PATH": self.folder + ":" + os.environ["PATH"]}
        status, _, told = self.run_to_its_end(self.plan(), "--slurm", "2", env=dict(os.environ, **path))
        self.assertEqual(3, status)
        self.assertIn("needed: certificates", told)
        status, out, told = self.run_to_its_end(self.plan(), "--slurm", "2", env=dict(os.environ, DASK_DISTRIBUTED__WORKER__DAEMON="False", **path, **tls))
        self.assertEqual(1, status, told)
        self.assertIn("%d of %d runs are in the results" % (RUNS, RUNS), out)
        with open(self.place("scancel.job"), encoding="ascii") as job:
            self.assertEqual("4711", job.read().strip())
        with open(self.place("sbatch.command"), encoding="ascii") as script:
            self.assertIn("dask_worker tls://", script.read())

    def test_the_script_asks_slurm_for_what_it_needs(self):
        script = engine.slurm_script(12, "tls://node1:8786")
        self.assertTrue(script.startswith("#!/bin/sh\n#SBATCH "))
        self.assertIn("--ntasks=12", script)
        self.assertIn("dask_worker tls://node1:8786", script)


def listening_addresses(top):
    """Where a process and all below it listen, in the kernel's hexadecimal."""
    with open("/proc/%d/net/tcp" % top, encoding="ascii") as table:
        listening = {line.split()[9]: line.split()[1] for line in table if line.split()[3] == "0A"}
    ours = {os.readlink(link)[8:-1] for pid in [top, *children(top)] for link in links(pid) if os.readlink(link).startswith("socket:")}
    return {address.split(":")[0] for inode, address in listening.items() if inode in ours}


def children(pid):
    found = subprocess.run(["pgrep", "-P", str(pid)], capture_output=True, text=True, check=False).stdout.split()
    return [int(child) for child in found] + [grandchild for child in found for grandchild in children(int(child))]


def links(pid):
    folder = "/proc/%d/fd" % pid
    return [os.path.join(folder, name) for name in os.listdir(folder) if os.path.islink(os.path.join(folder, name))]


if __name__ == "__main__":
    unittest.main()
