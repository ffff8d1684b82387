"""From where in the inlet a single colloid is captured in the clean throat, by tier.

Starts one colloid at a time below the inlet of the reference throat and bisects along rays from
the corner of the inlet for the edge of the captured part.  The throat has the symmetry of a
square, so an eighth of the inlet is enough.  The inlet's speed is uniform: the captured part
of the area is the captured part of the flux.  Writes
results/evidence/capture_map/{rays.csv,map.png,generated.md}.  Cases that rays.csv already has, made
by the same commit, are not run again.  Needs a release build and gnuplot.
Usage: python3 scripts/capture_map.py [--help]
"""
import argparse
import concurrent.futures
import csv
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile

import evidence

DIAMETER = 13.3  # of the colloid [um]
WIDTH, HEIGHT = 96.6, 144.9  # of the throat's box [um]
ROOM = 0.02  # kept from the walls and the inlet [um], more than any gap of contact
REACH = 25.0  # longest ray [um]
# Gauss-Legendre on an eighth of the circle.
NODES = [(0.046910077, 0.118463443), (0.230765345, 0.239314335), (0.5, 0.284444444),
         (0.769234655, 0.239314335), (0.953089923, 0.118463443)]
HALF = WIDTH / 2 - DIAMETER / 2 - ROOM  # of the part of the inlet that centres can reach
# Name, key "fidelity" of the scene.
CASES = [
    ("one_way", {"tier": "one_way"}),
    ("one_way, 8 cells", {"tier": "one_way", "cells_per_colloid": 8}),
    ("quasi_steady", {"tier": "quasi_steady"}),
    ("quasi_steady, 8 cells", {"tier": "quasi_steady", "cells_per_colloid": 8}),
    ("one_way, gap 0.1 um", {"tier": "one_way", "capture_gap": "100 nm"}),
    ("quasi_steady, gap 0.1 um", {"tier": "quasi_steady", "capture_gap": "100 nm"}),
]
COLUMNS = ["case", "angle_rad", "weight", "edge_um", "step_um", "runs", "cpu_seconds", "commit"]


def start(solver, fidelity, x, y, height):
    """Whether a colloid released at x, y [um] from the corner is captured; processor time."""
    base = json.loads((evidence.ROOT / "campaigns/throat.scene.json").read_text())
    far = WIDTH / 2 + HALF
    centre = [f"{far - x:.6f} um", f"{far - y:.6f} um", f"{height:.6f} um"]
    base["geometry"]["bodies"] = [{"center": centre, "diameter": f"{DIAMETER} um"}]
    base["colloids"]["volume_fraction"] = 0
    base["duration"] = "20 s"
    base["fidelity"] = fidelity
    with tempfile.TemporaryDirectory() as folder:
        scene = pathlib.Path(folder) / "scene.json"
        scene.write_text(json.dumps(base))
        done = subprocess.run([solver, "run", scene, "-o", scene.with_suffix(".h5"), "--json"],
                              capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{centre} {fidelity}: {done.stderr.strip()}")
    result = json.loads(done.stdout)
    captured = result["t1_s"] is not None
    assert captured or result["counts"]["traversed"] == 1, "still on its way"
    return captured, result["solver"]["cpu_seconds"]


def edge(solver, fidelity, angle, steps, height):
    """Where the ray leaves the captured part, by bisection [um]."""
    inside, outside, seconds = 0.0, REACH, 0.0
    for _ in range(steps):
        middle = 0.5 * (inside + outside)
        captured, cost = start(solver, fidelity, middle * math.cos(angle),
                               middle * math.sin(angle), height)
        seconds += cost
        inside, outside = (middle, outside) if captured else (inside, middle)
    return 0.5 * (inside + outside), outside - inside, seconds


def fraction(rows):
    """Captured part of the flux and its uncertainty by the length of the last step."""
    area = sum(r["weight"] * r["edge_um"]**2 for r in rows)  # twice a half
    error = sum(r["weight"] * 2 * r["edge_um"] * 0.5 * r["step_um"] for r in rows)
    return area / HALF**2, error / HALF**2


def read(path, commit):
    if not path.exists():
        return []
    with open(path) as file:
        rows = list(csv.DictReader(file))
    numbers = [c for c in COLUMNS if c not in ("case", "commit")]
    return [{**r, **{c: float(r[c]) for c in numbers}} for r in rows if r["commit"] == commit]


def draw(rows, folder):
    """The captured corner of the inlet, one curve a case."""
    names = [name for name, _ in CASES if any(r["case"] == name for r in rows)]
    blocks = []
    for name in names:
        mine = sorted((r for r in rows if r["case"] == name), key=lambda r: r["angle_rad"])
        line = [(r["angle_rad"], r["edge_um"]) for r in mine]
        line += [(math.pi / 2 - angle, length) for angle, length in reversed(line)]
        blocks.append("\n".join(f"{length * math.cos(a):g} {length * math.sin(a):g}"
                                for a, length in line))
    data = folder / "map.dat"
    data.write_text("\n\n\n".join(blocks) + "\n")
    plots = ", ".join(f"'{data}' index {i} with linespoints title '{name}'"
                      for i, name in enumerate(names))
    script = (f"set terminal pngcairo size 900,800 noenhanced; set output '{folder}/map.png'\n"
              "set size ratio -1; set key top right\n"
              "set xlabel 'from the corner of the reachable inlet [um]'\n"
              "set ylabel 'from the corner [um]'; set xrange [0:20]; set yrange [0:20]\n"
              "set title 'Released nearer to the corner than the curve: captured'\n"
              f"plot {plots}\n")
    subprocess.run(["gnuplot"], input=script, text=True, check=True)
    data.unlink()


def report(rows, folder, lines):
    out = ["| case | captured part of the flux | +- | runs | processor s |", "|---|---|---|---|---|"]
    for name, _ in CASES:
        mine = [r for r in rows if r["case"] == name]
        if len(mine) == len(NODES):
            part, error = fraction(mine)
            out.append(f"| {name} | {part:.4f} | {error:.4f} | {sum(r['runs'] for r in mine):.0f} "
                       f"| {sum(r['cpu_seconds'] for r in mine):.0f} |")
    (folder / "generated.md").write_text("\n".join(out + [""] + lines) + "\n")
    print("\n".join(out))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    evidence.add_common_options(parser, "capture_map")
    parser.add_argument("--steps", type=int, default=9, help="bisections a ray (default 9)")
    parser.add_argument("--cases", nargs="*", default=[name for name, _ in CASES],
                        help="names of cases (default: all)")
    parser.add_argument("--height", type=float, default=HEIGHT - DIAMETER / 2 - ROOM,
                        help="of the release [um] (default: touching the inlet); with another "
                             "one give --output too, and read the edges, not the fraction")
    arguments = parser.parse_args()
    lines = evidence.provenance(arguments.solver)
    commit = lines[1]
    folder = arguments.output
    folder.mkdir(parents=True, exist_ok=True)
    rows = read(folder / "rays.csv", commit)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for name, fidelity in CASES:
            if name not in arguments.cases or any(r["case"] == name for r in rows):
                continue
            angles = [0.25 * math.pi * node for node, _ in NODES]
            found = pool.map(lambda a: edge(arguments.solver, fidelity, a, arguments.steps,
                                             arguments.height),
                             angles)
            for angle, (_, weight), (length, step, seconds) in zip(angles, NODES, found):
                rows.append({"case": name, "angle_rad": angle,
                             "weight": 0.25 * math.pi * weight, "edge_um": length,
                             "step_um": step, "runs": arguments.steps,
                             "cpu_seconds": seconds, "commit": commit})
            evidence.write_csv(folder / "rays.csv", [(c, "") for c in COLUMNS], rows)
            report(rows, folder, lines)
    draw(rows, folder)


if __name__ == "__main__":
    main()
