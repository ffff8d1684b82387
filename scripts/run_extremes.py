"""Run `poreclog-solve run` at extreme values of what concerns colloids.

Every case must survive (exit code 0, colloids conserved, no overlap) or be refused with a
message (2); a run that becomes unstable says so (3).  A crash, exit code 4, lost colloids,
overlaps or more than --timeout are failures: the script then ends with 1.  Writes table.csv
(one row per case) and README.md.

    python3 scripts/run_extremes.py [--tier one_way|quasi_steady|transient] [--only WORD]
                                    [--solver build/release/solver/poreclog-solve]
                                    [--output results/evidence/extremes_run]

The tier quasi_steady gets a fifth of the time of each case and the tier transient a tenth, at
most 0.1 s, with a colloid on its way from the start; their tables go to
results/evidence/extremes_quasi_steady and extremes_transient.
"""
import argparse
import itertools
import json
import math
import subprocess
import sys
import tempfile
import time

import h5py
import numpy

import evidence
from extremes import CENTRE, RADIUS, THROAT, metres, throat

COARSE = {"fidelity__cells_per_colloid": 3, "duration": "1 s"}
# Of the simulated time of one_way: colloids still come from the inlet to the grains.
SHORTER = {"one_way": 1.0, "quasi_steady": 0.2, "transient": 0.1}
LONGEST = {"one_way": math.inf, "quasi_steady": math.inf, "transient": 0.1}  # [s]
PAPER = "operating point of the paper"
COLOURS = {"survived": "#2a7f62", "refused": "#808080", "unstable": "#b03030"}
PROGRAM = {"transient": "poreclog-solve-transient"}


def cases():
    """(name, value, scene); all coarse and short, but dense enough to meet grains."""
    def case(name, value, **changes):
        yield name, str(value), throat(**{**COARSE, "colloids__volume_fraction": 0.02,
                                          **changes})
    for ratio in [0.5, 1.0, 1.05, 2.0, 8.0]:
        yield from case("density ratio", ratio, colloids__density=f"{1000 * ratio:g} kg/m^3")
    for gap in [1e-1, 1e-2, 1e-3, 1e-4]:
        yield from case("capture gap over a", gap,
                        fidelity__capture_gap=f"{gap * 6.65e-6:.9g} m")
    for strength in ["0.1 mM", "1 mM", "10 mM", "100 mM", "1 M", "5 M"]:
        yield from case("ionic strength", strength, surface__ionic_strength=strength)
    for strength in ["0.1 mM", "5 M"]:
        yield from case("ionic strength, breakable bonds", strength,
                        surface__ionic_strength=strength, bonds="breakable")
    for speed, duration in [(1e-6, "500 s"), (1e-5, "50 s"), (1e-4, "5 s"), (1e-3, "0.5 s"),
                            (1e-2, "0.05 s"), (1e-1, "0.005 s")]:
        yield from case("inlet velocity [m/s]", speed, drive__inlet_velocity=f"{speed} m/s",
                        duration=duration)
    for cells in [2, 3, 5.5, 11]:
        yield from case("cells per colloid", cells, fidelity__cells_per_colloid=cells)
    yield from case("cells per colloid", 40, fidelity__cells_per_colloid=40,
                    duration="0.05 s")
    for factor in [0.99, 1.01]:
        yield from case("colloid over throat", factor,
                        colloids__diameter=f"{factor * THROAT:.9g} m",
                        colloids__volume_fraction=0.1, fidelity__cells_per_colloid=12)
    for modulus in ["1e5 Pa", "3e9 Pa"]:
        yield from case("Young's modulus", modulus, colloids__young_modulus=modulus)
    for hindrance in ["none", "wall", "wall_and_pair"]:
        for gap in ["1 nm", "1 um"]:
            yield from case("hindrance, capture gap", f"{hindrance}, {gap}",
                            fidelity__hindrance=hindrance, fidelity__capture_gap=gap)
    for walls in ["inert", "adhesive"]:
        yield from case("side walls", walls, walls=walls, colloids__volume_fraction=0.1)
    for drive in [{"inlet_velocity": "0.5 mm/s"}, {"pressure_drop": "2 Pa"}]:
        # So sticky and dense that the pore is filled.
        yield from case("filled under " + next(iter(drive)), "1 s", drive=drive,
                        colloids__volume_fraction=0.2, fidelity__capture_gap="1 um",
                        duration="3 s")
    # The throat that much smaller, so that the grid stays the same.
    for diameter, collector, height, duration in [("1 um", "7.26 um", "10.9 um", "2 s"),
                                                  ("100 nm", "726 nm", "1.09 um", "0.2 s")]:
        yield from case("Brownian colloids of diameter", diameter,
                        geometry__collector_diameter=collector, geometry__height=height,
                        colloids__diameter=diameter, colloids__volume_fraction=0.005,
                        drive__inlet_velocity="20 um/s", duration=duration)
    yield from case("Hamaker constant", "0 J", surface__hamaker="0 J")
    yield from case("aggregates", "off", aggregates=False, colloids__volume_fraction=0.1)
    yield from case("volume fraction", 0.5, colloids__volume_fraction=0.5)
    yield from case("volume fraction", 0, colloids__volume_fraction=0)


def body(x, y, z, diameter):
    return {"center": [metres(x), metres(y), metres(z)], "diameter": metres(diameter)}


def transient_cases():
    """What the tier transient alone has to be asked."""
    yield PAPER, "", throat(**COARSE)
    d = 2.0 * RADIUS
    apart = 0.5 * (d + 5e-9)  # within the gap of contact
    square = [body(CENTRE + sx * apart, CENTRE + sy * apart, CENTRE, d)
              for sx in (-1, 1) for sy in (-1, 1)]
    # Along the diagonal from grain to grain, as in extremes.py.
    gap = 5e-9
    small = (THROAT - 5 * gap) / 4
    places = [CENTRE + (n - 1.5) * (small + gap) / math.sqrt(2) for n in range(4)]
    chain = [body(x, x, CENTRE, small) for x in places]
    for drive in [{"inlet_velocity": "0.5 mm/s"}, {"pressure_drop": "1 Pa"}]:
        yield ("touching square of four in the throat", next(iter(drive)),
               throat(**{**COARSE, "geometry__bodies": square, "drive": drive}))
        yield ("touching cluster of four across the throat", next(iter(drive)),
               throat(**{**COARSE, "geometry__bodies": chain, "drive": drive,
                         "colloids__diameter": metres(small)}))
    # The throat would have ten million cells.
    duct = throat(fidelity__cells_per_colloid=40, duration="0.02 s",
                  geometry={"box": [metres(x) for x in (2 * d, 2 * d, 3 * d)], "faces": {
                      **{f"{axis}{side}": "wall" for axis in "xy" for side in "-+"},
                      "z-": "outlet", "z+": "inlet"},
                      "bodies": [body(d, 0.9 * d, 1.5 * d, d)]})
    yield "cells per colloid", "40, in a duct of two diameters", duct


def cases_of(tier):
    if tier != "transient":
        return cases()
    # 40 cells: see there.  The finest grids of the others are twice as fine here.
    return itertools.chain(
        (case for case in cases() if case[1] not in ("11", "40")), transient_cases())


def with_colloid(scene):
    """A colloid beside the axis, above the throat."""
    if "bodies" not in scene["geometry"] and "collector_diameter" in scene["geometry"]:
        size = float(scene["geometry"]["collector_diameter"].split()[0]) / 96.6
        unit = scene["geometry"]["collector_diameter"].split()[1]
        scene["geometry"]["bodies"] = [
            {"center": [f"{size * x:g} {unit}" for x in (49.0, 48.0, 110.0)],
             "diameter": scene["colloids"]["diameter"]}]


def of_tier(scene, tier):
    """The same case for that tier."""
    scene = json.loads(json.dumps(scene))
    scene.setdefault("fidelity", {})["tier"] = tier
    if tier != "one_way":
        if scene["fidelity"].pop("hindrance", None) == "none":
            scene["fidelity"]["lubrication"] = "resolved_only"
        value, unit = scene["duration"].split()
        scene["duration"] = f"{min(float(value) * SHORTER[tier], LONGEST[tier]):g} {unit}"
    if tier == "transient":
        scene["fidelity"]["cells_per_colloid"] /= 2  # that of the base grid
        with_colloid(scene)
    return scene


def deepest_overlap(path):
    """Of colloids of the last frame with each other, over their diameter."""
    with h5py.File(path) as file:
        x = file["particles/colloids/position/value"][-1]
        d = file["particles/colloids/diameter/value"][-1]
    there = numpy.isfinite(x[:, 2])
    pairs = itertools.combinations(zip(x[there], d[there]), 2)
    return max((1.0 - 2.0 * float(numpy.linalg.norm(a - b)) / (da + db)
                for (a, da), (b, db) in pairs), default=0.0)


def verdict(done, timeout, result):
    """(outcome, note); an outcome in capitals is a failure."""
    if done is None:
        return "TOO SLOW", f"more than {timeout:g} s"
    message = done.stderr.strip().splitlines()[-1] if done.stderr.strip() else ""
    if done.returncode == 2:
        return "refused", message
    if done.returncode == 3:
        return "unstable", message
    if done.returncode != 0:
        return f"EXIT {done.returncode}", message
    out = json.loads(done.stdout)
    counts = out["counts"]
    if counts["injected"] != sum(counts[k] for k in ["mobile", "retained", "traversed",
                                                     "delayed"]):
        return "LOST COLLOIDS", str(counts)
    # Soft spheres of the tier transient: a hundredth of the diameter is the bound.
    if "overlaps" not in out["solver"]:
        deepest = deepest_overlap(result)
        if deepest > 0.01:
            return "OVERLAP", f"deepest {deepest:.2g} diameters"
    elif out["solver"]["overlaps"] > 0:
        return "OVERLAP", f"{out['solver']['overlaps']:.0f} overlaps, deepest " \
                          f"{out['solver']['deepest_overlap_m']:.2g} m"
    return "survived", (f"{counts['injected']} injected, {counts['retained']} retained, "
                        f"{counts['traversed']} traversed, {out['solver']['steps']:.0f} steps")


def draw(rows, path):
    """Outcome and elapsed time of each case."""
    blocks, plots = [], []
    labels = ", ".join(f'"{r["case"]} {r["value"]}" {-n}' for n, r in enumerate(rows))
    for outcome, colour in COLOURS.items():
        points = [f"{r['seconds']} {-n}" for n, r in enumerate(rows) if r["outcome"] == outcome]
        if points:
            blocks.append(f"${outcome} << EOD\n" + "\n".join(points) + "\nEOD\n")
            plots.append(f"${outcome} using 1:2 with points pt 7 lc rgb '{colour}' "
                         f"title '{outcome}'")
    paper = [r["seconds"] for r in rows if r["case"] == PAPER]
    line = f"set arrow from {paper[0]}, graph 0 to {paper[0]}, graph 1 nohead dt 2" if paper else ""
    evidence.gnuplot(f"""
set terminal pngcairo size 900,{14 * len(rows) + 120} font 'Liberation Sans,9'
set output '{path}'
{''.join(blocks)}
set logscale x
set xlabel 'elapsed time [s]; dashed: the operating point of the paper'
set yrange [{-len(rows)}:1]
set ytics ({labels})
set grid lc rgb '#e0e0e0'
set key above
{line}
plot {', '.join(plots)}
""")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    evidence.add_common_options(parser, "extremes_run")
    parser.add_argument("--tier", choices=sorted(SHORTER), default="one_way")
    parser.add_argument("--timeout", type=float, default=300.0, help="of a case [s]")
    parser.add_argument("--only", default="", help="cases whose name has this word")
    options = parser.parse_args()
    if options.tier != "one_way" and options.output == parser.get_default("output"):
        options.output = options.output.with_name(f"extremes_{options.tier}")
    program = PROGRAM.get(options.tier, "poreclog-solve")
    options.solver = options.solver.with_name(program)
    origin = evidence.provenance(options.solver)
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for name, value, scene in cases_of(options.tier):
            if options.only not in name:
                continue
            path = folder + "/scene.json"
            with open(path, "w") as file:
                json.dump(of_tier(scene, options.tier), file)
            start = time.monotonic()
            try:
                done = subprocess.run(
                    [str(options.solver), "run", path, "-o", folder + "/r.h5", "--json"],
                    capture_output=True, text=True, timeout=options.timeout)
            except subprocess.TimeoutExpired:
                done = None
            seconds = time.monotonic() - start
            outcome, note = verdict(done, options.timeout, folder + "/r.h5")
            note = note.replace(folder, "...")
            rows.append({"case": name, "value": value, "outcome": outcome,
                         "seconds": f"{seconds:.1f}", "note": note})
            print(f"{outcome:10} {name} {value}: {note} ({seconds:.1f} s)", flush=True)
    failures = [r for r in rows if r["outcome"].isupper() or r["outcome"].startswith("EXIT")]
    if not options.only:
        options.output.mkdir(parents=True, exist_ok=True)
        evidence.write_rows(options.output / "table.csv", rows)
        lines = ["# Extremes of what concerns colloids", "",
                 f"`{program} run`, tier {options.tier}, on the reference throat (coarse grid,",
                 f"{SHORTER[options.tier]:g} s unless said), one value changed at a time.",
                 "Survived: finished, colloids conserved, none overlapping.", "", *origin, "",
                 f"{len(rows)} cases, {len(failures)} failures.", "",
                 "![outcome and time of each case](extremes.png)", "",
                 "| case | value | outcome | s | |", "|---|---|---|---|---|"]
        draw(rows, options.output / "extremes.png")
        lines += ["| {case} | {value} | {outcome} | {seconds} | {note} |".format(**r)
                  for r in rows]
        (options.output / "README.md").write_text("\n".join(lines) + "\n")
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
