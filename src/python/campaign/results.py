# SPDX-License-Identifier: BSD-3-Clause
"""A campaign's results: one SQLite file, a row a run. What is in it stays, however the campaign ends."""
import contextlib
import csv
import fcntl
import json
import sqlite3
import time

SCHEMA = 2
PATIENCE = 30.0  # so long another program may hold the file [s]
TABLES = """
create table campaign (name text primary key, value text) without rowid;
create table planned (number integer primary key, key text);
create table runs (key text primary key, "values" text, status text, reason text, outputs text, cpu real, worker text, at real) without rowid;
"""
RUNS, AUDITS = "runs", "audits"  # tables of the same columns: an audit's status is its verdict, its outputs are what was found
AUDITS_TABLE = 'create table if not exists audits (key text primary key, "values" text, status text, reason text, outputs text, cpu real, worker text, at real) without rowid'


class ResultsError(Exception):
    """What is wrong with a results' file, in one line."""


class Locked(ResultsError):
    """Another program holds the file; what was to be done can be done later."""


class Results:
    """Opens the file, or makes it. What it says of itself (`about`) is the newest plan's: name, text, factors, outputs. One process writes, any number read."""

    def __init__(self, file, write=True):
        self.file, self.lock = file, None
        try:
            self.data = sqlite3.connect("file:%s?mode=%s" % (file.replace("?", "%3f").replace("#", "%23"), "rwc" if write else "ro"), uri=True, timeout=PATIENCE)
            version = self.data.execute("pragma user_version").fetchone()[0]
            if write and version == 0 and not self.data.execute("select count(*) from sqlite_master").fetchone()[0]:
                self.data.executescript("begin; %s pragma user_version = %d; commit;" % (TABLES, SCHEMA))
                version = SCHEMA
        except sqlite3.Error as error:
            raise ResultsError("%s: %s" % (file, error))
        if version != SCHEMA:
            self.data.close()
            raise ResultsError("%s: is not a results file of a campaign%s" % (file, " of version %d" % SCHEMA if version else ""))
        if write:
            self.take_lock()
            with self.asked(), self.data:
                self.data.execute(AUDITS_TABLE)  # files of 0.2 have none

    def take_lock(self):
        """Two campaigns that write one file would do runs twice."""
        try:
            self.lock = open(self.file, "rb")  # pylint: disable=consider-using-with
            fcntl.flock(self.lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            self.close()
            raise ResultsError("%s: another campaign is writing it" % self.file)

    @contextlib.contextmanager
    def asked(self, patience=None):
        """Around what is asked of the file: what goes wrong as a ResultsError. `patience`: so long another program may hold it [s], by default PATIENCE."""
        try:
            self.data.execute("pragma busy_timeout = %d" % (1e3 * (PATIENCE if patience is None else patience)))
            yield
        except sqlite3.Error as error:
            if "locked" in str(error):
                raise Locked("%s: another program reads or writes it and holds it locked" % self.file) from error
            raise ResultsError("%s: %s" % (self.file, error)) from error

    def describe(self, planned, **about):
        """The plan from now on: its runs' keys in order, and what is said of it. Runs of older plans stay, unseen."""
        with self.asked(), self.data:
            self.data.execute("delete from planned")
            self.data.executemany("insert into planned values (?, ?)", enumerate(planned))
            self.data.executemany("insert or replace into campaign values (?, ?)", [(name, json.dumps(value)) for name, value in about.items()])

    def about(self):
        with self.asked():
            return {name: json.loads(value) for name, value in self.data.execute("select name, value from campaign")}

    def done(self, table=RUNS):
        """Keys of the runs that are there, or of those that were audited."""
        with self.asked():
            return {key for key, in self.data.execute("select key from %s" % table)}

    def forget_bad(self, keys):
        """Of these runs and audits those that did not end well: to do them again."""
        with self.asked(), self.data:
            self.data.executemany("delete from runs where key = ? and status <> 'good'", [(key,) for key in keys])
            self.data.executemany("delete from audits where key = ? and reason <> ''", [(key,) for key in keys])

    def add(self, rows, patience=None, table=RUNS):
        """Of (key, values, status, reason, outputs, cpu, worker), all or none; a key that is there stays as it is. Locked after `patience` [s]."""
        with self.asked(patience), self.data:
            self.data.executemany("insert or ignore into %s values (?, ?, ?, ?, ?, ?, ?, ?)" % table,
                                  [(key, json.dumps(values), status, reason, json.dumps(outputs, allow_nan=False), cpu, worker, time.time())
                                   for key, values, status, reason, outputs, cpu, worker in rows])

    def audits(self):
        """As rows(), of the plan's runs that were audited."""
        with self.asked():
            there = self.data.execute("select count(*) from sqlite_master where name = ?", (AUDITS,)).fetchone()[0]
        return self.rows(AUDITS) if there else iter(())

    def rows(self, table=RUNS):
        """Dictionaries of the plan's runs that are there, in its order."""
        names = ("number", "key", "values", "status", "reason", "outputs", "cpu")
        with self.asked():
            for row in self.data.execute('select number, key, "values", status, reason, outputs, cpu from planned join %s using (key) order by number' % table):
                found = dict(zip(names, row))
                yield {**found, "values": json.loads(found["values"]), "outputs": json.loads(found["outputs"])}

    def write_csv(self, file):
        """Number, factors, status, reason, outputs, in the plan's order: the same for the same results."""
        about = self.about()
        with open(file, "w", newline="", encoding="utf-8") as text:
            out = csv.writer(text)
            out.writerow(["number", *about["factors"], "status", "reason", *about["outputs"]])
            for row in self.rows():
                out.writerow([row["number"], *row["values"], row["status"], row["reason"], *(row["outputs"].get(name) for name in about["outputs"])])

    def close(self):
        self.data.close()
        if self.lock is not None:
            self.lock.close()  # not before: it would take SQLite's own locks away
