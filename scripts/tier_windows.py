#!/usr/bin/python3
"""The same 0.5 s of the reference throat in all three tiers, clean and partly clogged; cost of each.

Both windows inject the same colloids (seed 5).  The partly clogged one begins with the colloids of
results/evidence/tier_windows/deposit.csv (columns as for `measure --deposit`), which every tier
retains where they are.  Cost without local refinement: 2 ms of the clean window on a grid as fine
everywhere as the refined one is at colloids.  Takes finished results of the folder --results,
runs what is missing there (the transient tier with checkpoints: it can be stopped) and writes
results/evidence/tier_windows/{windows.csv,captures.csv,generated.md}.
Needs a release build of both solvers and Debian's python3-h5py.
Usage: python3 scripts/tier_windows.py [--help]
"""
import argparse
import csv
import json
import pathlib

import h5py
import numpy

import evidence

SEED = 5
CELLS = 5.5  # per colloid diameter; the transient tier halves the cell at colloids
SECONDS = 0.5
PAPER = 3500.0  # core-hours of one realisation
# Name: begins with the deposit, duration [s], key "fidelity".
RUNS = {
    f"{state}-{tier}": (state == "clogged", SECONDS, {"tier": tier, "cells_per_colloid": CELLS})
    for tier in ("one_way", "quasi_steady", "transient") for state in ("clean", "clogged")}
RUNS["clean-transient-2ms"] = (False, 0.002, {"tier": "transient", "cells_per_colloid": CELLS})
# The whole realisation, as coarsely as the tier may: ten cells per colloid, Courant number 1.
WHOLE = {"tier": "transient", "cells_per_colloid": 5, "courant": 1.0}
for fidelity in (RUNS["clean-one_way"][2], RUNS["clean-quasi_steady"][2], WHOLE):
    RUNS[f"whole-{fidelity['tier']}"] = (False, 5.0, fidelity)
RUNS["clean-transient-2ms-uniform"] = (
    False, 0.002, {"tier": "transient", "cells_per_colloid": 2 * CELLS, "refinement": 0})


def scene(deposit, clogged, seconds, fidelity):
    out = json.loads((evidence.ROOT / "campaigns/throat.scene.json").read_text())
    out.update(duration=f"{seconds:g} s", stop_when="duration", fidelity=fidelity)
    if clogged:
        with open(deposit, newline="") as file:
            out["geometry"]["bodies"] = [
                {"center": [f"{1e6 * float(row[key]):.9f} um" for key in ("x_m", "y_m", "z_m")],
                 "diameter": f"{1e6 * float(row['diameter_m']):g} um"}
                for row in csv.DictReader(file)]
    return out


def run_missing(options, name):
    path = options.results / name
    clogged, seconds, fidelity = RUNS[name]
    path.with_suffix(".scene.json").write_text(
        json.dumps(scene(options.deposit, clogged, seconds, fidelity), indent=1))
    solver = options.solver
    if fidelity["tier"] == "transient":
        solver = solver.with_name("poreclog-solve-transient")
    done = evidence.finished(["/usr/bin/time", "-f", "%M", "-o", f"{path}.memory", solver, "run",
                              f"{path}.scene.json", "--seed", SEED, "-o", f"{path}.h5",
                              "--checkpoint", f"{path}.ckpt", "--json"])
    path.with_suffix(".json").write_text(done.stdout)


def load(folder, name, earlier=0.0):
    """What a window gave, or None if it has not finished; `earlier`: processor seconds that its
    result does not count."""
    answer = folder / f"{name}.json"
    if not answer.exists():
        return None
    said = json.loads(answer.read_text())
    said["solver"]["cpu_seconds"] += earlier
    clogged, seconds, fidelity = RUNS[name]
    out = {"run": name, "tier": fidelity["tier"], "clogged": clogged, "seconds": seconds,
           "solver": said["solver"],
           "memory_MB": float((folder / f"{name}.memory").read_text().split()[-1]) / 1024}
    with h5py.File(folder / f"{name}.h5") as file:
        if int(file.attrs["complete"]) != 1:
            return None
        out["commit"] = evidence.text(file["/provenance"].attrs["commit"])[:7]
        series = file["series"]
        out["width"] = [1e6 * series["critical_diameter_m"][i] for i in (0, -1)]
        out["permeability"] = [series["permeability_ratio"][i] for i in (0, -1)]
        out["traversed"] = int(file.attrs["traversed"])
        out["captures"] = [
            (int(c), float(t), x) for c, t, x in zip(
                file["retained/colloid"], file["retained/time_s"], file["retained/position_m"][()])]
    out["at_start"] = sum(1 for c in out["captures"] if c[1] == 0.0)
    return out


def rows_of(found):
    return [{"run": r["run"], "cpu_s": r["solver"]["cpu_seconds"], "steps": r["solver"]["steps"],
             "cells": r["solver"].get("cells", numpy.nan), "memory_MB": r["memory_MB"],
             "retained_at_start": r["at_start"],
             "retained_since": len(r["captures"]) - r["at_start"], "traversed": r["traversed"],
             "width_start_um": r["width"][0], "width_end_um": r["width"][1],
             "permeability_start": r["permeability"][0], "permeability_end": r["permeability"][1]}
            for r in found]


COLUMNS = [("run", "s"), ("cpu_s", ".1f"), ("steps", ".0f"), ("cells", ".0f"),
           ("memory_MB", ".0f"), ("retained_at_start", "d"), ("retained_since", "d"),
           ("traversed", "d"), ("width_start_um", ".3f"), ("width_end_um", ".3f"),
           ("permeability_start", ".4f"), ("permeability_end", ".4f")]


def capture_rows(found):
    """Colloids retained since the start, with their distance from quasi_steady's place."""
    out = []
    for clogged in (False, True):
        runs = [r for r in found if r["clogged"] == clogged and r["seconds"] == SECONDS]
        there = {c: (t, x) for r in runs if r["tier"] == "quasi_steady"
                 for c, t, x in r["captures"] if t > 0.0}
        for r in runs:
            for colloid, time, x in r["captures"]:
                if time > 0.0:
                    apart = (1e6 * float(numpy.linalg.norm(x - there[colloid][1]))
                             if colloid in there else numpy.nan)
                    later = 1e3 * (time - there[colloid][0]) if colloid in there else numpy.nan
                    out.append({"run": r["run"], "colloid": colloid, "time_s": time,
                                "later_ms": later, "apart_um": apart})
    return out


def extrapolated(found, tier):
    """Core-hours of 5 s: the mean of clean and partly clogged, and half their difference."""
    hours = [5.0 / SECONDS * r["solver"]["cpu_seconds"] / 3600.0 for r in found
             if r["tier"] == tier and r["seconds"] == SECONDS]
    return (sum(hours) / 2, abs(hours[0] - hours[1]) / 2) if len(hours) == 2 else None


def markdown(found):
    lines = ["| " + " | ".join(name for name, _ in COLUMNS) + " |", "|---" * len(COLUMNS) + "|",
             *("| " + " | ".join(format(row[name], spec) for name, spec in COLUMNS) + " |"
               for row in rows_of(found)), ""]
    for tier in ("one_way", "quasi_steady", "transient"):
        if hours := extrapolated(found, tier):
            lines.append(f"- {tier}: 5 s extrapolated to {hours[0]:.3g} +- {hours[1]:.2g} core-hours "
                         f"({PAPER / hours[0]:.0f} times less than {PAPER:.0f})")
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    evidence.add_common_options(parser, "tier_windows")
    parser.add_argument("--results", type=pathlib.Path, default=evidence.ROOT / "build/tier_windows",
                        help="folder of the realisations")
    parser.add_argument("--deposit", type=pathlib.Path,
                        default=evidence.ROOT / "results/evidence/tier_windows/deposit.csv")
    parser.add_argument("--no-run", action="store_true", help="only what is finished")
    parser.add_argument("--only", default="", help="runs whose name has this word")
    parser.add_argument("--earlier", default="", metavar="RUN=SECONDS",
                        help="processor seconds before a run was continued, by a program that "
                        "counts only those after")
    options = parser.parse_args()
    earlier = dict([options.earlier.split("=")]) if options.earlier else {}
    provenance = evidence.provenance(options.solver)
    options.results.mkdir(parents=True, exist_ok=True)
    options.output.mkdir(parents=True, exist_ok=True)
    for name in RUNS:
        if not options.no_run and options.only in name and load(options.results, name) is None:
            run_missing(options, name)
    found = [r for r in (load(options.results, name, float(earlier.get(name, 0.0)))
                         for name in RUNS) if r]
    evidence.write_csv(options.output / "windows.csv", COLUMNS, rows_of(found))
    evidence.write_csv(options.output / "captures.csv",
                       [("run", "s"), ("colloid", "d"), ("time_s", ".6f"), ("later_ms", ".3f"),
                        ("apart_um", ".3f")], capture_rows(found))
    commits = ", ".join(sorted({r["commit"] for r in found}))
    (options.output / "generated.md").write_text("\n".join(
        [*markdown(found), "", *provenance, f"- commits of the results: {commits}", ""]))


if __name__ == "__main__":
    main()
