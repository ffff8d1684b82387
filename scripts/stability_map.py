"""Where the coupling of fluid and colloid is stable: step against density ratio, explicit and
implicit; and step against gap, pressed to a wall and sliding along it, Young's modulus,
penalisation strength and refinement level.

Writes results/evidence/stability/{map.csv,map.png,more.csv,gap.png,sliding.png,modulus.png,
rigidity.png,level.png,README.md} with the programs coupling_map and stability_maps (tests/stability), a few
minutes each.  Needs a release build and gnuplot.
Usage: python3 scripts/stability_map.py [--map FILE.csv] [--more FILE.csv] [--output FOLDER]
"""
import argparse
import csv
import pathlib
import subprocess

import evidence

PROGRAM = evidence.ROOT / "build/release/tests/stability/coupling_map"
MORE = evidence.ROOT / "build/release/tests/stability/stability_maps"
PAPER_STEP = 2e-6 / 1.03e-5  # of Liu, Shikhov & Arns (2024), over the relaxation time
COLOURS = {"bounded": "#2a7f62", "warned": "#7fb070", "oscillating": "#e0a030",
           "unstable": "#b03030", "refused": "#808080"}
# name, what the parameter is, label of the step, the paper's (parameter, step)
MAPS = {
    "gap": ("gap over radius", "flow step / relaxation time", (0.01, PAPER_STEP)),
    "sliding": ("gap over radius", "flow step / relaxation time", (0.01, PAPER_STEP)),
    "modulus": ("Young's modulus of colloids [Pa]", "DEM step [s]", (7e7, 5e-8)),
    "rigidity": ("penalisation over nu/h^2 + 1/dt", "flow step / relaxation time",
                 (1e3, PAPER_STEP)),
    "level": ("2^{refinement level}", "flow step / relaxation time", (2, PAPER_STEP)),
}

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

- Implicit coupling is bounded at every gap from 0.3 to 1e-4 radii, towards the wall and along it, every penalisation from 1 to 1e6 and every refinement level, up to ten
  relaxation times; at a hundred the first steps from rest pass the final speed (as above), never further.
- Young's modulus limits the DEM step as (T-D8) says; nothing below its limit was unstable, above half of it there is a warning,
  beyond it the solver refuses.
- `coupling: explicit`, the one region known to be unstable that a scene can ask for, is announced with its limit before the run begins.
- Explicit coupling fails beyond about a fifth to a half of the relaxation time at the paper's density ratio, and at a tenth and
  less for a colloid half as dense as the liquid. The paper's step lies just inside.
- Implicit coupling is never unstable in the map. From 10 relaxation times on (dense colloids; 30 at ratio 1) the first steps from
  rest pass the final speed by more than a tenth: the splitting of momentum and pressure, not the coupling; more passes (`fidelity.subiterations`) shorten it.

## Gap, modulus, penalisation, refinement

Implicit coupling, density ratio 1.05, 20 steps. Crosses: the paper's coupling step of 2 us (modulus: its DEM step
of 5e-8 s); the gap drawn, 0.01 radii, is one that its colloids pass; penalisation and level are those that this tier uses. Letters as above, w: bounded after a warning, r: refused.

*gap*: a colloid in a closed box of six radii, 4 cells per diameter refined to 8, that a weight presses to the wall, from rest
at the gap; flow, discrete elements and sub-grid lubrication exchange as in a run. *bounded*: never faster than 1.5 times the weight over
Brenner's resistance at its gap, off the wall; *oscillating*: faster than that, upwards, or a change of direction at
five of the last eight steps; *unstable*: twice as fast as the weight makes it far from walls, or through the wall.

{gap}

![gap](gap.png)

*sliding*: the same with a weight along the wall; the exact resistance is that of a sphere that is free to turn (Goldman, Cox &
Brenner 1967).

{sliding}

![sliding](sliding.png)

*modulus*: two colloids meet head-on at 5 mm/s each without liquid, restitution 0.9. *bounded*: they part no faster than they met;
*unstable*: faster, or not; *refused*: by (T-D8).

{modulus}

![modulus](modulus.png)

*rigidity*: the case of the first map on 14 cells across, the penalisation strength lambda over nu/h^2 + 1/dt.

{rigidity}

![rigidity](rigidity.png)

*level*: the same on 10 cells across, refined 0 to 3 times at the colloid (1.4 to 11 cells per diameter).

{level}

![level](level.png)
"""


def draw(rows, path):
    plots = []
    blocks = []
    for coupling in ("explicit", "implicit"):
        series = []
        for outcome in ("bounded", "oscillating", "unstable"):
            colour = COLOURS[outcome]
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


def draw_more(name, rows, path):
    parameter, step, (paper, paper_step) = MAPS[name]
    blocks, series = [], []
    for outcome, colour in COLOURS.items():
        points = [f"{r['step']} {axis_value(name, r)}" for r in rows if r["outcome"] == outcome]
        if points:
            blocks.append(f"${outcome} << EOD\n" + "\n".join(points) + "\nEOD\n")
            series.append(f"${outcome} using 1:2 with points pt 7 ps 1.6 lc rgb '{colour}' "
                          f"title '{outcome}'")
    blocks.append(f"$paper << EOD\n{paper_step} {paper}\nEOD\n")
    series.append("$paper using 1:2 with points pt 2 ps 2 lw 2 lc rgb '#404040' title 'paper'")
    evidence.gnuplot(f"""
set terminal pngcairo size 640,480 font 'Liberation Sans,11'
set output '{path}'
{''.join(blocks)}
set logscale xy
set format '%g'
set offsets graph 0.08, graph 0.08, graph 0.08, graph 0.08
set xlabel '{step}'
set ylabel "{parameter}"
set key outside bottom center horizontal
set grid lc rgb '#e0e0e0'
plot {', '.join(series)}
""")


def axis_value(name, row):
    return 2**int(row["parameter"]) if name == "level" else row["parameter"]


def table_of(name, rows):
    parameters = list(dict.fromkeys(r["parameter"] for r in rows))
    steps = list(dict.fromkeys(r["step"] for r in rows))
    found = {(r["parameter"], r["step"]): r["outcome"][0] for r in rows}
    first = "step [s]" if name == "modulus" else "step over relaxation time"
    lines = [f"| {first} | " + " | ".join(f"{name} {p}" for p in parameters) + " |",
             "|---" * (len(parameters) + 1) + "|"]
    lines += [f"| {s} | " + " | ".join(found[p, s] for p in parameters) + " |" for s in steps]
    return "\n".join(lines)


def printed(program, given):
    return (given.read_text() if given else
            subprocess.run([str(program)], capture_output=True, text=True, check=True).stdout)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--map", type=pathlib.Path, help="CSV that coupling_map printed")
    parser.add_argument("--more", type=pathlib.Path, help="CSV that stability_maps printed")
    evidence.add_common_options(parser, "stability")
    options = parser.parse_args()
    options.output.mkdir(parents=True, exist_ok=True)
    provenance = evidence.provenance(options.solver)
    text = printed(PROGRAM, options.map)
    (options.output / "map.csv").write_text(text)
    more = printed(MORE, options.more)
    (options.output / "more.csv").write_text(more)
    tables = {}
    for name in MAPS:
        mine = [r for r in csv.DictReader(more.splitlines()) if r["map"] == name]
        tables[name] = table_of(name, mine)
        draw_more(name, mine, options.output / f"{name}.png")
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
        rule="|".join("---" for _ in ratios), rows=table, **tables))


if __name__ == "__main__":
    main()
