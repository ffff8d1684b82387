"""run and resume --dry-run: says of every realisation what would be done with it and why,
agrees with what the next run then does, and leaves no trace.

Uses the solver of tests/anomaly, which takes milliseconds and fails as it is told."""
import json
import pathlib
import shutil
import signal
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "anomaly"))
import orchestrator


class DryRun(orchestrator.Bench):
    def dry_run(self, *words, **fake):
        """{reason: (action, indices)} of the only ensemble, and the whole answer."""
        before = self.state()
        answer = json.loads(self.poreclog(*words, "--dry-run", "--json", **fake).stdout)
        self.assertEqual(self.state(), before, "a dry run left a trace")
        self.assertEqual(answer["schema_version"], 1)
        self.assertEqual(len(answer["ensembles"]), 1)
        classes = {c["reason"]: (c["action"], self.spread(c)) for c in
                   answer["ensembles"][0]["classes"]}
        self.assertEqual(answer["to_run"],
                         sum(len(i) for a, i in classes.values() if a == "run"))
        self.assertEqual(sorted(i for _, some in classes.values() for i in some),
                         list(range(answer["realisations"])))
        return classes

    def spread(self, one):
        indices = [i for first, last in one["indices"] for i in range(first, last + 1)]
        self.assertEqual(len(indices), one["count"])
        return indices

    def state(self):
        """Names and sizes of all files, and the database's rows of attempts and status."""
        files = sorted((str(p), p.stat().st_size) for p in self.folder.rglob("*")
                       if not p.name.endswith(("-shm", "-wal")))
        rows = self.ask("SELECT * FROM v_attempt") + self.ask(
            "SELECT idx, status FROM v_realisation") if self.database.exists() else []
        return files, rows

    def started(self):
        return {int(p.name) for p in self.runs.glob("c/p0000-one_way/0*")}

    def test_of_a_new_campaign_would_run_all(self):
        campaign = self.write(realisations=4)
        self.assertEqual(self.dry_run("run", campaign), {"never_tried": ("run", [0, 1, 2, 3])})
        self.assertFalse(self.runs.exists())
        self.assertFalse(self.database.exists())
        self.poreclog("resume", campaign, "--dry-run", code=1)  # there is nothing to resume
        text = self.poreclog("run", campaign, "--dry-run").stdout
        self.assertIn("c: 4 of 4 realisations would be run", text)
        self.assertIn("never tried  [0-3]", text)

    def test_skips_what_is_ingested_or_failed(self):
        campaign = self.write(realisations=12)
        self.poreclog("run", campaign, code=2, FAULT="refuse", ONE_IN=3)
        failed = [i for i, in self.ask("SELECT idx FROM v_realisation WHERE status = "
                                       "'failed' ORDER BY idx")]
        done = [i for i in range(12) if i not in failed]
        self.assertTrue(failed and done)
        expected = {"ingested": ("skip", done), "failed": ("skip", failed)}
        self.assertEqual(self.dry_run("resume", "c"), expected)
        self.assertEqual(self.dry_run("extend", "c", "--by", 2),
                         {**expected, "never_tried": ("run", [12, 13])})

    def test_counts_failed_attempts_and_interruptions(self):
        campaign = self.write(realisations=3, limits={"workers": 3})
        process = self.start("run", campaign, SECONDS=5)
        self.wait_until(lambda: len(self.attempts()) == 3)
        self.wait_until(lambda: self.ask("SELECT count(*) FROM v_attempt") == [(3,)])
        running = self.dry_run("run", campaign)
        self.assertEqual(running, {"running": ("take_over", [0, 1, 2])})
        process.send_signal(signal.SIGINT)
        process.wait(timeout=20)
        # the record of one says that it failed by itself
        ending = self.runs / "c/p0000-one_way/000001/attempt-001/ending.json"
        record = json.loads(ending.read_text())
        ending.write_text(json.dumps({**record, "stopped": None, "exit_code": 4}))
        self.database.unlink()
        for leftover in self.folder.glob("db.sqlite-*"):
            leftover.unlink()
        classes = self.dry_run("resume", "c")
        self.assertEqual(classes, {"interrupted": ("run", [0, 2]),
                                   "attempts_left": ("run", [1])})
        text = self.poreclog("resume", "c", "--dry-run").stdout
        self.assertIn("1 of 3 attempts failed (internal_error); goes on from its checkpoint",
                      text)

    def test_finds_results_that_are_not_in_the_database(self):
        campaign = self.write(realisations=4)
        self.poreclog("run", campaign)
        for file in self.folder.glob("db.sqlite*"):
            file.unlink()
        shutil.rmtree(self.runs / "c/p0000-one_way/000002")
        self.assertEqual(self.dry_run("resume", "c"),
                         {"result_on_disk": ("ingest", [0, 1, 3]),
                          "never_tried": ("run", [2])})
        self.poreclog("resume", "c")
        attempts = self.ask("SELECT idx, count(*) FROM v_attempt GROUP BY idx")
        self.assertEqual(attempts, [(i, 1) for i in range(4)])
        self.assertEqual(self.dry_run("resume", "c"), {"ingested": ("skip", [0, 1, 2, 3])})

    def test_knows_what_may_run_elsewhere(self):
        campaign = self.write(realisations=1)
        process = self.start("run", campaign, SECONDS=5)
        self.wait_until(self.attempts)
        process.kill()
        process.wait()
        self.kill_attempts()
        self.wait_until(lambda: self.attempts() == [])
        lock = self.runs / "c/p0000-one_way/000000/attempt-001/lock"
        lock.write_text("1 elsewhere\n")
        self.assertEqual(self.dry_run("resume", "c"), {"unknown": ("skip", [0])})


class TemporaryFiles(orchestrator.Bench):
    def test_are_not_left_by_a_killed_check_because_there_are_none(self):
        """The solver, asked to describe a scene, kills whoever asked."""
        places = self.folder / "temporary"
        places.mkdir()
        killer = self.folder / "killer"
        killer.write_text(f"#!/bin/sh\nls {places} >>{self.folder}/seen\nkill -9 $PPID\n")
        killer.chmod(0o755)
        campaign = self.write()
        done = self.poreclog("check", campaign, code=-signal.SIGKILL, prefix=[
            "env", f"PORECLOG_SOLVER={killer}", f"TMPDIR={places}"])
        self.assertEqual(done.stdout, "")
        self.assertEqual((self.folder / "seen").read_text(), "")
        self.assertEqual(list(places.iterdir()), [])


if __name__ == "__main__":
    unittest.main()
