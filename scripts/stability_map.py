"""Where the coupling of fluid and colloid is stable: step against density ratio, explicit and
implicit.

Writes results/evidence/stability/{map.csv,map.png,README.md} with the program coupling_map
(tests/stability), a few minutes.  Needs a release build and gnuplot.
Usage: python3 scripts/stability_map.py [--map FILE.csv] [--output FOLDER]
"""
import argparse
import csv
import pathlib
import subprocess

import evidence

PROGRAM = evidence.ROOT / "build/release/tests/stability/coupling_map"
PAPER_STEP = 2e-6 / 1.03e-5  # of Liu, Shikhov & Arns (2024), over the relaxation time
COLOURS = {"bounded": "#2a7f62", "oscillating": "#e0a030", "unstable": "#b03030"}

README = """# Stability of the coupling (tier transient)

Question: for which steps and densities can fluid and colloids be coupled step by step, as in the paper, and
for which by finding both motions together?

{provenance}

![Map of outcomes](map.png)

One colloid of 13.3 um on the axis of the reference throat at its narrowest, 5.5 cells per diameter, let go at rest in the
developed stream, 30 steps (40 below a tenth of the relaxation time). Relaxation time 2 rho_p a^2/(9 mu) = 10.3 us (at ratio
1.05). *explicit*: the force of the last flow step moves the colloid, the flow is given its new velocity (fidelity.coupling:
explicit). *implicit*: (T3) to (T6) of the [model](../../../solver/MODEL.md).
Criterion: *unstable*: the speed exceeds ten times that of the stream, or is not a number; *oscillating*: it passes its last
value by more than a tenth, or changes direction at five of the last ten steps; *bounded*: the rest.
The dashed line is the coupling step of the paper, 2 us, at its density ratio 1.05.

| step over relaxation time | {header} |
|---|{rule}|
{rows}

Each entry: explicit / implicit. b bounded, o oscillating, u unstable.

## What it says

- Explicit coupling fails beyond about a fifth to a half of the relaxation time at the paper's density ratio, and at a tenth and
  less for a colloid half as dense as the liquid. The paper's step lies just inside.
- Implicit coupling is never unstable in the map. From 10 relaxation times on (dense colloids; 30 at ratio 1) the first steps from
  rest pass the final speed by more than a tenth: the splitting of momentum and pressure, not the coupling; more passes (`fidelity.subiterations`) shorten it.
- Not mapped here: gaps below the grid, moduli, penalisation strength and refinement levels.
"""


def draw(rows, path):
    plots = []
    blocks = []
    for coupling in ("explicit", "implicit"):
        series = []
        for outcome, colour in COLOURS.items():
            points = [f"{r['step_over_relaxation']} {r['density_ratio']}" for r in rows
                      if r["coupling"] == coupling and r["outcome"] == outcome]
            name = f"${coupling}_{outcome}"
            blocks.append(f"{name} << EOD\n" + "\n".join(points or ["NaN NaN"]) + "\nEOD\n")
            series.append(f"{name} using 1:2 with points pt 7 ps 1.6 lc rgb '{colour}' "
                          f"title '{outcome}'")
        plots.append(f"set title '{coupling}'\nplot " + ", ".join(series) +
                     f", $paper using 1:2 with lines dt 2 lc rgb '#404040' title 'paper'")
    blocks.append(f"$paper << EOD\n{PAPER_STEP} 0.4\n{PAPER_STEP} 10\nEOD\n")
    evidence.gnuplot(f"""
set terminal pngcairo size 1200,520 font 'Liberation Sans,11'
set output '{path}'
{''.join(blocks)}
set logscale xy
set xrange [0.006:160]
set yrange [0.4:12]
set xlabel 'step / relaxation time'
set ylabel 'density of colloid / liquid'
set ytics (0.5, 1, 2, 4, 8)
set key outside bottom center horizontal
set grid lc rgb '#e0e0e0'
set multiplot layout 1,2
{chr(10).join(plots)}
unset multiplot
""")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--map", type=pathlib.Path, help="CSV that coupling_map printed")
    evidence.add_common_options(parser, "stability")
    options = parser.parse_args()
    options.output.mkdir(parents=True, exist_ok=True)
    provenance = evidence.provenance(options.solver)
    text = (options.map.read_text() if options.map else
            subprocess.run([str(PROGRAM)], capture_output=True, text=True, check=True).stdout)
    (options.output / "map.csv").write_text(text)
    rows = list(csv.DictReader(text.splitlines()))
    outcome = {(r["coupling"], float(r["step_over_relaxation"]), float(r["density_ratio"])):
               r["outcome"][0] for r in rows}
    steps = sorted({key[1] for key in outcome})
    ratios = sorted({key[2] for key in outcome})
    table = "\n".join("| " + " | ".join([f"{s:g}"] + [
        f"{outcome['explicit', s, r]} / {outcome['implicit', s, r]}" for r in ratios]) + " |"
        for s in steps)
    draw(rows, options.output / "map.png")
    (options.output / "README.md").write_text(README.format(
        provenance="\n".join(provenance), header=" | ".join(f"ratio {r:g}" for r in ratios),
        rule="|".join("---" for _ in ratios), rows=table))


if __name__ == "__main__":
    main()
