"""What gap the grid takes a narrow one for, MODEL (Q2): measured, fitted, and how well it then holds.

Moves a sphere towards a plane wall (which lies on the grid), two spheres towards each other (at three
places between the grid's planes), and turns one beside a wall, which makes it slide, with poreclog-solve measure and "lubrication":
"resolved_only", and finds the gap at which the exact resistance (Brenner 1961; MODEL R2) is the one
measured.  Fits seen = gap + w exp(-gap/range), in cells, over all resolutions: for the forces (range 1), the
torques, and the coupling of both (with the torques' range); --write puts the numbers, rounded to a hundredth, into
solver/src/particles/unresolved_gap_coefficients.h.  Writes results/evidence/lubrication/{gaps.csv,
lubrication.png,generated.md}: the error of the corrected resistance per resolution.
Needs a release build and gnuplot.  Usage: python3 scripts/calibrate_lubrication.py [--help]
"""
import argparse
import csv
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

import evidence

SERIES = evidence.ROOT / "solver/src/physics/wall_resistance_coefficients.h"
HEADER = evidence.ROOT / "solver/src/particles/unresolved_gap_coefficients.h"
CELLS = (4, 5.5, 8, 10, 12, 16)  # per diameter
GAPS = (0.06, 0.12, 0.25, 0.5, 1.0, 1.5, 2.5)  # cells
NARROW = {"force": 0.13, "turning": 0.3, "coupling": 0.3}  # cells: gaps that are fitted
WIDE = 4.0  # cells, for the far walls' part
EXTENT = 8  # radii, of the box
PLACES = (0.0, 0.29, 0.63)  # of a cell
SPEED = 1e-6  # [m/s], radius 1 um, viscosity 1 mPa s
CASES = ("wall", "pair", "turning", "coupling")
NOT_CONVERGED = 3  # exit code
COLUMNS = [("case", ""), ("cells", "g"), ("place", "g"), ("gap_cells", "g"), ("force", ".6g"),
           ("seen_cells", ".5f"), ("exact", ".6g"), ("resolved_error", ".5f"),
           ("corrected_error", ".5f")]


def squeezed(gap, mirror):
    """Force over 6 pi mu a U on a sphere that approaches a wall (Brenner 1961, eq. 2.19) or a
    plane of symmetry, behind which its image approaches too (eq. 3.13); gap in radii."""
    alpha = math.acosh(1 + gap)
    total, n = 0.0, 1
    while n * alpha < 40:
        b = (n + 0.5) * alpha
        if mirror:
            ratio = (4 * math.cosh(b)**2 + (2 * n + 1)**2 * math.sinh(alpha)**2) / (
                2 * math.sinh(2 * b) - (2 * n + 1) * math.sinh(2 * alpha))
        else:
            ratio = (2 * math.sinh(2 * b) + (2 * n + 1) * math.sinh(2 * alpha)) / (
                4 * math.sinh(b)**2 - (2 * n + 1)**2 * math.sinh(alpha)**2)
        total += n * (n + 1) / ((2 * n - 1) * (2 * n + 3)) * (ratio - 1)
        n += 1
    return 4 / 3 * math.sinh(alpha) * total


def coefficients(name):
    text = SERIES.read_text()
    values = text[text.index(name):].split("=", 1)[1].split(";")[0]
    return [float(v) for v in re.findall(r"-?\d+\.?\d*(?:e-?\d+)?", values)]


LOGS = [coefficients(f"kWallLog{i}") for i in range(3)]
POLYNOMIAL = coefficients("kWallPolynomial")


def wall_function(index, gap):
    """(R2): f_t 1, t_t 2 (over x^4), t_r 3."""
    x = 1 / (1 + gap)
    y, t = gap * x, 2 * x - 1
    total = sum(POLYNOMIAL[8 * k + index] * t**k for k in range(13))
    return total - math.log(y) * sum(LOGS[k][index] * y**k for k in range(3))


def turned(gap):
    """Torque over 8 pi mu a^3 w on a sphere beside a wall that is free to slide."""
    slide, couple, turn = (wall_function(i, gap) for i in (1, 2, 3))
    couple *= (1 + gap)**-4
    return turn - 4 / 3 * couple**2 / slide


def exact(case, gap):
    """`gap` between the surfaces [radii]."""
    if case == "turning":
        return turned(gap)
    if case == "coupling":
        return wall_function(2, gap) * (1 + gap)**-4
    return squeezed(gap, False) if case == "wall" else squeezed(gap / 2, True)


def gap_for(case, force):
    """The gap [radii] at which the exact resistance is that."""
    low, high = 1e-6, 20.0
    for _ in range(60):
        middle = math.sqrt(low * high)
        low, high = (middle, high) if exact(case, middle) > force else (low, middle)
    return middle


def measured(solver, folder, case, cells, gap, place):
    """Resistance in Stokes' units, None if the solve does not converge; gap in radii.  The box:
    whole cells of the width asked."""
    n = round(EXTENT * cells / 2)
    cell = 2 / cells
    edge = n * cell
    middle = edge / 2 + place * cell

    def body(z, speed):
        return {"center": [f"{middle:.9f} um", f"{middle:.9f} um", f"{z:.9f} um"],
                "diameter": "2 um", "velocity": ["0 um/s", "0 um/s", f"{speed} um/s"]}
    if case == "wall":
        bodies = [body(1 + gap, -1)]
    elif case in ("turning", "coupling"):
        bodies = [body(1 + gap, 0)]
        del bodies[0]["velocity"]
        bodies[0]["torque"] = ["0 N m", f"{8 * math.pi * 1e-3 * 1e-18} N m", "0 N m"]
    else:
        bodies = [body(middle - 1 - gap / 2, 1), body(middle + 1 + gap / 2, -1)]
    faces = {f"{axis}{side}": "wall" for axis in "xyz" for side in "-+"}
    scene = {"geometry": {"box": [f"{edge:.9f} um"] * 3, "faces": faces, "bodies": bodies},
             "fluid": {"viscosity": "1 mPa s"},
             "fidelity": {"tier": "quasi_steady", "lubrication": "resolved_only",
                          "tolerance": 1e-6}}
    path = pathlib.Path(folder) / "gap.json"
    path.write_text(json.dumps(scene))
    command = [str(solver), "measure", str(path), "--cells", *[str(n)] * 3]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode == NOT_CONVERGED:
        return None
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)}\nended with {done.returncode}: {done.stderr.strip()}")
    found = json.loads(done.stdout)["bodies"][0]
    if case == "turning":
        return 1 / found["angular_velocity_rad_s"][1]
    if case == "coupling":  # no force: f_t U = 4/3 t_t a w, f_t as the grid has it
        sliding = wall_function(1, seen(in_use(), "wall", gap / cell) * cell)
        return 0.75 * sliding * (found["velocity_m_s"][0] * 1e6
                                 / found["angular_velocity_rad_s"][1])
    return abs(found["force_N"][2]) / (6 * math.pi * 1e-3 * 1e-6 * SPEED)


def run(solver):
    rows, failed = [], []
    with tempfile.TemporaryDirectory() as folder:
        for cells in CELLS:
            for case in CASES:
                for place in (PLACES if case == "pair" else PLACES[1:2]):
                    cell = 2 / cells
                    # The far walls: what the force at a wide gap, where the grid sees all, is more.
                    wide = WIDE * cell
                    # The coupling is none of theirs, but small and the grid's error there.
                    far = 0 if case == "coupling" else (
                        measured(solver, folder, case, cells, wide, place) - exact(case, wide))
                    for gap in GAPS:
                        force = measured(solver, folder, case, cells, gap * cell, place)
                        if force is None:
                            failed.append((case, cells, place, gap))
                            continue
                        force -= far
                        rows.append({"case": case, "cells": cells, "place": place,
                                     "gap_cells": gap, "force": force,
                                     "seen_cells": gap_for(case, force) / cell,
                                     "exact": exact(case, gap * cell)})
            print(f"{cells} cells per diameter done", flush=True)
    return rows, failed


def read_rows(path):
    """What an earlier run measured; what it made of it is made again."""
    with open(path) as file:
        return [{k: v if k == "case" else float(v) for k, v in row.items()}
                for row in csv.DictReader(file)]


def fit(rows, reach):
    """w by least squares of the gaps seen, and what is left."""
    shape = [math.exp(-r["gap_cells"] / reach) for r in rows]
    wider = [r["seen_cells"] - r["gap_cells"] for r in rows]
    w = sum(a * b for a, b in zip(shape, wider)) / sum(a * a for a in shape)
    return w, sum((b - w * a)**2 for a, b in zip(shape, wider))


def fits(rows):
    """(w, range) of forces and of torques, from gaps so narrow that the correction is large and the
    grid's own error, of second order, does not hide it; without the coarsest grid."""
    fine = [r for r in rows if r["cells"] > min(CELLS)]
    forces = [r for r in fine if r["case"] in ("wall", "pair") and r["gap_cells"] < NARROW["force"]]
    turns, couplings = ([r for r in fine if r["case"] == case and r["gap_cells"] < NARROW[case]]
                        for case in ("turning", "coupling"))
    reach = min((0.01 * k for k in range(5, 101)), key=lambda d: fit(turns, d)[1])
    # The coupling's range is that of the torques: where it reached further than they do, the
    # correction as a whole would not be positive definite, and could feed motion.
    return {"force": (fit(forces, 1.0)[0], 1.0), "turning": (fit(turns, reach)[0], reach),
            "coupling": (fit(couplings, reach)[0], reach)}


def seen(used, case, gap):
    w, reach = used.get(case, used["force"])
    return gap + w * math.exp(-gap / reach)


def judge(rows, used):
    for r in rows:
        cell = 2 / r["cells"]
        corrected = r["force"] + r["exact"] - exact(
            r["case"], seen(used, r["case"], r["gap_cells"]) * cell)
        # The coupling goes through zero: over what it is compared with, the torque's part.
        scale = exact("turning", r["gap_cells"] * cell) if r["case"] == "coupling" else r["exact"]
        r["resolved_error"] = (r["force"] - r["exact"]) / scale
        r["corrected_error"] = (corrected - r["exact"]) / scale


def write_header(fitted):
    (force, _), (torque, reach), (couple, _) = (
        fitted[k] for k in ("force", "turning", "coupling"))
    HEADER.write_text(f"""// Written by scripts/calibrate_lubrication.py from measured forces; not by hand.
#pragma once

namespace colloid {{

/// By how much the grid takes a gap that closes for wider [cells]: for forces, for
/// torques, which it resolves better, and for the coupling of both, which it resolves
/// worse.
constexpr double kGapWidening = {force:.2f};
constexpr double kGapWideningTurning = {torque:.2f};
constexpr double kGapWideningCoupling = {couple:.2f};

/// Gap by which the widening falls to 1/e [cells]; the coupling has that of torques.
constexpr double kGapRange = 1.0;
constexpr double kGapRangeTurning = {reach:.2f};

}}  // namespace colloid
""")


def in_use():
    text = HEADER.read_text()
    value = {m[0]: float(m[1]) for m in re.findall(r"(kGap\w+) = ([0-9.]+);", text)}
    return {"force": (value["kGapWidening"], value["kGapRange"]),
            "turning": (value["kGapWideningTurning"], value["kGapRangeTurning"]),
            "coupling": (value["kGapWideningCoupling"], value["kGapRangeTurning"])}


def report(rows, failed, fitted, used, folder, lines):
    out = ["# Lubrication below the grid: tables", "",
           "Written by `scripts/calibrate_lubrication.py`; README.md says what they mean.", "",
           *lines, "", "| of | w, fitted | range [cells], fitted | w in use | range in use |",
           "|---|---|---|---|---|",
           *[f"| {k} | {fitted[k][0]:.3f} | {fitted[k][1]:.2f} | {used[k][0]:.2f} | "
             f"{used[k][1]:.2f} |" for k in used], "",
           f"Not converged: {len(failed)}" + "".join(
               f"; {case} at {cells:g} cells per diameter, gap {gap:g} cells"
               for case, cells, _, gap in failed) + ".", "",
           "Largest error of the resistance over all gaps and places [%], without and with what the",
           "grid leaves out:", "",
           "| cells per diameter | case | narrowest gap [a] | resolved only | with lubrication | "
           "with, gaps from a quarter of a cell |", "|---|---|---|---|---|---|"]
    for cells in CELLS:
        for case in CASES:
            mine = [r for r in rows if (r["cells"], r["case"]) == (cells, case)]
            wide = [r for r in mine if r["gap_cells"] >= 0.25]

            def worst(key, some):
                return 100 * max((r[key] for r in some), key=abs)
            out.append(f"| {cells:g} | {case} | {min(GAPS) * 2 / cells:.3f} | "
                       f"{worst('resolved_error', mine):+.1f} | "
                       f"{worst('corrected_error', mine):+.1f} | "
                       f"{worst('corrected_error', wide):+.1f} |")
    (folder / "generated.md").write_text("\n".join(out) + "\n")
    print("\n".join(out))


def draw(rows, used, folder):
    blocks, forces, torques, couplings, errors = [], [], [], [], []
    cases = {"force": ("wall", "pair"), "turning": ("turning",), "coupling": ("coupling",)}
    for i, cells in enumerate(CELLS):
        for word, plots in (("force", forces), ("turning", torques), ("coupling", couplings)):
            points = "\n".join(f"{r['gap_cells']} {r['seen_cells'] - r['gap_cells']} "
                               f"{100 * r['corrected_error']}" for r in rows
                               if r["cells"] == cells and r["case"] in cases[word])
            blocks.append(f"${word}{i} << EOD\n{points}\nEOD")
            style = f"with points lc {i + 1} pt { {'force': 7, 'turning': 2, 'coupling': 4}[word]}"
            plots.append(f"${word}{i} using 1:2 {style} title '{cells:g} cells per diameter'")
            errors.append(f"${word}{i} using 1:3 {style} notitle")
    curve = {k: f"{w}*exp(-x/{reach}) lw 2 lc 'black' title 'used'" for k, (w, reach) in used.items()}
    evidence.gnuplot("\n".join(blocks) + f"""
set terminal pngcairo size 1900,480 font 'sans,11' noenhanced
set output '{folder}/lubrication.png'
set multiplot layout 1,4; set grid; set logscale x; set xlabel 'gap [cells]'; set xrange [0.05:3]
set ylabel 'gap that the grid sees, less the gap [cells]'; set title 'forces'
plot {curve["force"]}, {", ".join(forces)}
set title 'torques'; plot {curve["turning"]}, {", ".join(torques)}
set title 'coupling'; plot {curve["coupling"]}, {", ".join(couplings)}
set ylabel 'error of the resistance [%]'; set title 'with lubrication (crosses: torques, squares: coupling)'; set key off
plot {", ".join(errors)}
unset multiplot
""")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    evidence.add_common_options(parser, "lubrication")
    parser.add_argument("--write", action="store_true", help="write the numbers into the source")
    parser.add_argument("--measured", type=pathlib.Path,
                        help="gaps.csv of an earlier run, instead of measuring")
    options = parser.parse_args()
    if abs(squeezed(0.5, True) - 2.03865) > 1e-5 or abs(squeezed(0.5431, False) - 3.036) > 1e-3:
        sys.exit("the exact series are wrong")
    lines = evidence.provenance(options.solver)
    rows, failed = (read_rows(options.measured), []) if options.measured else run(options.solver)
    fitted = fits(rows)
    if options.write:
        write_header(fitted)
    used = in_use()
    judge(rows, used)
    options.output.mkdir(parents=True, exist_ok=True)
    evidence.write_csv(options.output / "gaps.csv", COLUMNS, rows)
    draw(rows, used, options.output)
    report(rows, failed, fitted, used, options.output, lines)


if __name__ == "__main__":
    main()
