"""Campaigns on a real Slurm, which the test starts itself (cluster.py).

Each test ends in the same question: is the database that of the local executor, in which
nothing went wrong?  Everything that ran twice must have been noticed."""
import json
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "anomaly"))
import orchestrator  # noqa: E402
from cluster import Cluster  # noqa: E402

SOLVE = os.environ.get("SOLVE")  # the real solver; that of the tier transient lies beside it


class OnSlurm(orchestrator.Bench):
    """One cluster for the tests of a class: its first job waits for seconds."""
    config = {}

    @classmethod
    def setUpClass(cls):
        folder = pathlib.Path(tempfile.mkdtemp(prefix="poreclog-slurm-"))
        cls.addClassCleanup(shutil.rmtree, folder, ignore_errors=True)
        cls.cluster = Cluster(folder, 2, **cls.config)
        cls.addClassCleanup(cls.cluster.stop)
        cls.cluster.start()

    def setUp(self):
        super().setUp()
        self.folder.chmod(0o755)
        self.jobs_before = {job for job, _ in self.cluster.tasks()}
        self.addCleanup(self.cluster.clear)

    def tasks(self):
        """State of this test's tasks by (array's id, index)."""
        return {task: state for task, state in self.cluster.tasks().items()
                if task[0] not in self.jobs_before}

    def only_job(self):
        (job,) = {job for job, _ in self.tasks()}
        return job

    def environment(self, fake):
        return {**super().environment(fake), "OMPI_ALLOW_RUN_AS_ROOT": "1",
                "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}

    def write(self, name="c", file="c.json", **keys):
        limits = {"workers": 0, **keys.pop("limits", {})}
        return super().write(name, file, limits=limits, **keys)

    def status(self, campaign="c"):
        return json.loads(self.poreclog("status", campaign, "--json").stdout)

    def wait_for_tasks(self, seconds=60):
        self.wait_until(lambda: not self.cluster.queue("PD,R,CG,S,CF"), seconds)

    def finish(self, campaign="c", seconds=90, **fake):
        """resume, again and again, until it says that all is done."""
        end = time.monotonic() + seconds
        while True:
            done = self.poreclog("resume", campaign, code=None, **fake)
            if done.returncode == 0:
                return
            self.assertEqual(done.returncode, 3, done.stdout + done.stderr)
            self.assertLess(time.monotonic(), end, done.stdout + done.stderr)
            time.sleep(0.3)

    def undisturbed(self, campaign_file):
        database = self.folder / "undisturbed.sqlite"
        self.poreclog("run", campaign_file, "--executor", "local", database=database,
                      runs=self.folder / "undisturbed-runs")
        return self.content(database)

    def attempts_of(self, campaign="c"):
        return sorted((self.runs / campaign).glob("p*/*/attempt-*"))

    def solvers(self):
        """Processes that run in a folder of this test."""
        found = []
        for entry in pathlib.Path("/proc").iterdir():
            try:
                state = (entry / "stat").read_text().rsplit(")", 1)[1].split()[0]
                here = os.readlink(entry / "cwd")
            except (OSError, IndexError):
                continue
            if state != "Z" and here.startswith(str(self.runs)):
                found.append(int(entry.name))
        return found

    def incidents(self):
        return [row[0] for row in self.ask("SELECT kind FROM v_incident ORDER BY 1")]

    def wrapper(self, name, text):
        """A program of that name that comes before the real one in PATH."""
        folder = self.folder / "wrappers"
        folder.mkdir(exist_ok=True)
        path = folder / name
        path.write_text("#!/bin/sh\n" + text)
        path.chmod(0o755)
        return ["env", f"PATH={folder}:{os.environ['PATH']}"]


class Arrays(OnSlurm):
    def test_complete_and_give_the_local_executors_database(self):
        campaign = self.write(realisations=30, vary={"/colloids/diameter":
                                                      ["10 um", "12 um"]})
        begin = time.monotonic()
        self.poreclog("submit", campaign)
        self.assertLess(time.monotonic() - begin, 10)
        self.wait_for_tasks()
        self.finish()
        self.assertEqual(self.content(), self.undisturbed(campaign))
        self.assertEqual(self.incidents(), [])
        self.assertEqual(self.ask("SELECT count(*) FROM v_attempt"), [(60,)])
        if self.cluster.name_hosts:  # the other nodes' locks say so
            nodes = {row[0] for row in self.ask("SELECT DISTINCT node FROM v_attempt")}
            self.assertEqual(nodes, {"n1", "n2"})
        # one array for sixty realisations
        self.assertEqual(len(list((self.runs / "c/slurm").glob("*/job"))), 1)

    def test_are_folded_in_while_others_run(self):
        campaign = self.write(realisations=20, executor="slurm")
        self.poreclog("submit", campaign, SECONDS=2)
        self.wait_until(lambda: 0 < self.status()["total"]["ingested"] < 20)
        status = self.status()
        self.assertTrue(status["slurm"]["answers"])
        self.assertGreater(status["total"]["active"], 0)
        self.poreclog("run", "c", SECONDS=2)  # stays until the end
        self.assertEqual(self.content(), self.undisturbed(campaign))

    def test_are_asked_after_once_a_second_at_most(self):
        campaign = self.write(realisations=2)
        calls = self.folder / "calls"
        prefix = self.wrapper("squeue", f'echo >> {calls}\nexec {shutil.which("squeue")} "$@"\n')
        begin = time.monotonic()
        self.poreclog("run", campaign, "--executor", "slurm", prefix=prefix, SECONDS=3)
        self.assertLessEqual(len(calls.read_text()), time.monotonic() - begin + 1)

    def test_of_a_campaign_that_is_extended(self):
        campaign = self.write(realisations=3, executor="slurm")
        self.poreclog("run", campaign)
        self.poreclog("extend", "c", "--to", 5, "--wait")
        grown = self.write(realisations=5, file="grown.json")
        self.assertEqual(self.content(), self.undisturbed(grown))

    def test_dry_run_says_what_and_why_and_changes_nothing(self):
        campaign = self.write(realisations=7, slurm={"partition": "main"})
        done = self.poreclog("run", campaign, "--executor", "slurm", "--dry-run", "--json")
        plan = json.loads(done.stdout)
        self.assertEqual((plan["to_run"], plan["slurm"]["sbatch_calls"]), (7, 1))
        self.assertEqual([(c["action"], c["reason"], c["count"])
                          for c in plan["ensembles"][0]["classes"]],
                         [("run", "never_tried", 7)])
        self.assertIn("--partition=main", plan["slurm"]["command"])
        self.assertFalse(self.runs.exists() or self.database.exists())
        script = self.folder / "script"
        script.write_text(plan["slurm"]["script"])
        subprocess.run(["sh", "-n", script], check=True)
        text = self.poreclog("submit", campaign, "--dry-run").stdout
        self.assertIn("#!/bin/sh", text)
        self.assertIn("never tried  [0-6]", text)

    def test_that_are_with_slurm_are_left_there_by_dry_runs_and_the_local_executor(self):
        campaign = self.write(realisations=3)
        self.poreclog("submit", campaign, SECONDS=6)
        before = sorted(self.runs.rglob("*/submission.json"))
        plan = json.loads(self.poreclog("resume", "c", "--dry-run", "--json").stdout)
        self.assertEqual([(c["action"], c["reason"], c["count"])
                          for c in plan["ensembles"][0]["classes"]],
                         [("take_over", "running", 3)])
        self.assertEqual((plan["to_run"], plan["slurm"]["sbatch_calls"]), (0, 0))
        done = self.poreclog("run", "c", "--executor", "local", code=1)
        self.assertIn("jobs of this campaign are on Slurm", done.stderr)
        self.assertEqual(sorted(self.runs.rglob("*/submission.json")), before)
        self.assertEqual(len(self.attempts_of()), 3)
        self.poreclog("cancel", "c", "--now")
        self.poreclog("run", "c", "--executor", "local")
        self.assertEqual(self.content(), self.undisturbed(campaign))


class SmallSite(OnSlurm):
    """Arrays of ten tasks, sixteen jobs in all."""
    config = {"MaxArraySize": 10, "MaxJobCount": 16}

    def test_gets_few_arrays_with_several_realisations_a_task(self):
        campaign = self.write(realisations=60)
        counter = self.folder / "calls"
        real = shutil.which("sbatch")
        prefix = self.wrapper("sbatch", f'echo >> {counter}\nexec {real} "$@"\n')
        self.poreclog("submit", campaign, prefix=prefix)
        self.assertEqual(len(self.tasks()), 8)  # half of the table
        self.wait_for_tasks()
        self.finish()
        self.assertEqual(self.content(), self.undisturbed(campaign))
        self.assertEqual(len(counter.read_text()), 1)  # 8 realisations a task
        self.assertEqual(self.ask("SELECT count(*) FROM v_attempt"), [(60,)])


class Names(OnSlurm):
    def test_that_mean_harm_do_none(self):
        self.runs = self.folder / "a b'$(touch pwned)`touch pwned`%a\\;&"
        campaign = self.write(realisations=3)
        self.poreclog("run", campaign, "--executor", "slurm")
        self.assertEqual(self.content(), self.undisturbed(campaign))
        self.assertEqual(list(self.folder.rglob("pwned")), [])

    def test_in_options_are_refused_with_their_place(self):
        for slurm, place in [
                ({"partition": "main; touch /tmp/pwned"}, "/slurm/partition"),
                ({"partition": "--wrap=id"}, "/slurm/partition"),
                ({"options": ["--wrap=id"]}, "/slurm/options/0"),
                ({"options": ["--qos=long", "--output=/etc/passwd"]}, "/slurm/options/1"),
                ({"options": ["--comment=$(id)"]}, "/slurm/options/0"),
                ({"memory": 3}, "/slurm/memory")]:
            done = self.poreclog("submit", self.write(slurm=slurm), code=1)
            self.assertIn(place, done.stderr)

    def test_of_partitions_that_do_not_exist_are_refused_with_slurms_words(self):
        campaign = self.write(slurm={"partition": "nowhere"})
        done = self.poreclog("submit", campaign, code=1)
        self.assertIn("invalid partition", done.stderr)
        campaign = self.write(slurm={"partition": "main"})
        self.poreclog("run", campaign, "--executor", "slurm")
        self.assertEqual(self.content(), self.undisturbed(campaign))

    def test_of_a_program_that_nodes_do_not_have_stop_the_campaign(self):
        campaign = self.write(realisations=3, limits={"attempts": 2})
        gone = self.folder / "gone"
        gone.mkdir()
        for name in ["poreclog", "poreclog-attempt"]:
            shutil.copy(pathlib.Path(orchestrator.PROGRAM).parent / name, gone)
        self.poreclog("submit", campaign)  # claims the run folder
        self.wait_for_tasks()
        self.finish()
        wrapped = self.wrapper("sbatch", f'rm {gone}/poreclog-attempt\nexec '
                               f'{shutil.which("sbatch")} "$@"\n')
        done = subprocess.run([*wrapped, gone / "poreclog", *self.command(
            "extend", "c", "--to", 5, "--wait")[1:]], env=self.environment({}),
            capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 3, done.stdout + done.stderr)
        self.assertIn("cannot be started", done.stdout)
        self.assertEqual(self.ask("SELECT DISTINCT cause FROM v_attempt WHERE idx > 2"),
                         [("not_started",)])


class Answers(OnSlurm):
    def test_of_sbatch_that_are_lost_are_found_by_the_jobs_name(self):
        campaign = self.write(realisations=5)
        real = shutil.which("sbatch")
        self.wrapper("sacct", "exit 127\n")  # as a shell says that there is none
        prefix = self.wrapper("sbatch", f'{real} "$@" >/dev/null\n'
                              "echo 'sbatch: error: Batch job submission failed: Socket "
                              "timed out on send/recv operation' >&2\nexit 1\n")
        self.poreclog("submit", campaign, prefix=prefix)
        self.wait_for_tasks()
        self.finish()
        self.assertEqual(len({job for job, _ in self.tasks()}), 1)
        self.assertEqual(self.ask("SELECT count(*) FROM v_attempt"), [(5,)])
        self.assertEqual(self.content(), self.undisturbed(campaign))

    def test_of_sbatch_that_are_lost_are_found_in_the_accounting(self):
        """squeue has forgotten the job by then."""
        campaign = self.write(realisations=3)
        job = self.folder / "job"
        self.wrapper("sbatch", f'{shutil.which("sbatch")} "$@" >{job}\nexit 1\n')
        self.wrapper("squeue", "exit 0\n")
        prefix = self.wrapper("sacct", f"sed 's/$/_0/' {job}\n")
        self.poreclog("submit", campaign, prefix=prefix)
        self.assertEqual((self.runs / "c/slurm/000001/job").read_text(), job.read_text())
        self.wait_for_tasks()
        self.finish()
        self.assertEqual(self.only_job(), int(job.read_text()))
        self.assertEqual(self.ask("SELECT count(*) FROM v_attempt"), [(3,)])
        self.assertEqual(self.content(), self.undisturbed(campaign))

    def test_of_squeue_that_are_empty_are_not_believed(self):
        campaign = self.write(realisations=3)
        self.poreclog("submit", campaign, SECONDS=3)
        self.wait_until(lambda: len(self.attempts()) == 3)
        empty = self.wrapper("squeue", "exit 0\n")
        status = json.loads(self.poreclog("status", "c", "--json", prefix=empty).stdout)
        self.assertEqual((status["slurm"]["tasks_unknown"], status["total"]["ingested"],
                          status["total"]["eligible"]), (3, 0, 0))
        self.poreclog("resume", "c", code=3, prefix=empty)
        self.assertEqual(len(self.attempts_of()), 3)
        self.finish()
        self.assertEqual(self.ask("SELECT count(*) FROM v_attempt"), [(3,)])
        self.assertEqual(self.content(), self.undisturbed(campaign))

    def test_that_squeue_filters_for_the_users_taste_are_not_filtered_for_us(self):
        self.poreclog("submit", self.write(realisations=2), SECONDS=3,
                      prefix=["env", "SQUEUE_PARTITION=other", "SBATCH_WAIT=1"])
        done = self.poreclog("status", "c", "--json", prefix=["env", "SQUEUE_NAMES=x"])
        slurm = json.loads(done.stdout)["slurm"]
        self.assertEqual(slurm["tasks_waiting"] + slurm["tasks_running"], 2)
        self.poreclog("cancel", "c", "--now")


class Controller(OnSlurm):
    """slurmctld goes down."""
    config = {"MessageTimeout": 3}  # [s] for its clients to find out

    def test_that_does_not_answer_means_unknown_not_finished(self):
        campaign = self.write(realisations=4)
        self.poreclog("submit", campaign, SECONDS=8)
        self.wait_until(lambda: len(self.attempts()) == 4)
        self.cluster.kill("slurmctld", signal.SIGTERM)
        status = self.status()
        self.assertFalse(status["slurm"]["answers"])
        self.assertEqual((status["total"]["ingested"], status["slurm"]["tasks_unknown"]),
                         (0, 4))
        self.poreclog("resume", "c", code=1)
        self.assertEqual(len(self.attempts_of()), 4)
        self.wait_until(lambda: len(list(self.runs.glob("c/p*/*/*/result.h5"))) == 4)
        self.assertEqual(self.status()["total"]["ingested"], 4)  # files say so
        self.cluster.start_controller()
        self.finish()
        self.assertEqual(self.content(), self.undisturbed(campaign))
        self.assertEqual(self.ask("SELECT count(*) FROM v_attempt"), [(4,)])

    def test_that_restarts_in_mid_campaign_loses_nothing(self):
        campaign = self.write(realisations=20)
        self.poreclog("submit", campaign, SECONDS=1)
        self.wait_until(lambda: len(self.attempts()) > 3)
        self.cluster.kill("slurmctld", signal.SIGTERM)
        self.cluster.start_controller()
        self.finish(SECONDS=1)
        self.assertEqual(self.content(), self.undisturbed(campaign))
        self.assertEqual(self.incidents(), [])
        self.assertEqual(self.ask("SELECT count(*) FROM v_attempt"), [(20,)])


class Tasks(OnSlurm):
    def test_that_fail_or_run_too_long_are_tried_again(self):
        for fault, cause in [("crash", "crashed"), ("torn", "torn_result"),
                             ("hang", "time_limit")]:
            with self.subTest(fault):
                self.database = self.folder / (fault + ".sqlite")
                self.runs = self.folder / fault
                campaign = self.write(realisations=3, limits={
                    "seconds_per_realisation": 1, "seconds_to_stop": 1})
                self.poreclog("run", campaign, "--executor", "slurm", FAULT=fault,
                              ATTEMPTS=1)
                causes = sorted(r[0] for r in self.ask("SELECT cause FROM v_attempt"))
                self.assertEqual(causes, sorted([cause] * 3 + ["finished"] * 3))
                # the limit was kept by the job, not a minute later by Slurm
                self.assertEqual(self.ask("SELECT count(*) FROM v_attempt WHERE wall_s < 20"),
                                 [(6,)])

    def test_that_always_fail_use_up_their_attempts(self):
        campaign = self.write(realisations=2, limits={"attempts": 2})
        self.poreclog("run", campaign, "--executor", "slurm", code=2, FAULT="crash")
        self.assertEqual(self.ask("SELECT cause FROM v_attempt"), [("crashed",)] * 4)
        self.poreclog("retry", "c", "--wait")
        self.assertEqual(self.content(), self.undisturbed(campaign))

    def test_that_are_cancelled_go_on_from_their_checkpoints(self):
        campaign = self.write(realisations=3)
        self.poreclog("submit", campaign, SECONDS=8)
        self.wait_until(lambda: len(self.attempts()) == 3)
        time.sleep(1.0)
        self.poreclog("cancel", "c")
        self.assertEqual(self.cluster.queue("PD,R,CG,S"), [])
        self.assertEqual(self.solvers(), [])
        self.assertEqual(self.ask("SELECT DISTINCT cause FROM v_attempt"),
                         [("interrupted",)])
        self.assertEqual(self.status()["total"]["eligible"], 3)
        checkpoints = list(self.runs.glob("c/p*/*/checkpoint.h5"))
        self.assertEqual(len(checkpoints), 3)
        self.assertTrue(all(int(c.read_text()) > 0 for c in checkpoints))
        self.poreclog("run", "c", SECONDS=0.2)
        self.assertEqual(self.content(), self.undisturbed(campaign))

    def test_that_all_wait_are_cancelled_and_sent_again(self):
        campaign = self.write(realisations=3, slurm={"options": ["--begin=now+1hour"]})
        self.poreclog("submit", campaign)
        self.assertEqual(set(self.tasks().values()), {"PENDING"})
        self.poreclog("cancel", "c")
        self.assertEqual(self.cluster.queue("PD,R,CG,S"), [])
        self.assertEqual(self.status()["total"]["eligible"], 3)
        self.poreclog("submit", campaign)
        subprocess.run(["scancel", *self.cluster.queue("PD")], check=True)  # somebody else
        # Slurm may then list the array in one line, whose index is N/A.
        merged = self.wrapper("squeue", f'{shutil.which("squeue")} "$@" | '
                              "sed -E 's/^([0-9]+)[|][0-9]+[|]CANCELLED/\\1|N\\/A|CANCELLED/' |"
                              " uniq\n")
        status = json.loads(self.poreclog("status", "c", "--json", prefix=merged).stdout)
        self.assertEqual((status["slurm"]["tasks_unknown"], status["total"]["eligible"]), (0, 3))
        self.write(realisations=3)
        self.poreclog("run", campaign)
        self.assertEqual(self.content(), self.undisturbed(campaign))

    def test_that_wait_or_ignore_signals_are_cancelled_too(self):
        campaign = self.write(realisations=20)
        self.poreclog("submit", campaign, FAULT="ignore_term")
        self.wait_until(lambda: len(self.attempts()) >= 16)
        self.poreclog("cancel", "c", "--now")
        self.assertEqual(self.cluster.queue("PD,R,CG,S"), [])
        self.wait_until(lambda: self.solvers() == [], 5)
        self.assertEqual(self.status()["total"]["eligible"], 20)
        self.poreclog("run", "c")
        self.assertEqual(self.content(), self.undisturbed(campaign))

    def test_that_somebody_else_cancels_or_kills_are_noticed(self):
        campaign = self.write(realisations=6)
        self.poreclog("submit", campaign, SECONDS=4)
        self.wait_until(lambda: len(self.attempts()) == 6)
        job = self.only_job()
        subprocess.run(["scancel", f"{job}_0", f"{job}_1"], check=True)
        for keeper in self.attempts()[:2]:
            orchestrator.kill(keeper)
        self.finish(SECONDS=0.2)
        self.assertEqual(self.content(), self.undisturbed(campaign))
        self.assertEqual(self.ask("SELECT DISTINCT cause FROM v_attempt WHERE cause NOT IN "
                                  "('finished', 'interrupted', 'lost')"), [])

    def test_that_are_requeued_begin_another_attempt(self):
        campaign = self.write(realisations=4)
        self.poreclog("submit", campaign, SECONDS=3)
        self.wait_until(lambda: len(self.attempts()) == 4)
        job = self.only_job()
        subprocess.run(["scontrol", "requeue", f"{job}_1"], check=True)
        self.wait_until(lambda: self.tasks()[(job, 1)] == "PENDING")
        self.assertEqual(self.status()["total"]["active"], 4)
        # Slurm would wait for two minutes; within the same second its nodes take the new
        # credential for the one that the requeue has revoked.
        subprocess.run(["scontrol", "update", f"jobid={job}_1", "starttime=now+2"], check=True)
        self.wait_for_tasks()
        self.poreclog("resume", "c")  # nothing is left to send
        self.assertEqual(self.content(), self.undisturbed(campaign))
        self.assertEqual(self.ask("SELECT idx, count(*) FROM v_attempt GROUP BY 1"),
                         [(0, 1), (1, 2), (2, 1), (3, 1)])
        self.assertEqual(len({j for j, _ in self.tasks()}), 1)

    def test_that_come_twice_run_once(self):
        campaign = self.write(realisations=5)
        real = shutil.which("sbatch")
        prefix = self.wrapper("sbatch", f'{real} "$@" >/dev/null\nexec {real} "$@"\n')
        self.poreclog("submit", campaign, prefix=prefix, SECONDS=1)
        self.assertEqual(len({j for j, _ in self.tasks()}), 2)
        self.wait_for_tasks()
        self.finish()
        self.assertEqual(len(list(self.runs.glob("c/p*/*/*/result.h5"))), 5)
        self.assertEqual(self.ask("SELECT count(*) FROM v_attempt"), [(5,)])
        self.assertEqual(self.content(), self.undisturbed(campaign))

    def test_that_come_too_late_do_nothing(self):
        """An array that was given up, and is accepted after all."""
        campaign = self.write(realisations=3)
        late = self.folder / "late"
        prefix = self.wrapper("sbatch", f'printf "%s\\0" "$@" > {late}\nexit 1\n')
        self.poreclog("submit", campaign, code=1, prefix=prefix)
        self.poreclog("run", "c", "--executor", "slurm")
        before = self.content()
        words = late.read_bytes().decode().split("\0")[:-1]
        subprocess.run(["sbatch", *words], check=True, capture_output=True)
        self.wait_for_tasks()
        self.poreclog("resume", "c", "--executor", "slurm")
        self.assertEqual(len(list(self.runs.glob("c/p*/*/*/result.h5"))), 3)
        self.assertEqual(self.content(), before)
        self.assertEqual(before, self.undisturbed(campaign))


class Ranks(OnSlurm):
    """A program of several ranks, made of MPI_Init and the fake solver."""

    def run_with(self, nodes, launcher):
        here = pathlib.Path(orchestrator.FAKE_SOLVER).parent
        link = self.folder / "solver"
        link.mkdir(exist_ok=True)
        for name, target in [("solve", orchestrator.FAKE_SOLVER),
                             ("solve-transient", str(here / "fake_ranks"))]:
            if not (link / name).exists():
                (link / name).symlink_to(target)
        self.database = self.folder / f"{launcher}{nodes}.sqlite"
        self.runs = self.folder / f"{launcher}{nodes}"
        campaign = self.write(
            realisations=2, ranks=4, fidelity={"tier": "transient"}, executor="slurm",
            slurm={"launcher": launcher,
                   "options": [f"--nodes={nodes}", f"--ntasks-per-node={4 // nodes}"]})
        self.poreclog("run", campaign, prefix=["env", f"PORECLOG_SOLVER={link}/solve",
                                               f"FAKE_SOLVER={orchestrator.FAKE_SOLVER}"])
        for number in range(2):
            # The last: seen once on a busy machine, the first had no output at all, and the
            # campaign completed.
            attempts = sorted((self.runs / f"c/p0000-transient/{number:06}").glob("attempt-*"))
            attempt = attempts[-1]
            ranks = dict(line.split() for line in (attempt / "stdout").read_text()
                         .splitlines() if line.startswith("rank"))
            self.assertEqual(sorted(ranks), ["rank0/4", "rank1/4", "rank2/4", "rank3/4"],
                             "\n".join(f"{file}:\n{file.read_text()}"
                                       for other in attempts
                                       for file in sorted(other.glob("std*"))))
            if self.cluster.name_hosts:
                self.assertEqual(len(set(ranks.values())), nodes)

    def test_of_mpirun_on_one_node_and_two(self):
        self.run_with(1, "mpirun")
        self.run_with(2, "mpirun")

    def test_of_srun_on_one_node_and_two(self):
        self.run_with(1, "srun")
        self.run_with(2, "srun")


class Transient(OnSlurm):
    """The tier transient itself, its ranks inside the allocation."""

    # One grain in a duct, a colloid that is caught beside its stagnation line.
    SCENE = {
        "geometry": {
            "box": ["40 um", "40 um", "60 um"],
            "faces": {"x-": "wall", "x+": "wall", "y-": "wall", "y+": "wall",
                      "z-": "outlet", "z+": "inlet"},
            "spheres": [{"center": ["20 um", "20 um", "22 um"], "diameter": "24 um"}],
            "bodies": [{"center": ["20.3 um", "20.1 um", "39 um"], "diameter": "8 um"}]},
        "drive": {"inlet_velocity": "0.5 mm/s"},
        "colloids": {"diameter": "8 um", "volume_fraction": 0.0},
        "duration": "4 ms"}

    def run_on(self, launcher, nodes):
        self.database = self.folder / f"{launcher}{nodes}.sqlite"
        self.runs = self.folder / f"{launcher}{nodes}"
        campaign = self.write(
            scene=self.SCENE, realisations=1, ranks=2, executor="slurm",
            fidelity={"tier": "transient", "cells_per_colloid": 3},
            limits={"attempts": 1, "seconds_per_realisation": 200},
            slurm={"launcher": launcher,
                   "options": [f"--nodes={nodes}", f"--ntasks-per-node={2 // nodes}"]})
        self.poreclog("run", campaign, prefix=["env", f"PORECLOG_SOLVER={SOLVE}"])
        (row,) = self.ask("SELECT tier, status, injected, retained + traversed FROM v_realisation")
        self.assertEqual(row[:3], ("transient", "ingested", 1))

    def test_by_mpirun_on_two_nodes(self):
        self.run_on("mpirun", 2)

    def test_by_srun_on_one_node(self):
        self.run_on("srun", 1)


class Killed(OnSlurm):
    """kill -9 of submit, resume, status and cancel, at random moments."""

    def test_orchestrators_lose_nothing_and_repeat_nothing(self):
        seed = int(os.environ.get("KILL_SEED", str(random.randrange(10**6))))
        moments = random.Random(seed)
        kills = 0
        warm = {"database": self.folder / "warm.sqlite", "runs": self.folder / "warm"}
        begin = time.monotonic()
        self.poreclog("submit", self.write(realisations=25), **warm)
        longest = time.monotonic() - begin
        for round_ in range(3):
            self.runs = self.folder / f"runs{round_}"
            self.database = self.folder / f"db{round_}.sqlite"
            campaign = self.write(file=f"c{round_}.json", realisations=25,
                                  master_seed=round_ + 1, limits={"attempts": 1000})
            for _ in range(10):
                begun = (self.runs / "c/campaign.json").exists() and self.database.exists()
                command = moments.choice(["submit", "resume", "status", "cancel"]
                                         if begun else ["submit"])
                process = self.start(command, campaign, SECONDS=0.5)
                time.sleep(moments.uniform(0.0, longest))
                if process.poll() is None:
                    process.kill()
                    kills += 1
                process.wait()
            begun = (self.runs / "c/campaign.json").exists()
            self.poreclog("submit" if not begun else "status", campaign, code=None)
            self.finish(campaign, SECONDS=0.5)
            self.wait_for_tasks()
            self.poreclog("resume", campaign)
            database = self.folder / f"calm{round_}.sqlite"
            self.poreclog("run", campaign, "--executor", "local", database=database,
                          runs=self.folder / f"calm{round_}")
            self.assertEqual(self.content(), self.content(database), f"seed {seed}")
            results = len(list(self.runs.glob("c/p*/*/attempt-*/result.h5")))
            duplicates = self.incidents().count("duplicate")
            self.assertEqual(results, 25 + duplicates, f"seed {seed}")
            self.assertEqual(self.ask("SELECT count(*) FROM v_attempt WHERE cause = "
                                      "'running'"), [(0,)])
        print(f"\norchestrators killed {kills}, seed {seed}", flush=True)
        self.assertGreater(kills, 5, "they were too quick")


class Nodes(OnSlurm):
    """Slow faults: Slurm takes its time to notice."""

    def test_whose_daemon_is_killed_or_that_go_down_lose_no_realisation(self):
        campaign = self.write(realisations=16, limits={"seconds_per_realisation": 600})
        self.poreclog("submit", campaign, SECONDS=300)
        self.wait_until(lambda: len(self.attempts()) == 16)
        before = set(self.attempts_of())
        self.cluster.kill("slurmd.n1")
        self.wait_until(lambda: self.cluster.node_states()["n1"].startswith("down"), 60)
        # the processes on n1 live on, unsupervised; their tasks are requeued
        total = self.status()["total"]
        self.assertEqual(total["active"], 16, total)
        self.cluster.start_node("n1")
        self.wait_until(lambda: self.cluster.node_states()["n1"] in ("idle", "mixed"), 60)
        subprocess.run(["scontrol", "update", "nodename=n2", "state=down", "reason=test"],
                       check=True)
        # Slurm ends what it had on both nodes.  A task that came back to its node before
        # that would be its second copy there, for which Slurm drains the node.
        self.wait_until(lambda: not self.solvers(), 60)
        subprocess.run(["scontrol", "update", "nodename=n2", "state=idle"])
        for job, index in self.tasks():
            subprocess.run(["scontrol", "update", f"jobid={job}_{index}", "starttime=now"],
                           capture_output=True)
        self.wait_until(lambda: len(set(self.attempts_of()) - before) > 0, 60)
        self.poreclog("cancel", "c", "--now")
        self.assertEqual(self.solvers(), [])
        self.poreclog("run", "c", SECONDS=0.2)
        self.assertEqual(self.content(), self.undisturbed(campaign))
        self.assertEqual(self.ask("SELECT DISTINCT kind FROM incident WHERE kind NOT IN "
                                  "('lost', 'duplicate')"), [])

    def test_that_end_a_task_at_slurms_own_limit_are_noticed(self):
        """Slurm's limit is beyond ours; somebody shortens it."""
        campaign = self.write(realisations=1, limits={"seconds_per_realisation": 600})
        self.poreclog("submit", campaign, FAULT="ignore_term")
        self.wait_until(self.attempts)
        job = self.only_job()
        subprocess.run(["scontrol", "update", f"jobid={job}", "timelimit=1"], check=True)
        self.wait_until(lambda: self.tasks()[(job, 0)] == "TIMEOUT", 150)
        self.poreclog("resume", "c", code=3)
        self.assertEqual(self.ask("SELECT cause FROM v_attempt WHERE attempt = 1"),
                         [("time_limit",)])
        self.finish()
        self.assertEqual(self.content(), self.undisturbed(campaign))


if __name__ == "__main__":
    unittest.main()
