"""kill -9 of the orchestrator, a solver, a solver's keeper, or all of them, at random
moments: nothing finished is lost, nothing runs twice unnoticed, and the database ends as
that of an undisturbed run.

KILLS (default 200) is how many; the seed of the moments is printed, and can be given as
KILL_SEED.  With KILL_SCENE the solver is the real one, with that scene for a second: it
goes on from the checkpoints of killed attempts, and must come to the same results.  A
line of counts at the end goes into the evidence (scripts/reliability.sh)."""
import json
import os
import pathlib
import random
import time
import unittest

import orchestrator
from orchestrator import children, kill

KILLS = int(os.environ.get("KILLS", "200"))
SEED = int(os.environ.get("KILL_SEED", str(random.randrange(10**6))))
SCENE = os.environ.get("KILL_SCENE")
REALISATIONS = 8 if SCENE else 24
LONGEST_PAUSE = 1.2 if SCENE else 0.12  # [s] between kills


class Kill(orchestrator.Bench):
    def finished(self):
        """Results that are on the disk, and those that the database says are ingested."""
        on_disk = {p.parent.parent for p in self.runs.glob("c/p*/*/attempt-*/result.h5")}
        return len(on_disk)

    def test_loses_nothing_and_repeats_nothing_unnoticed(self):
        moments = random.Random(SEED)
        self.counts = {"orchestrator": 0, "solver": 0, "keeper": 0, "everything": 0}
        rounds = 0
        kills = 0
        lost = 0
        fake = {"SECONDS": 0.03}
        while kills < KILLS:
            rounds += 1
            name = f"round{rounds}.json"
            self.runs = self.folder / f"runs{rounds}"
            self.database = self.folder / f"db{rounds}.sqlite"
            campaign = self.write(file=name, realisations=REALISATIONS, master_seed=rounds,
                                  **self.scene(),
                                  limits={"attempts": 1000, "workers": 3,
                                          "checkpoint_interval": 0.1})
            kills += self.disturb(campaign, moments, KILLS - kills, fake)
            before = self.ingested()
            # killed before it had written anything, there is nothing to resume
            begun = (self.runs / "c/campaign.json").exists()
            self.poreclog("resume" if begun else "run", campaign, **fake)
            self.assertEqual(self.ask("SELECT count(*) FROM v_realisation WHERE status ="
                                      " 'ingested'"), [(REALISATIONS,)])
            lost += max(0, before - REALISATIONS)
            self.check_attempts()
            self.compare_with_undisturbed(campaign, rounds)
        if KILLS >= 200:  # each kind has a quarter of 200 on average, standard deviation 6
            self.assertGreater(min(self.counts.values()), KILLS / 20, self.counts)
        print(f"\nkills {kills} {self.counts}, campaigns {rounds}, results lost {lost}, "
              f"unnoticed repetitions 0, seed {SEED}", flush=True)

    def scene(self):
        if not SCENE:
            return {}
        return {"scene": {**json.loads(pathlib.Path(SCENE).read_text()), "duration": "1 s"}}

    def ingested(self):
        try:
            return self.ask("SELECT count(*) FROM v_realisation WHERE status = 'ingested'"
                            )[0][0]
        except Exception:  # killed before the database was there
            return 0

    def disturb(self, campaign, moments, most, fake):
        """Runs the campaign, killing something again and again, until it has ended."""
        kills = 0
        ingested = 0
        while kills < most:
            process = self.start("run", campaign, **fake)
            while kills < most:
                if moments.random() < 0.8:  # also on a machine that is slow to start
                    self.wait_for_attempts(process)
                time.sleep(moments.uniform(0.0, LONGEST_PAUSE))
                if process.poll() is not None:
                    break
                kills += self.kill_something(process, moments)
                if process.poll() is not None:
                    break
            if process.poll() is None:
                process.kill()
            code = process.wait()
            now = self.ingested()
            self.assertGreaterEqual(now, ingested, "an ingested result was lost")
            ingested = now
            if code >= 0:
                self.assertEqual(code, 0, process.stderr.read())
                break
        return kills

    def wait_for_attempts(self, process):
        end = time.monotonic() + 30
        keepers = self.attempts()
        while not keepers and process.poll() is None and time.monotonic() < end:
            time.sleep(0.002)
            keepers = self.attempts()
        return keepers

    def kill_something(self, process, moments):
        what = moments.choice(["orchestrator", "solver", "keeper", "everything"])
        keepers = self.attempts() if what == "orchestrator" \
            else self.wait_for_attempts(process)
        solvers = [s for k in keepers for s in children(k)]
        if what == "solver" and solvers:
            kill(moments.choice(solvers))
        elif what == "keeper" and keepers:
            kill(moments.choice(keepers))
        elif what == "everything":
            process.kill()
            for victim in solvers + keepers:
                kill(victim)
            process.wait()
        else:
            what = "orchestrator"
            process.kill()
            process.wait()
        self.counts[what] += 1
        return 1

    def check_attempts(self):
        """Every attempt that was begun has a row, with an end; no result was made twice
        without a note of it."""
        folders = len(list(self.runs.glob("c/p*/*/attempt-*")))
        rows = self.ask("SELECT count(*), sum(cause = 'running') FROM v_attempt")[0]
        self.assertEqual(rows, (folders, 0))
        results = len(list(self.runs.glob("c/p*/*/attempt-*/result.h5")))
        duplicates = self.ask("SELECT count(*) FROM incident WHERE kind = 'duplicate'")[0][0]
        self.assertEqual(results, REALISATIONS + duplicates)
        self.assertEqual(self.ask("SELECT * FROM incident WHERE kind NOT IN "
                                  "('duplicate', 'lost')"), [])

    def compare_with_undisturbed(self, campaign, number):
        database = self.folder / f"calm{number}.sqlite"
        self.poreclog("run", campaign, database=database,
                      runs=self.folder / f"calm-runs{number}")
        self.assertEqual(self.content(), self.content(database))


if __name__ == "__main__":
    unittest.main()
