"""What a campaign on Slurm costs, measured on a cluster of two emulated nodes, and what that
means for 100,000 realisations: results/evidence/slurm/README.md.
Usage: python3 scripts/slurm_scale.py [REALISATIONS] [BUILD]   (2000, build/release)"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests/slurm"))
from cluster import Cluster, wait_until  # noqa: E402

count = int(sys.argv[1]) if len(sys.argv) > 1 else 2000
build = ROOT / (sys.argv[2] if len(sys.argv) > 2 else "build/release")
many = 100_000
poreclog = build / "orchestrator/poreclog"
os.environ.update(PORECLOG_SOLVER=str(build / "tests/anomaly/fake_solver"),
                  PORECLOG_NO_REPORT="1")


def run(*words):
    begin = time.monotonic()
    done = subprocess.run([poreclog, *words, "--json"], capture_output=True, text=True)
    if done.returncode not in (0, 3):
        raise RuntimeError(done.stderr)
    return json.loads(done.stdout), time.monotonic() - begin


def campaign(name, realisations, **slurm):
    path = pathlib.Path(name + ".json")
    path.write_text(json.dumps({
        "campaign": name, "scene": {}, "realisations": realisations, "master_seed": 1,
        "executor": "slurm", "slurm": slurm, "limits": {"seconds_per_realisation": 600}}))
    return path


with tempfile.TemporaryDirectory() as work:
    os.chmod(work, 0o755)  # munged asks for it
    os.chdir(work)
    cluster = Cluster(work + "/slurm")
    try:
        cluster.start()
        plan, _ = run("run", campaign("many", many), "--dry-run")
        file = campaign("some", count, realisations_per_task=20)
        begin = time.monotonic()
        _, submit = run("submit", file)
        _, busy = run("status", "some")
        wait_until(lambda: not cluster.queue("PD,R,CG,S,CF"), "the campaign", 1500)
        all_tasks = time.monotonic() - begin
        squeue = time.monotonic()
        cluster.tasks()
        squeue = time.monotonic() - squeue
        folded, fold = run("status", "some")
        assert folded["total"]["ingested"] == count, folded["total"]
        _, idle = run("status", "some")
    finally:
        cluster.stop()
    runs = pathlib.Path("results/runs/some")
    inodes = sum(1 for _ in runs.rglob("*"))
    size = sum(p.stat().st_size for p in runs.rglob("*") if p.is_file())
    database = sum(p.stat().st_size for p in pathlib.Path("results").glob("poreclog.sqlite*"))

per = many / count
slurm = plan["slurm"]
tasks = -(-many // slurm["per_task"])
version = subprocess.run([poreclog, "--version"], capture_output=True, text=True).stdout
cpu = next(line.split(":")[1].strip() for line in open("/proc/cpuinfo")
           if line.startswith("model name"))
out = ROOT / "results/evidence/slurm/README.md"
out.parent.mkdir(parents=True, exist_ok=True)
out.write_text(f"""# What a campaign on Slurm costs

Run: {count} realisations of a solver that only writes its file (100 output times), 20 per task,
on Slurm 22.05 with two emulated nodes on one machine. Worked out: {many} realisations, each
number in proportion, but for the layout, which `submit --dry-run` gave for the default limits of
Slurm (MaxArraySize 1001, MaxJobCount 10000).

| | run: {count} | worked out: {many} |
|---|---|---|
| calls of sbatch | {-(-count // 20 // 1000) or 1} | {slurm["sbatch_calls"]} |
| tasks, realisations per task | {-(-count // 20)}, 20 | {tasks}, {slurm["per_task"]} |
| `submit` | {submit:.1f} s | {submit * per:.0f} s |
| `status` just after it | {busy:.2f} s | {busy * per:.0f} s at most |
| until all tasks had ended | {all_tasks:.0f} s | (the cluster's own) |
| `status` that folds in all of them | {fold:.1f} s, {1e3 * fold / count:.2f} ms each | {fold * per:.0f} s |
| `status` when nothing is new | {idle:.2f} s | {idle * per:.1f} s |
| squeue of all tasks | {squeue:.3f} s | {squeue * tasks / (count / 20):.1f} s |
| files and folders | {inodes} | {inodes * per:.0f} |
| run folders | {size / 1e6:.1f} MB | {size * per / 1e9:.2f} GB |
| database | {database / 1e6:.1f} MB | {database * per / 1e9:.2f} GB |

Polling: a waiting `run` pauses twenty times as long as its squeue took, 1 to 60 s: with
{tasks} tasks in the queue once in {min(60.0, max(1.0, 20 * squeue * tasks / (count / 20))):.0f} s.

Assumptions. All is in proportion to the number of realisations (sorting and the depth of
SQLite's trees, which grow with its logarithm, are left out). The folders are on a local disk: on
a network file system a folder takes 0.5 to 5 ms instead of some 10 us, so `submit`, which makes
two folders and a file for each realisation, takes minutes for {many}. A real result of 5 s is
larger than the one here (some 100 kB), and the run folders grow with it; the database does not.
Nobody else uses the cluster: other users' jobs count in MaxJobCount, of which half is taken at most.

- command: `python3 scripts/slurm_scale.py {count} {build.relative_to(ROOT)}`
- program: {version.strip()}
- machine: {cpu}, {os.cpu_count()} cores, load {os.getloadavg()[0]:.1f} (times are too long if other programs ran)
- date: {time.strftime("%Y-%m-%d %H:%M UTC", time.gmtime())}
""")
print(out.read_text())
