#!/usr/bin/python3
"""The tier transient on one rank and on two: speed-up, balance and what the ranks tell each other.

The first milliseconds of the reference throat (with the settling of the liquid before), alternately
on one rank, on two, and as two runs of one rank at once: what the machine's second core is worth to
this program, the bound of any speed-up.  Another run counts the MPI calls of two ranks (tests/bench/mpi_calls.c).
Only on an idle machine do the times mean anything.  Writes
results/evidence/transient_ranks/generated.md.  Needs a release build and Open MPI.
Usage: python3 scripts/transient_ranks.py [--repeats N] [--help]
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import statistics
import subprocess
import tempfile
import time

import evidence

LAUNCH = ["mpirun", "--allow-run-as-root", "--bind-to", "none", "-n"]
LATENCY_BOUND = {"Allreduce", "Wait", "Waitall", "Recv", "Alltoall", "Alltoallv", "Bcast",
                 "Allgather", "Allgatherv", "Gatherv", "Scatterv", "Probe"}


def run(solver, scene, ranks, folder, preload=None):
    """(elapsed seconds, the program's JSON answer, what it said)"""
    environment = dict(os.environ)
    launch = [*LAUNCH, str(ranks)]
    if preload:
        environment["LD_PRELOAD"] = str(preload)
        launch += ["-x", "LD_PRELOAD"]
    begin = time.monotonic()
    done = evidence.finished([*launch, solver, "run", scene, "-o", folder / "r.h5", "--json"],
                             env=environment)
    return time.monotonic() - begin, json.loads(done.stdout), done.stderr


def two_at_once(solver, scene, folder):
    folders = [folder / "a", folder / "b"]
    for each in folders:
        each.mkdir(exist_ok=True)
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        return list(pool.map(lambda each: run(solver, scene, 1, each), folders))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    evidence.add_common_options(parser, "transient_ranks")
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--milliseconds", type=float, default=2.0)
    options = parser.parse_args()
    solver = options.solver.with_name("poreclog-solve-transient")
    provenance = evidence.provenance(options.solver)
    times = {1: [], 2: [], "1 + 1": []}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        base = json.loads((evidence.ROOT / "campaigns/throat.scene.json").read_text())
        base.update(duration=f"{options.milliseconds:g} ms", stop_when="duration",
                    fidelity={"tier": "transient", "cells_per_colloid": 5.5})
        scene = folder / "scene.json"
        scene.write_text(json.dumps(base))
        for _ in range(options.repeats):
            for ranks in (1, 2):
                times[ranks].append(run(solver, scene, ranks, folder)[0])
            times["1 + 1"].append(max(seconds for seconds, _, _ in two_at_once(solver, scene, folder)))
            print({ranks: f"{ts[-1]:.1f} s" for ranks, ts in times.items()}, flush=True)
        counter = folder / "mpi_calls.so"
        subprocess.run(["mpicc", "-shared", "-fPIC", "-O2",
                        str(evidence.ROOT / "tests/bench/mpi_calls.c"), "-o", str(counter)],
                       check=True)
        elapsed, said, errors = run(solver, scene, 2, folder, counter)
    steps = said["solver"]["steps"]
    calls = [line.split()[1:] for line in errors.splitlines() if line.startswith("mpi ")]
    speed_up = [a / b for a, b in zip(times[1], times[2])]
    bound = [2 * a / b for a, b in zip(times[1], times["1 + 1"])]
    waits = sum(float(c[3]) for c in calls)
    blocking = sum(int(c[1]) for c in calls if c[0] in LATENCY_BOUND)
    lines = ["# One rank and two: numbers", "", "Written by `scripts/transient_ranks.py`.", "",
             *provenance, "",
             f"{said['solver']['cells']:.0f} cells, {steps:.0f} steps (settling included).", "",
             "| ranks | elapsed [s], each run | median | ms a step |", "|---|---|---|---|",
             *(f"| {n} | {', '.join(f'{t:.1f}' for t in ts)} | {statistics.median(ts):.1f} | "
               f"{1e3 * statistics.median(ts) / steps:.1f} |" for n, ts in times.items()), "",
             "Speed-up of two ranks {:.2f} +- {:.2f}; two runs at once do {:.2f} +- {:.2f} of the work of "
             "one in its time (95 %, {} pairs).".format(
                 *evidence.interval(speed_up), *evidence.interval(bound), len(speed_up)), "",
             f"MPI on rank 0 of two, with the counter ({elapsed:.1f} s): {blocking / steps:.0f} calls "
             f"a step that may wait, {1e3 * waits / steps:.2f} ms a step inside MPI "
             f"({100 * waits / elapsed:.0f} % of the time).", "",
             "| call | a step | kB sent a step | ms a step |", "|---|---|---|---|",
             *(f"| {c[0]} | {int(c[1]) / steps:.1f} | {float(c[2]) / steps / 1e3:.1f} | "
               f"{1e3 * float(c[3]) / steps:.3f} |" for c in calls), ""]
    options.output.mkdir(parents=True, exist_ok=True)
    (options.output / "generated.md").write_text("\n".join(lines))


if __name__ == "__main__":
    main()
