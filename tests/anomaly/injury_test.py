"""The orchestrator, injured in every way but kill -9 (kill_test.py): solvers that fail,
results that are torn, foreign, duplicate, late or contradicting, disks that are full,
databases that are locked, deleted or of another version, clocks that are set back, and
names that mean harm.

Each test says what must hold afterwards; most compare the database with that of a run in
which nothing went wrong."""
import csv
import io
import json
import os
import pathlib
import shutil
import signal
import sqlite3
import subprocess
import time
import unittest

import orchestrator
from orchestrator import children, kill

FAKE_CLOCK = os.environ.get("FAKE_CLOCK", "")


class Solver(orchestrator.Bench):
    def causes(self):
        return sorted(row[0] for row in self.ask("SELECT cause FROM v_attempt"))

    def test_that_fails_once_is_tried_again_and_changes_nothing(self):
        for fault, cause in [("torn", "torn_result"), ("incomplete", "torn_result"),
                             ("foreign_seed", "foreign_result"),
                             ("foreign_scene", "foreign_result"),
                             ("foreign_tier", "foreign_result"), ("crash", "crashed"),
                             ("abort_exit", "internal_error"), ("no_file", "no_result"),
                             ("nonsense", "internal_error"), ("exit_5", "killed")]:
            with self.subTest(fault):
                self.database = self.folder / (fault + ".sqlite")
                self.runs = self.folder / fault
                campaign = self.write()
                self.poreclog("run", campaign, FAULT=fault, ATTEMPTS=1)
                self.assertEqual(self.causes(), sorted([cause] * 6 + ["finished"] * 6))
                shutil.rmtree(self.folder / "undisturbed-runs", ignore_errors=True)
                (self.folder / "undisturbed.sqlite").unlink(missing_ok=True)
                self.assertEqual(self.content(), self.undisturbed(campaign))

    def test_that_always_fails_uses_up_its_attempts(self):
        campaign = self.write()
        done = self.poreclog("run", campaign, "--json", code=2, FAULT="torn", ONE_IN=2)
        failed = json.loads(done.stdout)["failed"]
        self.assertGreater(failed, 0)
        self.assertEqual(self.causes().count("torn_result"), 3 * failed)
        self.assertEqual(self.ask("SELECT count(*) FROM v_realisation WHERE status = "
                                  "'failed' AND (tc_s NOTNULL OR censored NOTNULL)"), [(0,)])
        # resume does not try them again, retry does
        self.poreclog("resume", campaign, code=2)
        self.assertEqual(self.causes().count("torn_result"), 3 * failed)
        self.poreclog("retry", campaign, "--failed")
        self.assertEqual(self.content(), self.undisturbed(campaign))

    def test_that_refuses_or_does_not_converge_is_not_tried_again(self):
        for fault, cause in [("refuse", "refused"), ("not_converged", "not_converged")]:
            with self.subTest(fault):
                self.database = self.folder / (fault + ".sqlite")
                self.runs = self.folder / fault
                self.poreclog("run", self.write(), code=2, FAULT=fault)
                self.assertEqual(self.causes(), [cause] * 6)
        message = self.ask("SELECT DISTINCT message FROM v_attempt")
        self.assertEqual(message, [("fake solver: not_converged as asked",)])

    def test_that_refuses_a_checkpoint_begins_anew(self):
        campaign = self.write(realisations=1)
        self.poreclog("run", campaign, code=2, FAULT="refuse")
        self.poreclog("retry", campaign, code=2, FAULT="refuse")
        (self.runs / "c/p0000-one_way/000000/checkpoint.h5").write_text("5")
        self.poreclog("retry", campaign, FAULT="refuse", ATTEMPTS=3)
        kinds = self.ask("SELECT kind FROM v_incident")
        self.assertEqual(kinds, [("checkpoint_refused",)])

    def test_that_hangs_is_stopped_at_its_time_limit(self):
        for fault, number in [("hang", None), ("ignore_term", signal.SIGKILL)]:
            with self.subTest(fault):
                self.database = self.folder / (fault + ".sqlite")
                self.runs = self.folder / fault
                campaign = self.write(realisations=2, limits={
                    "seconds_per_realisation": 1.0, "seconds_to_stop": 0.5})
                begin = time.monotonic()
                self.poreclog("run", campaign, FAULT=fault, ATTEMPTS=1)
                self.assertLess(time.monotonic() - begin, 15)
                self.assertEqual(self.causes(), ["finished"] * 2 + ["time_limit"] * 2)
                rows = self.ask("SELECT signal FROM v_attempt WHERE cause = 'time_limit'")
                self.assertEqual(rows, [(number,)] * 2)

    def test_time_limit_holds_without_the_orchestrator(self):
        campaign = self.write(realisations=1, limits={"seconds_per_realisation": 1.0,
                                                     "seconds_to_stop": 0.3})
        process = self.start("run", campaign, FAULT="ignore_term")
        self.wait_until(self.attempts)
        process.kill()
        process.wait()
        attempt = self.runs / "c/p0000-one_way/000000/attempt-001"
        self.wait_until((attempt / "ending.json").exists)
        ending = json.loads((attempt / "ending.json").read_text())
        self.assertEqual((ending["stopped"], ending["signal"]), ("time_limit", 9))
        self.poreclog("resume", campaign)

    def test_that_does_not_exist_stops_the_campaign(self):
        campaign = self.write()
        self.poreclog("run", campaign, code=1, prefix=["env", "PORECLOG_SOLVER=/nowhere"])
        broken = self.folder / "broken"
        broken.write_text(f"#!/bin/sh\n[ $1 = describe ] && exec {orchestrator.FAKE_SOLVER} "
                          "\"$@\"\nexit 127\n")
        broken.chmod(0o755)
        done = self.poreclog("run", campaign, code=3,
                             prefix=["env", f"PORECLOG_SOLVER={broken}"])
        self.assertIn("cannot be started", done.stdout)
        self.assertLessEqual(len(self.causes()), 4)


class Orchestrator(orchestrator.Bench):
    def test_stops_politely_and_goes_on_from_checkpoints(self):
        campaign = self.write(realisations=4)
        process = self.start("run", campaign, SECONDS=2)
        self.wait_until(lambda: len(self.attempts()) == 2)
        time.sleep(0.5)
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(timeout=10), 4)
        self.assertIn("interrupted; `poreclog resume c` goes on", process.stdout.read())
        self.assertEqual(self.attempts(), [])
        checkpoints = list(self.runs.glob("c/p*/*/checkpoint.h5"))
        self.assertEqual(len(checkpoints), 2)
        self.assertTrue(all(int(c.read_text()) > 0 for c in checkpoints))
        self.assertEqual(self.ask("SELECT DISTINCT cause FROM v_attempt"), [("interrupted",)])
        self.assertEqual(self.ask("SELECT DISTINCT status FROM v_realisation"),
                         [("eligible",)])
        self.poreclog("resume", "c", SECONDS=0.1)
        self.assertEqual(list(self.runs.glob("c/p*/*/checkpoint.h5")), [])
        self.assertEqual(self.content(), self.undisturbed(campaign))

    def test_stops_at_once_at_the_second_signal(self):
        process = self.start("run", self.write(), FAULT="ignore_term")
        self.wait_until(lambda: len(self.attempts()) == 2)
        time.sleep(1.0)  # until the solvers ignore the signal
        process.terminate()
        time.sleep(0.3)
        self.assertIsNone(process.poll())
        begin = time.monotonic()
        process.terminate()
        self.assertEqual(process.wait(timeout=10), 4)
        self.assertLess(time.monotonic() - begin, 3)

    def test_takes_over_what_a_killed_one_left_running(self):
        campaign = self.write(realisations=2)
        process = self.start("run", campaign, SECONDS=1.5)
        self.wait_until(lambda: len(self.attempts()) == 2)
        process.kill()
        process.wait()
        self.poreclog("resume", campaign, SECONDS=1.5)
        self.assertEqual(self.ask("SELECT number, cause FROM attempt"), [(1, "finished")] * 2)

    def test_second_one_is_refused_and_a_stale_lock_is_not(self):
        campaign = self.write()
        process = self.start("run", campaign, SECONDS=1)
        self.wait_until(self.attempts)
        done = self.poreclog("run", campaign, code=1)
        self.assertIn("another poreclog is at work", done.stderr)
        self.assertIn(str(process.pid), done.stderr)
        process.kill()
        process.wait()
        done = self.poreclog("run", campaign)
        self.assertIn("the last poreclog on this campaign was killed", done.stderr)

    def test_is_cancelled_from_another_terminal(self):
        process = self.start("run", self.write(), SECONDS=3)
        self.wait_until(lambda: len(self.attempts()) == 2)
        self.poreclog("cancel", "c")
        self.assertEqual(process.wait(timeout=5), 4)
        self.assertEqual(self.attempts(), [])
        process = self.start("run", self.folder / "c.json", SECONDS=3)
        self.wait_until(lambda: len(self.attempts()) == 2)
        process.kill()
        process.wait()
        orphans = json.loads(self.poreclog("cancel", "c", "--json").stdout)
        self.assertEqual(orphans["orphans_stopped"], 2)
        self.wait_until(lambda: self.attempts() == [])

    def test_does_not_start_again_what_may_run_on_another_machine(self):
        campaign = self.write(realisations=1)
        process = self.start("run", campaign, SECONDS=5)
        self.wait_until(self.attempts)
        process.kill()
        process.wait()
        self.kill_attempts()
        lock = self.runs / "c/p0000-one_way/000000/attempt-001/lock"
        self.wait_until(lambda: self.attempts() == [])
        lock.write_text("1 elsewhere\n")
        self.poreclog("resume", campaign, code=3)
        self.assertEqual(self.ask("SELECT status FROM v_realisation"), [("unknown",)])
        status = json.loads(self.poreclog("status", "c", "--json").stdout)
        self.assertEqual(status["total"]["unknown"], 1)
        self.poreclog("retry", "c", "--unknown")

    def test_is_not_confused_by_a_clock_that_goes_backwards(self):
        if not FAKE_CLOCK:
            self.skipTest("FAKE_CLOCK names no library")
        campaign = self.write()
        self.poreclog("run", campaign, prefix=["env", "LD_PRELOAD=" + FAKE_CLOCK],
                      FAULT="crash", ATTEMPTS=1)
        rows = self.ask("SELECT min(ended < started) FROM v_attempt")
        self.assertEqual(rows, [(1,)], "the clock did not go backwards")
        self.assertEqual(self.ask("SELECT min(wall_s) >= 0, max(wall_s) < 60 FROM v_attempt"),
                         [(1, 1)])
        self.assertEqual(self.content(), self.undisturbed(campaign))


class Result(orchestrator.Bench):
    def copy_attempt(self, source, number):
        target = source.parent / f"attempt-{number:03}"
        shutil.copytree(source, target)
        (target / "lock").unlink()

    def test_that_comes_twice_is_noted_and_changes_nothing(self):
        campaign = self.write()
        self.poreclog("run", campaign)
        before = self.content()
        self.copy_attempt(self.runs / "c/p0000-one_way/000002/attempt-001", 2)
        self.poreclog("repair")
        self.assertEqual(self.content(), before)
        self.assertEqual(self.ask("SELECT idx, attempt, kind FROM v_incident"),
                         [(2, 2, "duplicate")])

    def test_that_comes_late_is_compared(self):
        # Attempt 1 is taken for lost while its machine cannot be reached; attempt 2
        # finishes; then the result of attempt 1 turns up.
        campaign = self.write(realisations=1)
        self.poreclog("run", campaign)
        self.copy_attempt(self.runs / "c/p0000-one_way/000000/attempt-001", 2)
        with sqlite3.connect(self.database) as db:
            db.execute("INSERT INTO attempt (realisation, number, cause, command) "
                       "SELECT id, 2, 'running', '' FROM realisation")
        self.poreclog("resume", campaign)
        self.assertEqual(self.ask("SELECT attempt, kind FROM v_incident"), [(2, "duplicate")])

    def test_that_contradicts_is_an_error_and_is_never_averaged(self):
        campaign = self.write()
        self.poreclog("run", campaign)
        before = self.content()
        other = self.folder / "other"
        self.poreclog("run", campaign, database=self.folder / "o.sqlite", runs=other,
                      FAULT="random_result")
        shutil.copytree(other / "c/p0000-one_way/000001/attempt-001",
                        self.runs / "c/p0000-one_way/000001/attempt-002")
        self.poreclog("repair")
        self.assertEqual(self.content(), before)
        self.assertEqual(self.ask("SELECT idx, attempt, kind FROM v_incident"),
                         [(1, 2, "contradiction")])
        self.poreclog("resume", campaign, code=2)

    def test_that_contradicts_in_one_number_is_seen_whichever_it_is(self):
        numbers = ["@duration_s", "@t1_s", "@alpha_deg", "@last_traversal_s", "@injected",
                   "@traversed", "critical_diameter_m", "permeability_ratio",
                   "colloid", "contact_time_s", "position_m", "injection_position_m",
                   "injection_time_s", "alpha_deg", "bond_load_N"]
        campaign = self.write(realisations=1)
        self.poreclog("run", campaign)
        before = self.content()
        first = self.runs / "c/p0000-one_way/000000/attempt-001"
        (seed,), = self.ask("SELECT seed FROM v_realisation")
        for number, changed in enumerate(numbers, start=2):
            self.copy_attempt(first, number)
            copy = first.parent / f"attempt-{number:03}" / "result.h5"
            copy.unlink()
            subprocess.run([orchestrator.FAKE_SOLVER, "run", first.parent.parent / "scene.json",
                            "-o", copy, "--seed", str(seed)], check=True,
                           env=self.environment({"CHANGE": changed}))
        self.poreclog("repair")
        self.assertEqual(self.content(), before)
        self.assertEqual(self.ask("SELECT attempt, kind FROM v_incident ORDER BY attempt"),
                         [(n, "contradiction") for n in range(2, 2 + len(numbers))])

    def test_that_is_cut_anywhere_is_torn(self):
        campaign = self.write(realisations=1)
        self.poreclog("run", campaign, ROWS=20)
        result = self.runs / "c/p0000-one_way/000000/attempt-001/result.h5"
        whole = result.read_bytes()
        for part in range(0, len(whole), len(whole) // 12):
            result.write_bytes(whole[:part])
            self.poreclog("repair", "--force")
            self.assertEqual(self.ask("SELECT status, cause FROM v_realisation JOIN v_attempt"
                                      " USING (idx)"), [("eligible", "torn_result")], part)
        result.write_bytes(whole)
        self.poreclog("repair")
        self.assertEqual(self.content(), self.undisturbed_with(campaign, ROWS=20))

    def undisturbed_with(self, campaign, **fake):
        database = self.folder / "u.sqlite"
        self.poreclog("run", campaign, database=database, runs=self.folder / "u", **fake)
        return self.content(database)


class Database(orchestrator.Bench):
    def test_that_was_deleted_is_made_again(self):
        campaign = self.write(vary={"/colloids/diameter": ["1e-05 m", "2e-05 m"]})
        self.poreclog("run", campaign, FAULT="torn", ATTEMPTS=1, ONE_IN=3)
        before = self.content()
        for again in [("repair",), ("resume", campaign)]:
            self.database.unlink()
            self.poreclog(*again)
            self.assertEqual(self.content(), before, again)

    def test_that_is_deleted_during_a_run_costs_nothing(self):
        campaign = self.write(realisations=20)
        process = self.start("run", campaign, SECONDS=0.3)
        self.wait_until(lambda: list(self.runs.glob("c/p*/*/attempt-001/result.h5")))
        for file in self.folder.glob("db.sqlite*"):
            file.unlink()
        self.assertEqual(process.wait(timeout=30), 4)
        self.assertIn("deleted or replaced", process.stderr.read())
        self.poreclog("resume", campaign)
        self.assertEqual(self.content(), self.undisturbed(campaign))

    def test_of_a_newer_version_or_of_another_program_is_refused(self):
        campaign = self.write()
        self.poreclog("run", campaign)
        with sqlite3.connect(self.database) as db:
            db.execute("PRAGMA user_version = 2")
        for words in [("run", campaign), ("status", "c"), ("query", "c", "progress")]:
            done = self.poreclog(*words, code=1)
            self.assertIn("has schema version 2, this program knows 1", done.stderr)
        self.database = self.folder / "other.sqlite"
        with sqlite3.connect(self.database) as db:
            db.execute("CREATE TABLE mine (a)")
        self.poreclog("run", campaign, code=1)
        self.assertEqual(self.ask("SELECT name FROM sqlite_master"), [("mine",)])
        self.database.write_text("not a database at all, but long enough to be looked at\n" * 9)
        self.assertEqual(self.poreclog("run", campaign, code=None).returncode, 4)

    def test_that_others_hold_makes_no_row_be_lost(self):
        campaign = self.write(realisations=20)
        self.poreclog("run", self.write("first", "first.json", realisations=1))
        reader = sqlite3.connect(f"file:{self.database}?mode=ro", uri=True)
        reader.execute("BEGIN")
        reader.execute("SELECT count(*) FROM realisation").fetchone()
        process = self.start("run", campaign, SECONDS=0.1)
        self.wait_until(self.attempts)
        writer = sqlite3.connect(self.database, isolation_level=None)
        writer.execute("BEGIN IMMEDIATE")
        time.sleep(2)
        writer.execute("ROLLBACK")
        self.assertEqual(process.wait(timeout=60), 0, process.stderr.read())
        self.assertEqual(reader.execute("SELECT count(*) FROM realisation").fetchone(), (1,))
        reader.close()
        writer.close()
        self.assertEqual(self.ask("SELECT count(*) FROM v_realisation WHERE campaign = 'c' AND"
                                  " status = 'ingested'"), [(20,)])

    def test_that_lacks_results_is_not_replaced_by_a_poorer_one(self):
        self.poreclog("run", self.write())
        self.poreclog("run", self.write("d", "d.json"))
        shutil.rmtree(self.runs / "d")
        done = self.poreclog("repair", code=1)
        self.assertIn("6 results of campaign d, the run folders have 0", done.stderr)
        self.poreclog("repair", "--force")
        self.assertEqual(len(list(self.folder.glob("db.sqlite.before-*Z"))), 1)

    def test_may_be_large(self):
        self.poreclog("run", self.write())
        with sqlite3.connect(self.database) as db:
            db.execute("CREATE TABLE large AS SELECT zeroblob(300000000) AS bytes")
        self.poreclog("query", "c", "progress")
        self.poreclog("show", "c", 0, 0)
        self.poreclog("check", self.folder / "c.json")

    def test_is_only_read_by_query(self):
        self.poreclog("run", self.write())
        before = self.content()
        for statement in ["DELETE FROM realisation", "DROP TABLE point", "UPDATE point SET "
                          "number = 3", f"ATTACH '{self.folder}/x' AS x", "PRAGMA "
                          "user_version = 9", "SELECT 1; DELETE FROM point", "",
                          "SELECT * FROM nowhere", "INSERT INTO point DEFAULT VALUES "
                          "RETURNING id"]:
            self.poreclog("query", "c", statement or " ", code=1)
        self.assertEqual(self.content(), before)
        self.assertFalse((self.folder / "x").exists())
        sql = "SELECT idx, seed, tc_s, 'a,\"b' AS t FROM v_realisation ORDER BY idx"
        answer = json.loads(self.poreclog("query", "c", sql, "--json").stdout)
        self.assertEqual(answer["schema_version"], 1)
        self.assertEqual(answer["columns"], ["idx", "seed", "tc_s", "t"])
        expected = self.ask(sql)
        self.assertEqual([tuple(r.values()) for r in answer["rows"]], expected)
        rows = list(csv.reader(io.StringIO(self.poreclog("query", sql, "--csv").stdout)))
        self.assertEqual([(int(a), b, float(c) if c else None, t) for a, b, c, t in rows[1:]],
                         expected)
        for name in ["progress", "points", "realisations", "clogging", "curves", "layers",
                     "costs", "failures", "incidents", "programs"]:
            self.poreclog("query", "c", name)
        self.assertIn('the nearest is "curves"', self.poreclog("query", "c", "curvs",
                                                              code=1).stderr)


class CommandLine(unittest.TestCase):
    def test_is_refused_in_one_line_with_what_may_be_meant(self):
        for words, why in [
                ([], "a command is missing; known: check, run,"),
                (["statuss", "c"], '"statuss" is not a command; the nearest is "status"; known'),
                (["run", "c", "--wrkers", "2"],
                 '"--wrkers" is not an option of run; the nearest is --workers'),
                (["check", "c", "d"], 'one argument too many for check: "d"')]:
            done = subprocess.run([orchestrator.PROGRAM, *words], capture_output=True,
                                  text=True, timeout=60)
            self.assertEqual((done.returncode, done.stdout), (1, ""), words)
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
            self.assertIn("poreclog: command line: " + why, done.stderr)


class Disk(orchestrator.Bench):
    def test_that_is_full_costs_nothing(self):
        small = self.folder / "small"
        small.mkdir()
        campaign = self.write(realisations=60)
        script = (f"mount -t tmpfs -o size=1m none {small} && "
                  f"{' '.join(self.command('run', campaign, database=small / 'db.sqlite', runs=small / 'runs'))};"
                  f" code=$?; mount -o remount,size=64m {small};"
                  f"{' '.join(self.command('resume', campaign, database=small / 'db.sqlite', runs=small / 'runs'))};"
                  f" second=$?; cp {small}/db.sqlite* {self.folder}; umount {small};"
                  " echo $code $second")
        done = subprocess.run(["unshare", "--mount", *([] if os.geteuid() == 0 else
                               ["--user", "--map-root-user"]), "sh", "-c", script],
                              env=self.environment({}), capture_output=True, text=True,
                              timeout=100)
        if "mount" in done.stderr or "unshare" in done.stderr:
            self.skipTest("this machine lets nobody mount: " + done.stderr)
        codes = done.stdout.split()[-2:]
        self.assertIn(codes[0], ["2", "4"], done.stderr)
        if codes == ["2", "2"]:  # solvers met the full disk first and used up attempts
            self.skipTest("every failure was a solver's")
        self.assertIn(codes[1], ["0", "2"], done.stderr)
        rows = self.ask("SELECT status, count(*) FROM v_realisation GROUP BY status")
        self.assertEqual(sum(count for _, count in rows), 60)
        self.assertLessEqual({status for status, _ in rows}, {"ingested", "failed"})

    def test_that_cannot_be_written_to_is_refused(self):
        campaign = self.write()
        self.poreclog("run", campaign, code=1, runs="/proc/nowhere")
        self.poreclog("run", campaign, code=1, database="/proc/nowhere/db.sqlite")
        (self.folder / "file").write_text("")
        self.poreclog("run", campaign, code=1, runs=self.folder / "file")


class Name(orchestrator.Bench):
    def test_that_means_harm_is_refused(self):
        marker = self.folder / "marker"
        before = sorted(p.name for p in self.folder.iterdir())
        for name in ["../escape", "/etc/x", "..", ".", "", "a/b", "a b", f"$(touch {marker})",
                     f"`touch {marker}`", "a;b", "<script>alert(1)</script>", "a'b", 'a"b',
                     "-rf", "a\nb", "a\u0000b", "\u202etxt", "x" * 65, "caf\u00e9", "a\\b",
                     "*", "~root", "a&b", "a|b"]:
            done = self.poreclog("run", self.write(name), code=1)
            self.assertIn("/campaign: ", done.stderr)
            self.assertEqual(done.stderr.count("\n"), 1)
            for words in [("status", name), ("resume", name), ("cancel", name)]:
                if name and "\x00" not in name:
                    self.assertEqual(self.poreclog(*words, code=None).returncode, 1, words)
        after = sorted(p.name for p in self.folder.iterdir() if p.name != "c.json")
        self.assertEqual(after, before)

    def test_of_a_folder_may_have_any_characters(self):
        self.runs = self.folder / "runs $(touch x) 'q\" <b>;&"
        campaign = self.write(realisations=2)
        self.poreclog("run", campaign)
        line = self.poreclog("show", "c", 0, 1, "--command").stdout
        again = self.folder / "again"
        again.mkdir()
        subprocess.run(line, shell=True, check=True, cwd=again, env=self.environment({}))
        self.assertTrue((again / "result.h5").exists())


class Ensemble(orchestrator.Bench):
    def test_grows_without_changing_what_is_there(self):
        campaign = self.write()
        self.poreclog("run", campaign)
        rows = "SELECT * FROM realisation WHERE idx < 6 ORDER BY idx"
        before = self.ask(rows)
        self.poreclog("extend", campaign, "--by", 4, "--workers", 1)
        self.assertEqual(self.ask(rows), before)
        self.poreclog("extend", "c", "--to", 12)
        self.poreclog("extend", "c", "--to", 11, code=1)
        self.poreclog("run", campaign)  # the file still says 6: the ensemble does not shrink
        self.assertEqual(self.ask("SELECT count(*), max(idx) FROM v_realisation WHERE status ="
                                  " 'ingested'"), [(12, 11)])
        bigger = self.write(realisations=12)
        self.assertEqual(self.content(), self.undisturbed(bigger))

    def test_gets_new_design_points_and_tiers(self):
        self.poreclog("run", self.write(vary={"/colloids/diameter": ["1e-05 m"]}))
        before = self.ask("SELECT * FROM realisation ORDER BY id")
        self.poreclog("run", self.write(
            vary={"/colloids/diameter": ["0.5e-05 m", "1e-05 m"]},
            fidelity={"tier": ["one_way", "quasi_steady"]}))
        self.assertEqual(self.ask("SELECT * FROM realisation ORDER BY id")[:6], before)
        points = self.ask("SELECT DISTINCT point, varied FROM v_point ORDER BY point")
        self.assertEqual([json.loads(v)["/colloids/diameter"] for _, v in points],
                         ["1e-05 m", "0.5e-05 m"])
        # common random numbers: the seed depends on the index alone
        self.assertEqual(self.ask("SELECT count(DISTINCT seed), count(*) FROM v_realisation"),
                         [(6, 24)])

    def test_refuses_changed_physics_and_lists_the_changes(self):
        self.poreclog("run", self.write())
        for change, words in [
                ({"scene": {"duration": "6 s"}}, '/duration: "5 s" -> "6 s"'),
                ({"master_seed": 8}, "/master_seed: 7 -> 8"),
                ({"independent_points": True}, "/independent_points: false -> true"),
                ({"fidelity": {"cells_per_colloid": 9}}, "/fidelity/cells_per_colloid"),
                ({"vary": {"/colloids/diameter": ["2e-05 m"]}}, "is no longer there"),
                ({"fidelity": {"tier": "quasi_steady"}}, "is no longer there")]:
            for command in ["run", "resume"]:
                done = self.poreclog(command, self.write(**change), code=1)
                self.assertIn(words, done.stderr)
        cosmetic = self.write(description="new", statistics={"bootstrap": 500},
                              scene={"duration": "5 s", "description": "a remark"},
                              limits={"workers": 1, "attempts": 9})
        self.poreclog("resume", cosmetic)
        self.assertEqual(self.ask("SELECT count(*) FROM attempt"), [(6,)])

    def test_has_independent_seeds_if_asked(self):
        vary = {"/colloids/diameter": ["1e-05 m", "2e-05 m"]}
        self.poreclog("run", self.write(vary=vary, independent_points=True))
        self.assertEqual(self.ask("SELECT count(DISTINCT seed) FROM v_realisation"), [(12,)])
        before = dict(self.ask("SELECT idx, seed FROM v_realisation WHERE point = 0"))
        # another order of the values changes numbers, not seeds
        self.poreclog("run", self.write("d", vary={"/colloids/diameter": ["2e-05 m", "1e-05 m"]},
                                        independent_points=True))
        after = dict(self.ask("SELECT idx, seed FROM v_realisation WHERE campaign = 'd' AND "
                              "point = 1"))
        self.assertEqual(before, after)


if __name__ == "__main__":
    unittest.main()
