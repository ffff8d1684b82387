"""Single colloids through the reference throat: tier transient against quasi_steady.

Writes results/evidence/transient/{trajectories,trajectories_by_place}.csv, trajectories.md and
trajectories.png: from ten places of the inlet, at equal resolution.  Some minutes a place; places
that the files already have, from the same commit, are not run again.  Needs a release build (both
solvers) and gnuplot.  Usage: python3 scripts/transient_trajectories.py [--help]
"""
import argparse
import concurrent.futures
import csv
import json
import pathlib
import tempfile

import h5py
import numpy as np

import evidence

SCENE = evidence.ROOT / "campaigns/throat.scene.json"
START = 120.0  # height [um]
PLACES = [(48.3, 48.3), (60, 52), (30, 45), (70, 30), (20, 60), (40, 75), (55, 65), (80, 50),
          (25, 25), (48.3, 35)]  # [um]
COLUMNS = ["place", "tier", "height_um", "x_um", "y_um", "time_s"]


def scene(place, tier, cells, courant):
    out = json.loads(SCENE.read_text())
    x, y = place
    out["geometry"]["bodies"] = [{"center": [f"{x} um", f"{y} um", f"{START} um"],
                                  "diameter": "13.3 um"}]
    out["colloids"]["volume_fraction"] = 0.0
    out["duration"] = "0.2 s"
    out["fidelity"] = {"tier": tier, "cells_per_colloid": cells}
    if tier == "transient":
        # The base grid: a colloid has twice as many.
        out["fidelity"].update(cells_per_colloid=cells / 2, courant=courant)
    return out


def path(solver, scene_object, folder):
    """(time, x, y, z) while it moves [s, um], its fate, processor seconds, steps."""
    file = pathlib.Path(folder) / "scene.json"
    file.write_text(json.dumps(scene_object))
    result = pathlib.Path(folder) / "result.h5"
    said = json.loads(evidence.finished([solver, "run", file, "-o", result, "--json"]).stdout)
    with h5py.File(result) as h5:
        position = h5["particles/colloids/position"]
        time = position["time"][()]
        x = 1e6 * position["value"][:, 0]
    result.unlink()
    there = np.isfinite(x[:, 2]) & np.r_[True, np.abs(np.diff(x[:, 2])) > 1e-4]
    fate = "caught" if said["counts"]["retained"] else "passed"
    return time[there], x[there], fate, said["solver"]


def at_heights(heights, time, x):
    order = np.argsort(x[:, 2])
    return [np.interp(heights, x[order, 2], v[order]) for v in (x[:, 0], x[:, 1], time)]


def draw(rows, folder):
    blocks, plots = [], []
    for place in sorted({int(r["place"]) for r in rows}):
        for tier, style in (("quasi_steady", "lw 4 lc rgb '#c0c0c0'"),
                            ("transient", "lw 1.2 lc rgb '#1f5fa0'")):
            points = "\n".join(f"{r['x_um']} {r['height_um']}" for r in rows
                               if int(r["place"]) == place and r["tier"] == tier)
            name = f"${tier}_{place}"
            blocks.append(f"{name} << EOD\n{points}\nEOD\n")
            title = f"title '{tier.replace('_', ' ')}'" if place == int(rows[0]["place"]) else "notitle"
            plots.append(f"{name} using 1:2 with lines {style} {title}")
    evidence.gnuplot(f"""
set terminal pngcairo size 760,760 font 'Liberation Sans,12'
set output '{folder / "trajectories.png"}'
{''.join(blocks)}
set xlabel 'x [um]'
set ylabel 'height [um]'
set xrange [0:96.6]
set yrange [0:125]
set size ratio -1
set key top right
plot {', '.join(plots)}
""")


def compare(number, options, commit):
    """One place: rows of both trajectories, and a row of what they differ in."""
    place = PLACES[number]
    solvers = {"quasi_steady": options.solver,
               "transient": options.solver.with_name("poreclog-solve-transient")}
    with tempfile.TemporaryDirectory() as folder:
        found = {tier: path(solver, scene(place, tier, options.cells, options.courant), folder)
                 for tier, solver in solvers.items()}
    low = max(f[1][:, 2].min() for f in found.values())
    heights = np.linspace(low, START, 60)
    curves = {tier: at_heights(heights, f[0], f[1]) for tier, f in found.items()}
    rows = [dict(zip(COLUMNS, (number, tier, *(float(f"{v:.5g}") for v in p))))
            for tier, (x, y, t) in curves.items() for p in zip(heights, x, y, t)]
    a, b = curves["quasi_steady"], curves["transient"]
    summary = {"place": number, "x_um": place[0], "y_um": place[1],
               "aside_um": np.hypot(a[0] - b[0], a[1] - b[1]).max(),
               "late_ms": 1e3 * np.abs(a[2] - b[2]).max(), "lasts_ms": 1e3 * a[2].max(),
               "lowest_um": low, "commit": commit}
    for tier, (_, _, fate, cost) in found.items():
        summary.update({f"{tier}_fate": fate, f"{tier}_cpu_s": cost["cpu_seconds"],
                        f"{tier}_steps": cost["steps"]})
    return rows, {k: f"{v:.4g}" if isinstance(v, float) else str(v) for k, v in summary.items()}


def kept(file, commit, places):
    """Rows that an earlier run of the same program left."""
    if not file.exists():
        return []
    rows = list(csv.DictReader(file.open()))
    return [r for r in rows if r.get("commit", commit) == commit and int(r["place"]) in places]


def table(summaries):
    lines = ["| from x, y [um] | down to [um] | apart sideways, largest [um] | in time, largest "
             "[ms] | of [ms] | fate | processor s | steps |", "|" + "---|" * 8]
    lines += [f"| {r['x_um']}, {r['y_um']} | {r['lowest_um']} | {r['aside_um']} | {r['late_ms']} | "
              f"{r['lasts_ms']} | {r['quasi_steady_fate']} / {r['transient_fate']} | "
              f"{r['quasi_steady_cpu_s']} / {r['transient_cpu_s']} | {r['transient_steps']} |"
              for r in summaries]
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    evidence.add_common_options(parser, "transient")
    parser.add_argument("--places", type=int, default=len(PLACES))
    parser.add_argument("--cells", type=float, default=8, help="per colloid diameter")
    parser.add_argument("--courant", type=float, default=0.3)
    parser.add_argument("--workers", type=int, default=1, help="places at a time")
    options = parser.parse_args()
    options.output.mkdir(parents=True, exist_ok=True)
    provenance = evidence.provenance(options.solver)
    commit = evidence.commit(options.solver)
    files = [options.output / "trajectories.csv", options.output / "trajectories_by_place.csv"]
    summaries = kept(files[1], commit, range(options.places))
    done = {int(r["place"]) for r in summaries}
    rows = kept(files[0], commit, done)
    with concurrent.futures.ThreadPoolExecutor(options.workers) as pool:
        tasks = [pool.submit(compare, number, options, commit)
                 for number in range(options.places) if number not in done]
        for task in concurrent.futures.as_completed(tasks):
            more, summary = task.result()
            rows += more
            summaries.append(summary)
            for file, content in zip(files, (rows, summaries)):
                content.sort(key=lambda r: int(r["place"]))
                evidence.write_rows(file, content)
            print(table([summary])[-1], flush=True)
    (options.output / "trajectories.md").write_text("\n".join([
        *provenance, "",
        f"{options.cells:g} cells per colloid diameter in both tiers, Courant number "
        f"{options.courant:g}, start at {START:g} um.", "", *table(summaries), "",
        "Fate and processor seconds: quasi_steady / transient.", ""]))
    draw(rows, options.output)


if __name__ == "__main__":
    main()
