"""What each option of the tier one_way changes, on the same seeds, and what it costs.

Runs the reference scene (5 s) with one option changed at a time and writes
results/evidence/one_way/{realisations.csv,table.csv,effects.png,README.md}.  Realisations
that realisations.csv already has, made by the same commit, are not run again.  Needs a
release build and gnuplot.  Usage: python3 scripts/one_way_effects.py [--help]
"""
import argparse
import concurrent.futures
import csv
import json
import math
import pathlib
import subprocess
import tempfile

import evidence

SEEDS = range(1, 11)
TWO = (1, 2)  # where ten would take hours
REFERENCE = "reference"
# Group, name, changes of the scene, seeds.
VARIANTS = [
    ("reference", REFERENCE, {}, SEEDS),
    ("hindrance", "none", {"fidelity/hindrance": "none"}, SEEDS),
    ("hindrance", "wall", {"fidelity/hindrance": "wall"}, SEEDS),
    ("capture gap", "5 nm", {"fidelity/capture_gap": "5 nm"}, SEEDS),
    ("capture gap", "13 nm", {"fidelity/capture_gap": "13 nm"}, SEEDS),
    ("capture gap", "50 nm", {"fidelity/capture_gap": "50 nm"}, SEEDS),
    ("capture gap", "100 nm", {"fidelity/capture_gap": "100 nm"}, SEEDS),
    ("capture gap", "one cell", {"fidelity/capture_gap": "2.415 um"}, SEEDS),
    ("cells per colloid", "4", {"fidelity/cells_per_colloid": 4}, SEEDS),
    ("cells per colloid", "8", {"fidelity/cells_per_colloid": 8}, SEEDS),
    ("cells per colloid", "11", {"fidelity/cells_per_colloid": 11}, TWO),
    ("flow tolerance", "1e-4", {"fidelity/tolerance": 1e-4}, SEEDS),
    ("flow tolerance", "1e-8", {"fidelity/tolerance": 1e-8}, SEEDS),
    ("bonds", "breakable", {"bonds": "breakable"}, SEEDS),
]
COLUMNS = ["group", "variant", "seed", "t1_s", "tc_s", "critical_diameter_m",
           "permeability_ratio", "injected", "retained", "traversed", "delayed",
           "overlaps", "steps", "flow_solves", "flow_iterations", "cpu_seconds",
           "flow_seconds", "bonds_broken", "commit"]


def changed(scene, changes):
    scene = json.loads(json.dumps(scene))
    for pointer, value in changes.items():
        *path, last = pointer.split("/")
        node = scene
        for key in path:
            node = node.setdefault(key, {})
        node[last] = value
    return scene


def realise(solver, folder, group, name, changes, seed, commit):
    base = json.loads((evidence.ROOT / "campaigns/throat.scene.json").read_text())
    stem = pathlib.Path(folder) / f"{group}-{name}-{seed}".replace(" ", "_")
    scene = stem.with_suffix(".json")
    scene.write_text(json.dumps(changed(base, changes)))
    command = [str(solver), "run", str(scene), "-o", str(stem) + ".h5", "--seed", str(seed),
               "--json"]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(command)}\nended with {done.returncode}: {done.stderr}")
    out = json.loads(done.stdout)
    row = {"group": group, "variant": name, "seed": seed, "commit": commit}
    for source in (out, out["counts"], out["solver"]):
        for key in COLUMNS:
            if key in source and key not in row:
                row[key] = source[key]
    return {key: "" if row[key] is None else row[key] for key in COLUMNS}


def number(row, key):
    return float(row[key]) if row[key] != "" else math.nan


def pick(rows, name, group=None):
    return {int(r["seed"]): r for r in rows
            if r["variant"] == name and (group is None or r["group"] == group)}


def summarise(rows):
    reference = pick(rows, REFERENCE)
    table = []
    for group, name, _, _ in VARIANTS:
        own = pick(rows, name, group)
        clogged = [r for r in own.values() if r["tc_s"] != ""]
        first = [number(r, "t1_s") for r in own.values() if r["t1_s"] != ""]
        paired = [number(r, "t1_s") - number(reference[s], "t1_s") for s, r in own.items()
                  if r["t1_s"] != "" and reference[s]["t1_s"] != ""]
        entry = {"group": group, "variant": name, "n": len(own), "n_t1": len(first),
                 "n_clogged": len(clogged)}
        for key, values in [
                ("t1_s", first), ("t1_minus_reference_s", paired),
                ("retained", [number(r, "retained") for r in own.values()]),
                ("critical_diameter_um",
                 [1e6 * number(r, "critical_diameter_m") for r in own.values()]),
                ("permeability_ratio", [number(r, "permeability_ratio") for r in own.values()]),
                ("cpu_s", [number(r, "cpu_seconds") for r in own.values()])]:
            entry[key], entry[key + "_ci"] = evidence.interval(values)
        table.append(entry)
    return table


def text(mean, half, spec):
    if math.isnan(mean):
        return "-"
    return format(mean, spec) + ("" if math.isnan(half) else " ± " + format(half, spec))


def markdown(table):
    lines = ["| option | value | seeds | with a first retention | clogged by 5 s | t_1 [s] | "
             "t_1 less the reference's [s] | retained | l_c at 5 s [um] | k ratio at 5 s | "
             "processor s |", "|" + "---|" * 11]
    for e in table:
        lines.append("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |".format(
            e["group"], e["variant"], e["n"], e["n_t1"], e["n_clogged"],
            text(e["t1_s"], e["t1_s_ci"], ".2f"),
            text(e["t1_minus_reference_s"], e["t1_minus_reference_s_ci"], ".3f"),
            text(e["retained"], e["retained_ci"], ".0f"),
            text(e["critical_diameter_um"], e["critical_diameter_um_ci"], ".1f"),
            text(e["permeability_ratio"], e["permeability_ratio_ci"], ".2f"),
            text(e["cpu_s"], e["cpu_s_ci"], ".1f")))
    return "\n".join(lines)


def draw(rows, output):
    names, blocks = [], []
    for i, (group, name, _, _) in enumerate(VARIANTS):
        own = pick(rows, name, group).values()
        label = "reference" if group == "reference" else f"{group} {name}"
        names.append(f"'{label}' {i}")
        for j, key in enumerate(["t1_s", "retained", "critical_diameter_m", "cpu_seconds"]):
            scale = 1e6 if key == "critical_diameter_m" else 1.0
            points = [f"{scale * number(r, key)} {i + 0.03 * (int(r['seed']) - 5.5)}"
                      for r in own if r[key] != ""]
            blocks.append(f"$d{j}_{i} << EOD\n" + "\n".join(points or ["NaN NaN"]) + "\nEOD")
    plots = []
    for j, label in enumerate(["t_1 [s]", "retained at 5 s", "l_c at 5 s [{/Symbol m}m]",
                               "processor seconds"]):
        curves = ", ".join(f"$d{j}_{i} using 1:2 with points pt 7 ps 0.8 lc {i + 1} notitle"
                           for i in range(len(VARIANTS)))
        blank = ", ".join(f"'' {i}" for i in range(len(VARIANTS)))
        ticks = f"set ytics ({', '.join(names) if j == 0 else blank})"
        log = "set logscale x" if j == 3 else "unset logscale x"
        plots.append(f"{ticks}\n{log}\nset xlabel '{label}'\nplot {curves}")
    evidence.gnuplot("\n".join(blocks) + f"""
set terminal pngcairo size 1500,620 font 'sans,11'
set output '{output / "effects.png"}'
set grid
set yrange [{len(VARIANTS) - 0.5}:-0.5]
set multiplot layout 1,4 margins 0.15,0.98,0.1,0.97 spacing 0.02
""" + "\n".join(plots) + "\n")


def table_of_seeds(rows):
    lines = ["| seed | t_1 [s] | t_c [s] | l_c at 5 s [um] | k ratio at 5 s | injected | "
             "retained | traversed | steps | flow solves | processor s |", "|" + "---|" * 11]
    for seed, r in sorted(pick(rows, REFERENCE).items()):
        lines.append(f"| {seed} | {number(r, 't1_s'):.4f} | {number(r, 'tc_s'):.4f} | "
                     f"{1e6 * number(r, 'critical_diameter_m'):.2f} | "
                     f"{number(r, 'permeability_ratio'):.4f} | {r['injected']} | "
                     f"{r['retained']} | {r['traversed']} | {float(r['steps']):.0f} | "
                     f"{float(r['flow_solves']):.0f} | {number(r, 'cpu_seconds'):.1f} |")
    return "\n".join(lines).replace("nan", "-")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    evidence.add_common_options(parser, "one_way")
    parser.add_argument("--workers", type=int, default=2, help="realisations at a time")
    parser.add_argument("--only", help="groups to run, separated by commas")
    options = parser.parse_args()
    origin = evidence.provenance(options.solver)
    options.output.mkdir(parents=True, exist_ok=True)
    commit = evidence.commit(options.solver)
    path = options.output / "realisations.csv"
    rows = list(csv.DictReader(path.open())) if path.exists() else []
    rows = [r for r in rows if r["commit"] == commit]
    have = {(r["group"], r["variant"], int(r["seed"])) for r in rows}
    wanted = options.only.split(",") if options.only else None
    with tempfile.TemporaryDirectory() as folder, \
            concurrent.futures.ThreadPoolExecutor(options.workers) as pool:
        tasks = [pool.submit(realise, options.solver, folder, group, name, changes, seed, commit)
                 for group, name, changes, seeds in VARIANTS for seed in seeds
                 if (group, name, seed) not in have and (wanted is None or group in wanted)]
        for done in concurrent.futures.as_completed(tasks):
            rows.append(done.result())
            evidence.write_rows(path, rows, COLUMNS)
    order = {(group, name): i for i, (group, name, _, _) in enumerate(VARIANTS)}
    rows.sort(key=lambda r: (order[r["group"], r["variant"]], int(r["seed"])))
    evidence.write_rows(path, rows, COLUMNS)
    table = summarise(rows)
    evidence.write_csv(options.output / "table.csv",
                       [(key, "" if isinstance(table[0][key], str) else ".6g")
                        for key in table[0]], table)
    draw(rows, options.output)
    (options.output / "generated.md").write_text("\n".join(
        ["# Tables of the tier one_way", "",
         "Written by `scripts/one_way_effects.py`; README.md says what they mean.", "",
         *origin, f"- {options.workers} realisations at a time", "",
         "## The reference scene, seeds 1 to 10", "", table_of_seeds(rows), "",
         "## One option at a time", "",
         "Means over the seeds with 95 % t-intervals (those of t_1 over the seeds",
         "that had a first retention within 5 s, so the paired difference is the fair",
         "comparison; permeability and l_c are not normally distributed).", "",
         markdown(table), ""]))
    overlaps = sum(float(r["overlaps"]) for r in rows)
    print(f"{len(rows)} realisations, {overlaps:.0f} overlaps, tables in {options.output}")


if __name__ == "__main__":
    main()
