"""Velocity profiles across the reference throat on a coarse and a fine grid.

Writes results/evidence/throat_profile/{table.csv,profiles.png,README.md}.  Needs a release
build and gnuplot.  200 cells across take about two minutes and 9 GiB for each of the three
lines.  Usage: python3 scripts/throat_profile.py [--coarse N] [--fine N] [--help]
"""
import argparse
import json
import math
import textwrap

import evidence

SCENE = evidence.ROOT / "campaigns/throat.scene.json"


def micrometres(text):
    """"96.6 um" in metres."""
    number, unit = text.split()
    assert unit == "um", text
    return float(number) * 1e-6


GEOMETRY = json.loads(SCENE.read_text())["geometry"]
WIDTH = micrometres(GEOMETRY["collector_diameter"])  # of the box too [m]
HEIGHT = micrometres(GEOMETRY["height"])             # 1.5 WIDTH [m]
COLUMNS = [("line", "s"), ("distance_m", ".6e"), ("coarse_m_s", ".6e"), ("fine_m_s", ".6e")]

# The lines of Figure 4 of Liu, Shikhov & Arns (2024): name -> ends [m].  The narrowest plane
# is half a width above the outlet.
LINES = {
    "diagonal of the narrowest plane": ((0.0, 0.0, 0.5 * WIDTH), (WIDTH, WIDTH, 0.5 * WIDTH)),
    "mid-line of the narrowest plane": ((0.0, 0.5 * WIDTH, 0.5 * WIDTH),
                                        (WIDTH, 0.5 * WIDTH, 0.5 * WIDTH)),
    "axis of the box": ((0.5 * WIDTH, 0.5 * WIDTH, 0.0), (0.5 * WIDTH, 0.5 * WIDTH, HEIGHT)),
}


def profile(options, across, ends):
    """(distance along the line, speed down the throat) of each point, [m] and [m/s]."""
    # The height is 1.5 widths, so even numbers across keep the cells cubes.
    found = evidence.measure(options.solver, SCENE, "--cells", across, across, across * 3 // 2,
                             "--threads", options.threads,
                             "--profile", *[repr(x) for end in ends for x in end],
                             options.points)
    return [(math.dist(p["position_m"], ends[0]), -p["velocity_m_s"][2])
            for p in found["profile"]]


def errors(rows):
    peak = max(abs(r["fine_m_s"]) for r in rows)
    apart = [abs(r["coarse_m_s"] - r["fine_m_s"]) / peak for r in rows]
    return {"peak": peak, "rms": math.sqrt(sum(e * e for e in apart) / len(apart)),
            "largest": max(apart)}


def draw(rows, options):
    blocks, plots = [], []
    for number, name in enumerate(LINES):
        points = "\n".join(f"{1e6 * r['distance_m']} {1e3 * r['coarse_m_s']} {1e3 * r['fine_m_s']}"
                           for r in rows if r["line"] == name)
        blocks.append(f"$l{number} << EOD\n{points}\nEOD")
        plots.append(f"set title '{name}'\n"
                     f"plot $l{number} using 1:3 with lines lw 2 lc 'gray30' "
                     f"title '{options.fine} cells across', "
                     f"$l{number} using 1:2 with points pt 6 ps 0.7 lc rgb '#c03020' "
                     f"title '{options.coarse} cells across'")
    evidence.gnuplot("\n".join(blocks) + f"""
set terminal pngcairo size 1500,460 font 'sans,12'
set output '{options.output / "profiles.png"}'
set multiplot layout 1,{len(LINES)}
set grid
set key bottom center
set yrange [0:*]
set xlabel 'distance along the line / um'
set ylabel 'speed down the throat / (mm/s)'
""" + "\n".join(plots) + "\n")


def even(text):
    n = int(text)
    if n < 2 or n % 2:
        raise argparse.ArgumentTypeError("an even number of cells, at least 2")
    return n


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    evidence.add_common_options(parser, "throat_profile")
    parser.add_argument("--coarse", type=even, default=40, help="cells across (default: 40)")
    parser.add_argument("--fine", type=even, default=200, help="cells across (default: 200)")
    parser.add_argument("--points", type=int, default=97, help="of each line (default: 97)")
    parser.add_argument("--threads", type=int, default=1, help="of the solver (default: 1)")
    options = parser.parse_args()
    origin = "\n".join(evidence.provenance(options.solver))
    rows, table, reading = [], [], []
    for name, ends in LINES.items():
        coarse = profile(options, options.coarse, ends)
        fine = profile(options, options.fine, ends)
        mine = [{"line": name, "distance_m": x, "coarse_m_s": u, "fine_m_s": v}
                for (x, u), (_, v) in zip(coarse, fine)]
        rows += mine
        e = errors(mine)
        table.append(f"| {name} | {1e3 * e['peak']:.4f} | {100 * e['rms']:.3f} | "
                     f"{100 * e['largest']:.3f} |")
        worst = max(mine, key=lambda r: abs(r["coarse_m_s"] - r["fine_m_s"]))
        reading.append(f"{name}: rms {100 * e['rms']:.2f} % of the peak; at most "
                       f"{100 * e['largest']:.2f} %, {1e6 * worst['distance_m']:.1f} um along "
                       "the line.")
        print(reading[-1])
    options.output.mkdir(parents=True, exist_ok=True)
    evidence.write_csv(options.output / "table.csv", COLUMNS, rows)
    draw(rows, options)
    table, says = "\n".join(table), "\n".join(
        textwrap.fill(line, 92, initial_indent="- ", subsequent_indent="  ") for line in reading)
    (options.output / "README.md").write_text(f"""# Velocity profiles across the throat

Question: how far are velocities on a grid of {options.coarse} cells across the reference throat from
those on one of {options.fine}?

Scene: campaigns/throat.scene.json without a deposit. {options.points} points a line; the velocity between
grid points is interpolated as the particles see it. "Down the throat" is -z. Errors are
differences from the fine grid over the largest speed on the line; the fine grid has an error
of its own, in second order ({options.coarse}/{options.fine})^2 = {(options.coarse / options.fine) ** 2:.3g} of the coarse one's.

{origin}

![speed along three lines](profiles.png)

| line | peak / (mm/s) | rms error / % | largest error / % |
|---|---|---|---|
{table}

The mid-line ends where two grains touch: at a distance x from there the gap between them is
2(sqrt(R^2 + x^2) - R), R = {1e6 * WIDTH / 2:.1f} um; a cell of the coarse grid is {1e6 * WIDTH / options.coarse:.2f} um.

## What the picture says

{says}
""")


if __name__ == "__main__":
    main()
