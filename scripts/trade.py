#!/usr/bin/python3
"""one_way against quasi_steady on the same seeds of the reference scene: what differs, what it costs.

Takes finished results of the folder --results and runs what is missing there (unless --no-run),
then writes results/evidence/trade/{realisations.csv,paired.csv,captures.csv,trade.png,generated.md}
from the seeds that both tiers have finished.  Results are named TIER-CELLS-sSEED.h5 with
the JSON answer of the program beside them.  Needs a release build, gnuplot and Debian's python3-h5py.
Usage: python3 scripts/trade.py [--help]
"""
import argparse
import json
import math
import pathlib
import sys

import h5py
import numpy

import evidence

DURATION = 5.0
TIERS = ("one_way", "quasi_steady")
# Cells per colloid diameter, seeds.
SETS = [("5.5", tuple(range(1, 11))), ("10", (4, 1))]
MATCHED = 1e-9  # [s] instants of the series that are the same


def stem(folder, tier, cells, seed):
    return folder / f"{tier}-{cells}-s{seed}"


def run_missing(solver, folder, tier, cells, seed):
    base = json.loads((evidence.ROOT / "campaigns/throat.scene.json").read_text())
    base["fidelity"] = {"tier": tier, "cells_per_colloid": float(cells)}
    path = stem(folder, tier, cells, seed)
    scene = folder / f"{tier}-{cells}.scene.json"
    scene.write_text(json.dumps(base, indent=1))
    done = evidence.finished([solver, "run", scene, "--seed", seed, "-o", f"{path}.h5",
                              "--checkpoint", f"{path}.ckpt", "--json"])
    path.with_name(path.name + ".json").write_text(done.stdout)


def load(folder, tier, cells, seed):
    """What a realisation found, or None if it has not finished."""
    path = stem(folder, tier, cells, seed)
    result = path.with_name(path.name + ".h5")
    answer = path.with_name(path.name + ".json")
    if not result.exists() or not answer.exists() or answer.stat().st_size == 0:
        return None
    out = {"tier": tier, "cells": cells, "seed": seed,
           "solver": json.loads(answer.read_text())["solver"]}
    with h5py.File(result) as file:
        if file.attrs["complete"] != 1 or abs(file.attrs["duration_s"] - DURATION) > MATCHED:
            return None
        scene = json.loads(file["/provenance/scene"][()])
        asked = (tier, float(cells), str(seed))
        found = (scene["fidelity"]["tier"], scene["fidelity"]["cells_per_colloid"],
                 evidence.text(file.attrs["seed"]))
        if asked != found:
            sys.exit(f"{result}: is {found}, expected {asked}")
        out["commit"] = evidence.text(file["/provenance"].attrs["commit"])
        for key in ("t1_s", "tc_s", "alpha_deg"):
            out[key] = float(file.attrs[key])
        for key in ("injected", "retained", "traversed"):
            out[key] = int(file.attrs[key])
        out["series"] = {key: file["series"][key][()]
                         for key in ("time_s", "critical_diameter_m", "permeability_ratio",
                                     "retained")}
        out["captures"] = {int(c): (int(o), float(t), x, str(layer)) for c, o, t, x, layer in zip(
            file["retained/colloid"], file["retained/order"], file["retained/time_s"],
            file["retained/position_m"][()], file["retained/layer"].asstr())}
    return out


def restricted(time):
    """min(t, duration): its mean needs no t beyond the end of the run, so the seeds in which
    nothing happened count too."""
    return DURATION if math.isnan(time) else min(time, DURATION)


def kendall(pairs):
    """tau of pairs without ties; nan for fewer than two."""
    n = len(pairs)
    signs = [math.copysign(1, (a[0] - b[0]) * (a[1] - b[1]))
             for i, a in enumerate(pairs) for b in pairs[:i]]
    return sum(signs) / len(signs) if n > 1 else math.nan


def compare_captures(fast, full):
    """Order and positions of the colloids that both tiers retain."""
    both = sorted(set(fast["captures"]) & set(full["captures"]))
    pairs = [(fast["captures"][c][0], full["captures"][c][0]) for c in both]
    apart = [1e6 * float(numpy.linalg.norm(fast["captures"][c][2] - full["captures"][c][2]))
             for c in both]
    grains = [1e6 * float(numpy.linalg.norm(fast["captures"][c][2] - full["captures"][c][2]))
              for c in both if fast["captures"][c][3] == full["captures"][c][3] == "first"]
    first = [min(r["captures"], key=lambda c, r=r: r["captures"][c][0], default=None)
             for r in (fast, full)]
    return {"both": len(both), "only_one_way": len(fast["captures"]) - len(both),
            "only_quasi_steady": len(full["captures"]) - len(both),
            "same_first": int(first[0] is not None and first[0] == first[1]),
            "order_tau": kendall(pairs),
            "apart_um": float(numpy.median(apart)) if apart else math.nan,
            "apart_on_grains_um": float(numpy.median(grains)) if grains else math.nan}


def at_outputs(results, key):
    """Rows: realisations, columns: the instants that all share (an end may add another)."""
    shared = results[0]["series"]["time_s"]
    for r in results[1:]:
        shared = shared[numpy.isin(numpy.round(shared, 9), numpy.round(r["series"]["time_s"], 9))]
    rows = []
    for r in results:
        keep = numpy.isin(numpy.round(r["series"]["time_s"], 9), numpy.round(shared, 9))
        rows.append(r["series"][key][keep][:len(shared)])
    return shared, numpy.array(rows, dtype=float)


def paired_rows(pairs, cells):
    """Differences one_way less quasi_steady over the seeds, with 95 % t-intervals."""
    table = []

    def add(name, fast, full, spec=".3g"):
        values = [b - a for a, b in zip(full, fast) if not math.isnan(a + b)]
        mean, half = evidence.interval(values)
        fine = [v for v in fast if not math.isnan(v)]
        coarse = [v for v in full if not math.isnan(v)]
        table.append({"cells": cells, "quantity": name, "n": len(values),
                      "one_way": numpy.mean(fine) if fine else math.nan,
                      "quasi_steady": numpy.mean(coarse) if coarse else math.nan,
                      "difference": mean, "half_interval": half, "spec": spec})

    def both(get):
        return [get(fast) for fast, _ in pairs], [get(full) for _, full in pairs]

    add("min(t_1, 5 s) [s]", *both(lambda r: restricted(r["t1_s"])))
    add("t_1 where both have one [s]", *both(lambda r: r["t1_s"]))
    add("min(t_c, 5 s) [s]", *both(lambda r: restricted(r["tc_s"])))
    add("t_c where both have one [s]", *both(lambda r: r["tc_s"]))
    add("clogged by 5 s", *both(lambda r: float(not math.isnan(r["tc_s"]))))
    add("retained by 5 s", *both(lambda r: float(r["retained"])))
    add("alpha where both have one [deg]", *both(lambda r: r["alpha_deg"]))
    everything = [r for pair in pairs for r in pair]
    time, length = at_outputs(everything, "critical_diameter_m")
    _, ratio = at_outputs(everything, "permeability_ratio")
    logarithm = numpy.log10(numpy.maximum(ratio, 1e-6))
    for name, rows, scale in (("l_c, mean over 5 s [um]", length, 1e6),
                              ("log10 of k/k_0, mean over 5 s", logarithm, 1.0)):
        mean = scale * numpy.trapz(rows, time) / (time[-1] - time[0])
        add(name, mean[0::2], mean[1::2])
    for t in (1.0, 2.0, 3.0, 4.0, 5.0):
        at = int(numpy.argmin(abs(time - t)))
        add(f"l_c at {t:g} s [um]", 1e6 * length[0::2, at], 1e6 * length[1::2, at])
    for t in (1.0, 2.0, 3.0, 4.0, 5.0):
        at = int(numpy.argmin(abs(time - t)))
        add(f"k/k_0 at {t:g} s", ratio[0::2, at], ratio[1::2, at])
    return table


def units_per_solve(result):
    solver = result["solver"]
    return (solver["resolved_work_units"] / solver["resolved_solves"]
            if "resolved_solves" in solver else math.nan)


def cell(value, spec):
    return "-" if value is None or math.isnan(value) else format(value, spec)


def tables(pairs, captures, paired, cells):
    lines = [f"### {cells} cells per colloid: {len(pairs)} seeds finished by both tiers", "",
             "one_way / quasi_steady; \"same\": the first retained colloid is the same one.", "",
             "| seed | t_1 [s] | t_c [s] | retained | in both | same | tau of their order | "
             "apart, median [um] | alpha [deg] | k/k_0 at 5 s | processor s | solves | "
             "work units a solve |", "|" + "---|" * 13]
    for (fast, full), c in zip(pairs, captures):
        lines.append("| {} | {} / {} | {} / {} | {} / {} | {} | {} | {} | {} | {} / {} | {} / {} | "
                     "{} / {} | {} | {} |".format(
                         fast["seed"], *(cell(r["t1_s"], ".3f") for r in (fast, full)),
                         *(cell(r["tc_s"], ".3f") for r in (fast, full)),
                         fast["retained"], full["retained"], c["both"],
                         "yes" if c["same_first"] else "no", cell(c["order_tau"], ".2f"),
                         cell(c["apart_um"], ".1f"),
                         *(cell(r["alpha_deg"], ".0f") for r in (fast, full)),
                         *(format(r["series"]["permeability_ratio"][-1], ".3f")
                           for r in (fast, full)),
                         *(format(r["solver"]["cpu_seconds"], ".1f") for r in (fast, full)),
                         format(full["solver"]["resolved_solves"], ".0f"),
                         cell(units_per_solve(full), ".1f")))
    lines += ["", "Means over the seeds, differences paired by seed with 95 % t-intervals:", "",
              "| | seeds | one_way | quasi_steady | one_way less quasi_steady |", "|---|---|---|---|---|"]
    for row in paired:
        half = row["half_interval"]
        lines.append(f"| {row['quantity']} | {row['n']} | {cell(row['one_way'], row['spec'])} | "
                     f"{cell(row['quasi_steady'], row['spec'])} | "
                     f"{cell(row['difference'], row['spec'])}"
                     + (f" +- {half:.2g}" if not math.isnan(half) else "") + " |")
    return lines + [""]


def grid_table(results):
    """The same seed and tier on both grids."""
    lines = ["### The grid: the same seed at 5.5 and 10 cells per colloid", "",
             "| tier | seed | t_1 [s] | t_c [s] | retained | in both | processor s |",
             "|" + "---|" * 7]
    for tier in TIERS:
        for seed in SETS[1][1]:
            coarse = results.get((tier, SETS[0][0], seed))
            fine = results.get((tier, SETS[1][0], seed))
            if coarse and fine:
                two = (coarse, fine)
                shared = len(set(coarse["captures"]) & set(fine["captures"]))
                lines.append("| {} | {} | {} / {} | {} / {} | {} / {} | {} | {} / {} |".format(
                    tier, seed, *(cell(r["t1_s"], ".3f") for r in two),
                    *(cell(r["tc_s"], ".3f") for r in two), *(r["retained"] for r in two), shared,
                    *(format(r["solver"]["cpu_seconds"], ".1f") for r in two)))
    return lines + [""] if len(lines) > 4 else []


def draw(pairs, path):
    """Paired t_1 and t_c, and the mean courses of l_c and k with their intervals."""
    n = len(pairs)
    ticks = [("t1_s", 1, 7), ("tc_s", 2, 5)]
    blocks, scatter = [], []
    for name, colour, shape in ticks:
        points = "\n".join(f"{restricted(full[name])} {restricted(fast[name])}"
                           for fast, full in pairs)
        blocks.append(f"${name} << EOD\n{points}\nEOD")
        title = {"t1_s": "t_1", "tc_s": "t_c"}[name]
        scatter.append(f"${name} with points pt {shape} ps 1.3 lc {colour} title '{title}'")
    courses = []
    for key, scale in (("critical_diameter_m", 1e6), ("permeability_ratio", 1.0),
                       ("retained", 1.0)):
        curves = []
        for i, tier in enumerate(TIERS):
            time, rows = at_outputs([pair[i] for pair in pairs], key)
            mean = scale * rows.mean(axis=0)
            half = numpy.array([evidence.interval(list(scale * c))[1] for c in rows.T])
            half = numpy.nan_to_num(half)
            text = "\n".join(f"{t} {m} {m - h} {m + h}" for t, m, h in zip(time, mean, half))
            blocks.append(f"${key}{i} << EOD\n{text}\nEOD")
            curves.append(f"${key}{i} using 1:3:4 with filledcurves fs transparent solid 0.2 lc "
                          f"{i + 1} notitle, ${key}{i} using 1:2 with lines lw 2 lc {i + 1} "
                          f"title '{tier}'")
        courses.append(", ".join(curves))
    evidence.gnuplot("\n".join(blocks) + f"""
set terminal pngcairo size 1300,950 font 'sans,11' noenhanced
set output '{path}'
set multiplot layout 2,2 title '{n} seeds, both tiers on the same injections; bands: 95 % of the mean'
set grid; set key bottom right
set xlabel 'quasi_steady [s]'; set ylabel 'one_way [s]'; set size ratio -1
set xrange [0:5.2]; set yrange [0:5.2]
set title 'first retention and clogging (5 s: not yet)'
plot x with lines lc 'gray' notitle, {", ".join(scatter)}
set size noratio; set autoscale y; set xrange [0:5]; set xlabel 'time [s]'; set key top right
set title 'largest sphere that can pass'; set ylabel 'l_c [um]'
plot {courses[0]}
set title 'permeability over that of the clean throat'; set ylabel 'k/k_0'; set yrange [0:1.05]
plot {courses[1]}
set title 'retained colloids'; set ylabel 'retained'; set autoscale y; set key top left
plot {courses[2]}
unset multiplot
""")


def write_tables(folder, results, pairs_by_set, captures_by_set, paired):
    columns = [(c, "") for c in ("tier", "cells", "seed", "t1_s", "tc_s", "alpha_deg", "injected",
                                 "retained", "traversed", "cpu_seconds", "steps",
                                 "resolved_solves", "resolved_work_units", "commit")]
    rows = []
    for r in results.values():
        row = {name: r.get(name, r["solver"].get(name, math.nan)) for name, _ in columns}
        rows.append(row)
    evidence.write_csv(folder / "realisations.csv", columns, rows)
    evidence.write_csv(folder / "paired.csv",
                       [("cells", ""), ("quantity", ""), ("n", "")] +
                       [(k, ".6g") for k in ("one_way", "quasi_steady", "difference",
                                             "half_interval")],
                       [{**row, "quantity": row["quantity"].replace(",", ";")} for row in paired])
    flat = [{"cells": cells, "seed": fast["seed"], **c}
            for cells, _ in SETS
            for (fast, _), c in zip(pairs_by_set[cells], captures_by_set[cells])]
    evidence.write_csv(folder / "captures.csv",
                       [(k, "") for k in flat[0]], flat)


def cost_lines(results):
    out = ["### Cost", "",
           "| tier | cells | realisations | processor s, mean | least | most | work units a solve | "
           "solver commit |", "|" + "---|" * 8]
    for tier in TIERS:
        for cells, _ in SETS:
            mine = [r for (t, c, _), r in results.items() if (t, c) == (tier, cells)]
            if not mine:
                continue
            seconds = [r["solver"]["cpu_seconds"] for r in mine]
            solves = sum(r["solver"].get("resolved_solves", 0) for r in mine)
            units = sum(r["solver"].get("resolved_work_units", 0) for r in mine)
            out.append(f"| {tier} | {cells} | {len(mine)} | {numpy.mean(seconds):.1f} | "
                       f"{min(seconds):.1f} | {max(seconds):.1f} | "
                       f"{cell(units / solves if solves else math.nan, '.1f')} | "
                       f"{', '.join(sorted({r['commit'] for r in mine}))} |")
    return out + [""]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    evidence.add_common_options(parser, "trade")
    parser.add_argument("--results", type=pathlib.Path, default=evidence.ROOT / "build/trade",
                        help="folder of results, kept (default: build/trade)")
    parser.add_argument("--no-run", action="store_true", help="only what is finished")
    parser.add_argument("--tiers", nargs="*", default=TIERS, choices=TIERS,
                        help="tiers to run where results are missing")
    options = parser.parse_args()
    lines = evidence.provenance(options.solver)
    options.results.mkdir(parents=True, exist_ok=True)
    results = {}
    for cells, seeds in SETS:
        for seed in seeds:
            for tier in TIERS:
                found = load(options.results, tier, cells, seed)
                if found is None and not options.no_run and tier in options.tiers:
                    run_missing(options.solver, options.results, tier, cells, seed)
                    found = load(options.results, tier, cells, seed)
                if found:
                    results[tier, cells, seed] = found
    options.output.mkdir(parents=True, exist_ok=True)
    pairs, captures, paired, body = {}, {}, [], []
    for cells, seeds in SETS:
        pairs[cells] = [tuple(results[tier, cells, seed] for tier in TIERS) for seed in seeds
                        if all((tier, cells, seed) in results for tier in TIERS)]
        captures[cells] = [compare_captures(*pair) for pair in pairs[cells]]
        if pairs[cells]:
            rows = paired_rows(pairs[cells], cells)
            paired += rows
            body += tables(pairs[cells], captures[cells], rows, cells)
    if not paired:
        sys.exit(f"{options.results}: no seed is finished by both tiers")
    write_tables(options.output, results, pairs, captures, paired)
    draw(pairs[SETS[0][0]] or pairs[SETS[1][0]], options.output / "trade.png")
    text = ["# one_way against quasi_steady: tables", "",
            "Written by `scripts/trade.py`; README.md says what they mean. The load is that when",
            "the tables were made; each realisation's own seconds are in realisations.csv.", "",
            *lines, "", *body, *grid_table(results), *cost_lines(results)]
    (options.output / "generated.md").write_text("\n".join(text).rstrip() + "\n")
    print("\n".join(body))


if __name__ == "__main__":
    main()
