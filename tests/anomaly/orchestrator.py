"""What the tests of the orchestrator share: a folder of their own, the program, a solver
that does as it is told (fake_solver.cpp), and the content of a database."""
import fcntl
import json
import os
import pathlib
import shutil
import signal
import sqlite3
import struct
import subprocess
import tempfile
import time
import unittest

PROGRAM = os.environ["PORECLOG"]
FAKE_SOLVER = os.environ["FAKE_SOLVER"]

# Everything that the campaign determines; not what depends on the day: attempts, times.
CONTENT = [
    "SELECT name, description, master_seed, independent_points, realisations, statistics"
    " FROM campaign ORDER BY name",
    "SELECT campaign, point, tier, varied, point_hash, scene_hash FROM v_point"
    " ORDER BY 1, 2, 3",
    "SELECT campaign, point, idx, seed, tier, status, t1_s, tc_s, censored, alpha_deg,"
    " lc_end_m, permeability_ratio_end, injected, retained, traversed, last_traversal_s,"
    " duration_s, ending FROM v_realisation ORDER BY 1, 2, 5, 3",
    "SELECT * FROM v_retained ORDER BY 1, 2, 4, 3, 5",
    "SELECT * FROM v_series ORDER BY 1, 2, 4, 3, 5",
    "SELECT * FROM v_curve ORDER BY 1, 2, 3, 4",
    "SELECT * FROM v_layer ORDER BY 1, 2, 3, 4, 5",
]


class Bench(unittest.TestCase):
    """A test with a folder, a database and runs of its own."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="poreclog-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        self.database = self.folder / "db.sqlite"
        self.runs = self.folder / "runs"
        self.started = []
        self.addCleanup(self.stop_all)

    def stop_all(self):
        for process in self.started:
            if process.poll() is None:
                process.kill()
                process.wait()
        self.kill_attempts()

    def attempts(self, campaign="c"):
        """Process ids of the keepers of the attempts that are running."""
        found = []
        for lock in (self.runs / campaign).glob("p*/*/attempt-*/lock"):
            words = lock.read_text().split()
            if (len(words) >= 2 and words[0].isdigit() and is_held(lock)
                    and is_keeper(int(words[0]))):
                found.append(int(words[0]))
        return found

    def kill_attempts(self):
        for keeper in self.attempts():
            kill(keeper)

    def write(self, name="c", file="c.json", **keys):
        campaign = {"campaign": name, "scene": {"duration": "5 s"}, "realisations": 6,
                    "master_seed": 7,
                    "limits": {"workers": 2, "seconds_per_realisation": 20, "attempts": 3,
                               "seconds_to_stop": 5}}
        for key, value in keys.items():
            if key == "limits":
                campaign["limits"].update(value)
            else:
                campaign[key] = value
        path = self.folder / file
        path.write_text(json.dumps(campaign, indent=1))
        return str(path)

    def command(self, *words, database=None, runs=None):
        words = [str(w) for w in words]
        return [PROGRAM, *words, "--database", str(database or self.database), "--runs",
                str(runs or self.runs)]

    def environment(self, fake):
        kept = {k: v for k, v in os.environ.items() if not k.startswith("FAKE_")}
        return {**kept, "PORECLOG_SOLVER": FAKE_SOLVER, "PORECLOG_NO_REPORT": "1",
                **{"FAKE_" + k: str(v) for k, v in fake.items()}}

    def poreclog(self, *words, code=0, database=None, runs=None, prefix=(), **fake):
        """Runs the program to its end; `fake`: the solver's variables without FAKE_."""
        done = subprocess.run([*prefix, *self.command(*words, database=database, runs=runs)],
                              env=self.environment(fake), capture_output=True, text=True,
                              timeout=120, errors="replace")
        if code is not None:
            self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done

    def start(self, *words, **fake):
        process = subprocess.Popen(self.command(*words), env=self.environment(fake),
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.started.append(process)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.stderr.close)
        return process

    def ask(self, sql, database=None):
        with sqlite3.connect(f"file:{database or self.database}?mode=ro", uri=True) as db:
            return db.execute(sql).fetchall()

    def content(self, database=None):
        return [self.ask(sql, database) for sql in CONTENT]

    def undisturbed(self, campaign_file):
        """The content after a run in which nothing goes wrong."""
        database = self.folder / "undisturbed.sqlite"
        self.poreclog("run", campaign_file, database=database,
                      runs=self.folder / "undisturbed-runs")
        return self.content(database)

    def wait_until(self, condition, seconds=20):
        end = time.monotonic() + seconds
        while not condition():
            self.assertLess(time.monotonic(), end, "waited in vain")
            time.sleep(0.01)


def is_held(lock):
    """Does another process hold the lock on this file?"""
    with open(lock, encoding="utf-8") as file:
        asked = struct.pack("hhqqi4x", fcntl.F_WRLCK, os.SEEK_SET, 0, 0, 0)
        answer = fcntl.fcntl(file, fcntl.F_OFD_GETLK, asked)
    return struct.unpack("hhqqi4x", answer)[0] != fcntl.F_UNLCK


def is_keeper(process):
    try:
        return b"poreclog-attempt" in pathlib.Path(f"/proc/{process}/cmdline").read_bytes()
    except OSError:
        return False


def children(process):
    try:
        text = pathlib.Path(f"/proc/{process}/task/{process}/children").read_text()
    except OSError:
        return []
    return [int(word) for word in text.split()]


def kill(process, how=signal.SIGKILL):
    try:
        os.kill(process, how)
    except ProcessLookupError:
        pass
