"""The last diameter of the falls of ten Cate et al. (2002), with lubrication below the grid and
without.

Writes results/evidence/transient/last_diameter.{csv,md,png} with tests/verification/
transient_lubrication/last_diameter.  Falls that the table has already are not run again: delete it
for a new program.  Some minutes a fall.  Needs a release build and gnuplot.
Usage: python3 scripts/transient_last_diameter.py [--help]
"""
import argparse
import csv

import evidence

TOOL = "tests/verification/transient_lubrication/last_diameter"
COLUMNS = ["experiment", "cells_per_diameter", "lubrication", "gap_over_diameter", "time_s",
           "speed_m_s", "brenner_m_s"]
GAPS = [0.9, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01]
STYLES = {"full": "lw 2", "resolved_only": "lw 2 dt 2"}
COLOURS = {"E1": "#1f5fa0", "E4": "#c05020"}


def fall(tool, experiment, cells, lubrication):
    lines = evidence.finished([tool, experiment, cells, lubrication]).stdout.splitlines()
    return [dict(zip(COLUMNS, line.split(","))) for line in lines]


def chosen(rows, experiment, lubrication):
    return [r for r in rows if (r["experiment"], r["lubrication"]) == (experiment, lubrication)]


def table(rows):
    lines = ["| gap over diameter | " + " | ".join(
        f"{e} {m}" for e in COLOURS for m in STYLES) + " | Brenner, E1 |", "|---|" + "---|" * 5]
    for gap in GAPS:
        near = [min(chosen(rows, e, m), key=lambda r: abs(float(r["gap_over_diameter"]) - gap))
                for e in COLOURS for m in STYLES]
        cells = [f"{1e3 * float(r['speed_m_s']):.2f} ({float(r['time_s']):.3f} s)" for r in near]
        lines.append(f"| {gap:g} | " + " | ".join(cells) +
                     f" | {1e3 * float(near[0]['brenner_m_s']):.2f} |")
    return lines


def draw(rows, folder):
    blocks, plots = [], []
    for e, colour in COLOURS.items():
        for m, style in STYLES.items():
            points = "\n".join(f"{r['gap_over_diameter']} {r['speed_m_s']}"
                               for r in chosen(rows, e, m))
            blocks.append(f"${e}_{m} << EOD\n{points}\nEOD\n")
            name = m.replace("_", " ")
            plots.append(f"${e}_{m} with lines {style} lc rgb '{colour}' title '{e}, {name}'")
    brenner = "\n".join(f"{r['gap_over_diameter']} {r['brenner_m_s']}"
                        for r in chosen(rows, "E1", "full"))
    evidence.gnuplot(f"""
set terminal pngcairo size 760,520 font 'Liberation Sans,12'
set output '{folder / "last_diameter.png"}'
{''.join(blocks)}
$brenner << EOD
{brenner}
EOD
set xlabel 'gap over diameter'
set ylabel 'speed [m/s]'
set logscale xy
set xrange [1:0.0095]
set grid
set key bottom right
plot {', '.join(plots)}, $brenner with lines lc rgb '#909090' title 'Brenner (1961), E1'
""")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    evidence.add_common_options(parser, "transient")
    parser.add_argument("--cells", type=int, default=10, help="per diameter")
    options = parser.parse_args()
    tool = options.solver.parent.parent / TOOL
    provenance = evidence.provenance(options.solver)
    file = options.output / "last_diameter.csv"
    rows = list(csv.DictReader(file.open())) if file.exists() else []
    for experiment in COLOURS:
        for lubrication in STYLES:
            if not chosen(rows, experiment, lubrication):
                rows += fall(tool, experiment, options.cells, lubrication)
                evidence.write_rows(file, rows)
    (options.output / "last_diameter.md").write_text("\n".join([
        *provenance, "",
        f"{options.cells} cells per diameter, Courant number 0.3, two passes a step. Speed [mm/s], in "
        "brackets the time since the gap was a diameter; the rows nearest to each gap.", "",
        *table(rows), ""]))
    draw(rows, options.output)


if __name__ == "__main__":
    main()
