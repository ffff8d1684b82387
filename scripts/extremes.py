"""Run poreclog-solve at extreme values of flow, geometry and surface forces.

Every case must survive (exit code 0) or be refused with a message (2); a flow that does
not converge (3) is listed as such.  A crash, exit code 4, or more than 120 s is a failure:
the script then ends with 1.  Writes table.csv (one row per case) and README.md.

    python3 scripts/extremes.py [--solve build/ci/solver/poreclog-solve]
                                [--output results/evidence/extremes] [--only WORD]
"""
import argparse
import datetime
import json
import math
import os
import pathlib
import subprocess
import tempfile
import time

import evidence

ROOT = evidence.ROOT
TIMEOUT = 120.0
COLLECTOR = 96.6e-6
HEIGHT = 144.9e-6
RADIUS = 6.65e-6  # colloid
CENTRE = 0.5 * COLLECTOR
THROAT = (math.sqrt(2.0) - 1.0) * COLLECTOR
COARSE = ["--cells-per-colloid", "3"]


class Case:
    def __init__(self, name, value, scene, options=(), deposit=(), expect=""):
        self.name, self.value, self.scene = name, str(value), scene
        self.options, self.deposit = list(options), list(deposit)
        self.expect = expect  # "survived" or "refused" where only one is right


def throat(**changes):
    """The reference scene; a key with __ for / reaches into it."""
    scene = json.loads((ROOT / "campaigns/throat.scene.json").read_text())
    for pointer, value in changes.items():
        *path, last = pointer.split("__")
        node = scene
        for key in path:
            node = node.setdefault(key, {})
        node[last] = value
    return scene


PRESSURE = {"drive": {"pressure_drop": "1 Pa"}}


def metres(x):
    return f"{x:.12g} m"


def box(size, faces, spheres=(), drive=None, **more):
    words = {"w": "wall", "p": "periodic", "i": "inlet", "o": "outlet", "s": "symmetry"}
    scene = {"geometry": {
        "box": [metres(x) for x in size],
        "faces": {name: words[c] for name, c in zip(["x-", "x+", "y-", "y+", "z-", "z+"], faces)},
        "spheres": [{"center": [metres(x) for x in s[:3]], "diameter": metres(s[3])}
                    for s in spheres]}}
    if drive:
        scene["drive"] = drive
    scene.update(more)
    return scene


def beside_collector(gap, elevation=0.0):
    """A colloid in the diagonal plane, `gap` away from the collector at the origin's edge."""
    distance = 0.5 * COLLECTOR + RADIUS + gap
    across = distance * math.cos(elevation) / math.sqrt(2.0)
    return (across, across, 0.5 * COLLECTOR + distance * math.sin(elevation), 2 * RADIUS)


def surface_cases():
    for strength in ["0.1 mM", "1 mM", "10 mM", "300 mM", "1 M", "5 M", "21 M"]:
        yield Case("ionic strength", strength, throat(surface__ionic_strength=strength), COARSE,
                   expect="refused" if strength == "21 M" else "survived")
    for hamaker in ["0 J", "1e-24 J", "1e-22 J", "1e-19 J", "1e-17 J", "-1e-20 J"]:
        yield Case("Hamaker constant", hamaker, throat(surface__hamaker=hamaker), COARSE,
                   expect="refused" if hamaker[0] == "-" else "survived")
    for colloid, grain in [("0 mV", "0 mV"), ("-27.9 mV", "0 mV"), ("-27.9 mV", "15.7 mV"),
                           ("-100 mV", "-100 mV"), ("-200 mV", "200 mV"), ("1e-6 mV", "-1e-6 mV"),
                           ("-1 V", "-1 V"), ("2 V", "0 mV")]:
        yield Case("zeta potentials colloid, grain", f"{colloid}, {grain}",
                   throat(surface__zeta_colloid=colloid, surface__zeta_grain=grain), COARSE,
                   expect="refused" if colloid == "2 V" else "survived")
    for hamaker, zeta, strength in [("0 J", "0 mV", "300 mM"), ("1e-24 J", "-100 mV", "0.1 mM"),
                                    ("1e-17 J", "-1 V", "0.1 mM"), ("0 J", "-1 V", "5 M")]:
        yield Case("Hamaker, both zetas, ionic strength", f"{hamaker}, {zeta}, {strength}",
                   throat(surface__hamaker=hamaker, surface__zeta_colloid=zeta,
                          surface__zeta_grain=zeta, surface__ionic_strength=strength), COARSE,
                   expect="survived")
    for born in ["1e-15 m", "0.1 nm", "5 nm", "100 nm"]:
        yield Case("Born diameter", born, throat(surface__born_diameter=born), COARSE)
    for form, strength in [("derjaguin", "0.1 mM"), ("derjaguin", "5 M")]:
        yield Case("double layer form, ionic strength", f"{form}, {strength}",
                   throat(surface__double_layer=form, surface__ionic_strength=strength,
                          surface__van_der_waals="retarded"), COARSE, expect="survived")


def flow_cases():
    for speed in ["1e-6 m/s", "1e-5 m/s", "1e-3 m/s", "1e-2 m/s", "1e-1 m/s", "1e-30 m/s",
                  "100 m/s", "0 m/s", "-1e-3 m/s"]:
        yield Case("inlet velocity", speed, throat(drive__inlet_velocity=speed), COARSE,
                   expect="refused" if speed[0] in "0-" else "survived")
    for drop in ["1e-12 Pa", "1e12 Pa"]:
        yield Case("pressure drop", drop, throat(drive={"pressure_drop": drop}), COARSE,
                   expect="survived")
    for viscosity in ["1e-9 Pa s", "1e-5 Pa s", "1e6 Pa s", "0 Pa s", "-1 mPa s"]:
        yield Case("viscosity", viscosity, throat(fluid__viscosity=viscosity), COARSE,
                   expect="refused" if viscosity[0] in "0-" else "survived")
    for density in ["1 kg/m^3", "500 kg/m^3", "1000 kg/m^3", "2000 kg/m^3", "8000 kg/m^3"]:
        yield Case("colloid density", density, throat(colloids__density=density), COARSE,
                   expect="survived")
    for temperature in ["1 K", "1000 K"]:
        yield Case("temperature", temperature, throat(fluid__temperature=temperature), COARSE,
                   expect="survived")
    for tolerance in [1e-14, 1e-10, 0.1]:
        yield Case("flow tolerance", tolerance, throat(fidelity__tolerance=tolerance), COARSE)


def grid_cases():
    scene = throat()
    for cells in [0.5, 1, 2, 4, 8, 12]:
        yield Case("cells per colloid, whole throat", cells, scene,
                   ["--cells-per-colloid", str(cells)], expect="survived")
    for cells in [200, 1000]:
        yield Case("cells per colloid, whole throat", cells, scene,
                   ["--cells-per-colloid", str(cells)], expect="refused")
    edge = 3.5 * RADIUS
    held = box([edge] * 3, "pppppp", [(edge / 2, edge / 2, edge / 2, 2 * RADIUS)],
               {"body_force": ["0 N/m^3", "0 N/m^3", "-1000 N/m^3"]})
    for cells in [2, 10, 20, 40]:
        yield Case("cells per colloid, periodic box of 1.75 diameters", cells, held,
                   ["--cells-per-diameter", str(cells)], expect="survived")
    for cells in ["1 1 1", "1 1 60", "40 40 1", "64 1 64", "2 3 5", "7 11 13", "200 4 4",
                  "4 4 400", "1000 2 2", "20000 1 1", "1 1 20000", "33 33 49"]:
        yield Case("cells, whole throat", cells, scene, ["--cells", *cells.split()],
                   expect="survived")
    yield Case("cells, whole throat", "100000 100000 100000", scene,
               ["--cells"] + ["100000"] * 3, expect="refused")
    for size in [(1e-6, 100e-6, 100e-6), (100e-6, 1e-7, 100e-6), (50e-6, 50e-6, 0.5e-6)]:
        for faces in ["wwwwoi", "ppppoi", "ssssoi"]:
            yield Case("thin box, faces", f"{size}, {faces}", box(size, faces, (), PRESSURE["drive"]),
                       ["--cells"] + [str(max(1, round(x / 5e-6))) for x in size],
                       expect="survived" if faces[0] == "w" else "refused")
    for drive in [{"inlet_velocity": "1 mm/s"}, {"pressure_drop": "1 Pa"}]:
        yield Case("nothing resists the flow", str(drive), box((5e-5,) * 3, "ssppoi", (), drive),
                   ["--cells", "10", "10", "10"],
                   expect="survived" if "inlet_velocity" in drive else "refused")
    for drive in [{"body_force": ["0 N/m^3", "0 N/m^3", "-1 N/m^3"]},
                  {"mean_velocity": ["0 m/s", "0 m/s", "-1 mm/s"]}]:
        yield Case("nothing resists the flow", str(drive), box((5e-5,) * 3, "pppppp", (), drive),
                   ["--cells", "10", "10", "10"], expect="refused")
    yield Case("needle box, default grid", "1 nm x 1 nm x 100 m",
               box((1e-9, 1e-9, 100.0), "wwwwoi", (), PRESSURE["drive"]), expect="refused")
    yield Case("plate box, default grid", "1 nm x 1 m x 1 m",
               box((1e-9, 1.0, 1.0), "wwwwoi", (), PRESSURE["drive"]), expect="refused")


def gap_cases():
    for gap in [1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 0.0, -1e-4, -1e-1]:
        on_grain = beside_collector(gap * RADIUS)
        yield Case("gap deposit-grain over a", gap, throat(), COARSE, [on_grain], "survived")
        x, y, z, d = beside_collector(0.1 * RADIUS)
        step = (2.0 + gap) * RADIUS / math.sqrt(2.0)
        yield Case("gap deposit-deposit over a", gap, throat(), COARSE,
                   [(x, y, z, d), (x + step, y + step, z, d)], "survived")
        yield Case("gap deposit-side wall over a", gap, throat(), COARSE,
                   [(RADIUS * (1.0 + gap), CENTRE, 1.2 * COLLECTOR, 2 * RADIUS)], "survived")
        edge = 4.0 * RADIUS
        yield Case("gap sphere-image over a", gap,
                   box([(2.0 + gap) * RADIUS, edge, edge], "pppppp",
                       [((1.0 + gap / 2) * RADIUS, edge / 2, edge / 2, 2 * RADIUS)],
                       {"body_force": ["0 N/m^3", "0 N/m^3", "-1000 N/m^3"]}),
                   ["--cells-per-diameter", "10"], expect="survived")
    for faces in ["wwwwoi", "ssssoi"]:
        edge = 40e-6
        yield Case("sphere tangent to four walls and both ends", faces,
                   box([edge] * 3, faces, [(edge / 2, edge / 2, edge / 2, edge)],
                       PRESSURE["drive"]), ["--cells", "20", "20", "20"], expect="survived")
    same = (CENTRE, CENTRE, CENTRE, 2 * RADIUS)
    yield Case("overlapping spheres", "two identical", throat(), COARSE, [same, same], "survived")
    yield Case("overlapping spheres", "one inside another", throat(), COARSE,
               [same, same[:3] + (RADIUS,)], "survived")
    yield Case("overlapping spheres", "100 identical", throat(), COARSE, [same] * 100, "survived")
    yield Case("tiny spheres", "diameter 1e-12 m", throat(), COARSE, [same[:3] + (1e-12,)],
               "survived")
    yield Case("sphere inside a grain", "deposit at a collector's centre", throat(), COARSE,
               [(1e-6, 1e-6, CENTRE, 2 * RADIUS)], "survived")


def chain(count, gap):
    """A straight chain on the throat's diagonal, its ends at `gap` from two collectors."""
    d = (math.sqrt(2.0) * COLLECTOR - COLLECTOR - 2 * gap) / count
    first = 0.5 * COLLECTOR + gap + 0.5 * d
    return [((first + n * d) / math.sqrt(2.0),) * 2 + (CENTRE, d) for n in range(count)]


def throat_cases():
    for drive in [{}, PRESSURE]:
        word = "constant pressure" if drive else "constant flux"
        yield Case("touching cluster of four across the throat", word, throat(**drive), COARSE,
                   chain(4, 0.0), "survived")
        # four in a square, each touching two others and a collector: closes all but the middle
        d = 2.0 * RADIUS
        square = [(CENTRE + sx * d / 2, CENTRE + sy * d / 2, CENTRE, d)
                  for sx in (-1, 1) for sy in (-1, 1)]
        yield Case("touching square of four in the throat", word, throat(**drive), COARSE, square,
                   "survived")
        plug = [(CENTRE, CENTRE, CENTRE, 100e-6)]
        yield Case("fully blocked throat", word, throat(**drive), COARSE, plug,
                   "survived" if drive else "refused")
        grid = [((i + 0.5) * 8e-6, (j + 0.5) * 8e-6, 120e-6, 12e-6) for i in range(13)
                for j in range(13) if (i + 0.5) * 8e-6 < 102e-6 and (j + 0.5) * 8e-6 < 102e-6]
        yield Case("fully blocked by a layer of 169 overlapping spheres", word, throat(**drive),
                   COARSE, grid, "survived" if drive else "refused")
        layer = [((i + 0.5) * COLLECTOR / 7, (j + 0.5) * COLLECTOR / 7, 120e-6, COLLECTOR / 7)
                 for i in range(7) for j in range(7)]
        for cells in ["0.5", "1", "2", "3", "5.5"]:
            yield Case("touching layer of 7 x 7, cells per colloid",
                       f"{cells}, {word}", throat(**drive), ["--cells-per-colloid", cells], layer,
                       "survived")
        layer = [s[:3] + (s[3] * 1.2,) for s in layer]
        yield Case("overlapping layer: slits of 0.04 d open", word, throat(**drive), COARSE, layer,
                   "survived")
        for ratio in [0.5, 0.99, 0.999999, 1.0, 1.000001, 1.01, 1.5]:
            size = ratio * THROAT
            yield Case("deposited sphere over throat size", f"{ratio}, {word}", throat(**drive),
                       COARSE, [(CENTRE, CENTRE, CENTRE, size)], "survived")
    for ratio in [0.99, 1.0, 1.01]:
        yield Case("colloid over throat size", ratio,
                   throat(colloids__diameter=metres(ratio * THROAT)), ["--cells-per-colloid", "8"],
                   expect="survived")
    for size, expect in [("1e-9 m", ""), ("96.5 um", "survived"), ("96.6 um", "refused")]:
        yield Case("colloid diameter", size, throat(colloids__diameter=size),
                   ["--cells", "22", "22", "33"], expect=expect)


def pack_cases():
    edge = 40e-6
    touching = [(x, y, z, edge / 2) for x in (edge / 4, 3 * edge / 4)
                for y in (edge / 4, 3 * edge / 4) for z in (edge / 4, 3 * edge / 4)]
    force = {"body_force": ["0 N/m^3", "0 N/m^3", "-1000 N/m^3"]}
    held = {"mean_velocity": ["0 m/s", "0 m/s", "-0.5 mm/s"]}
    for name, drive in [("body force", force), ("mean velocity", held)]:
        for cells in ["1", "2", "3", "4", "7", "16"]:
            yield Case("touching simple-cubic pack, cells per edge", f"{cells}, {name}",
                       box([edge] * 3, "pppppp", touching, drive), ["--cells"] + [cells] * 3,
                       expect="survived")
            yield Case("touching simple-cubic pack with inlet, cells per edge",
                       f"{cells}, {name}",
                       box([edge] * 3, "ppppoi",
                           [s[:2] + (edge / 4 + 0.5 * s[2],) + (s[3],) for s in touching],
                           PRESSURE["drive"] if drive is force else {"inlet_velocity": "1 mm/s"}),
                       ["--cells"] + [cells] * 3, expect="survived")
        half = edge / 2
        fcc = [(x * half, y * half, z * half, edge / math.sqrt(2.0))
               for x, y, z in [(0, 0, 0), (1, 1, 0), (1, 0, 1), (0, 1, 1)]]
        for cells in ["4", "8", "20"]:
            yield Case("touching face-centred pack, cells per edge", f"{cells}, {name}",
                       box([edge] * 3, "pppppp", fcc, drive), ["--cells"] + [cells] * 3,
                       expect="survived")
        sealed = [(half, half, half, 1.45 * edge)]
        yield Case("sealed periodic array", name, box([edge] * 3, "pppppp", sealed, drive),
                   ["--cells", "20", "20", "20"],
                   expect="survived" if drive is force else "refused")
    full = [(edge / 2, edge / 2, edge / 2, 2 * edge)]
    yield Case("box without any void", "one sphere", box([edge] * 3, "pppppp", full, force),
               expect="refused")
    yield Case("shear", "1e9 1/s", box([edge] * 3, "ppppww", touching[:1],
                                       {"shear_rate": "1e9 1/s"}), ["--cells", "20", "20", "20"],
               expect="survived")
    yield Case("no drive", "colloids and a sphere",
               box([edge] * 3, "wwwwww", touching[:1], colloids={"diameter": "5 um"}),
               expect="survived")
    yield Case("sphere leaves a film at a wall", "diameter edge - 1 nm",
               box([edge] * 3, "wwwwww", [(edge / 2,) * 3 + (edge - 1e-9,)], force),
               ["--cells", "10", "10", "10"])
    moving = throat()
    moving["geometry"]["bodies"] = [{"center": ["48.3 um", "48.3 um", "120 um"],
                                     "diameter": "13.3 um"}]
    moving["fidelity"] = {"tier": "auto"}
    yield Case("bodies", "one free", moving, COARSE, expect="refused")


GROUPS = [surface_cases, flow_cases, grid_cases, gap_cases, throat_cases, pack_cases]
COLUMNS = ["case", "value", "exit_code", "outcome", "as_expected", "seconds", "cells", "iterations",
           "subgrid_openings", "critical_diameter_m", "permeability_m2", "pressure_drop_Pa",
           "largest_speed_m_s", "capture_gap_m", "energy_barrier_kT", "message"]


def finite(value):
    if isinstance(value, dict):
        return all(finite(v) for v in value.values())
    if isinstance(value, list):
        return all(finite(v) for v in value)
    return not isinstance(value, float) or math.isfinite(value)


def judge(case, code, document, message):
    """The outcome in a word, and whether it is what must be."""
    if code == 0:
        outcome = "survived" if document is not None and finite(document) else "bad output"
    else:
        outcome = {2: "refused", 3: "not converged", 124: "hung"}.get(code, "crashed")
    if outcome == "refused" and (message.count("\n") != 1 or ": " not in message):
        outcome = "refused badly"
    allowed = [case.expect] if case.expect else ["survived", "refused", "not converged"]
    return outcome, outcome in allowed


def run(case, solve, folder):
    scene = folder / "scene.json"
    scene.write_text(json.dumps(case.scene))
    command = [solve, "measure", str(scene), *case.options]
    if case.deposit:
        rows = ["x_m,y_m,z_m,diameter_m"] + [",".join(repr(float(x)) for x in s)
                                             for s in case.deposit]
        (folder / "deposit.csv").write_text("\n".join(rows) + "\n")
        command += ["--deposit", str(folder / "deposit.csv")]
    start = time.monotonic()
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=TIMEOUT)
        code, out, message = done.returncode, done.stdout, done.stderr
    except subprocess.TimeoutExpired:
        code, out, message = 124, "", ""
    seconds = time.monotonic() - start
    try:
        document = json.loads(out) if code == 0 else None
    except json.JSONDecodeError:
        document = None
    outcome, good = judge(case, code, document, message)
    row = {"case": case.name, "value": case.value, "exit_code": code, "outcome": outcome,
           "as_expected": "yes" if good else "NO", "seconds": f"{seconds:.2f}",
           "message": message.strip().replace(str(folder) + "/", "")}
    if document:
        flow, regime = document["flow"], document["regime"]
        row["cells"] = "x".join(str(n) for n in document["grid"]["cells"])
        for key in ["iterations", "subgrid_openings", "permeability_m2", "pressure_drop_Pa"]:
            row[key] = flow[key]
        row["critical_diameter_m"] = document["critical_diameter_m"]
        for key in ["largest_speed_m_s", "capture_gap_m", "energy_barrier_kT"]:
            row[key] = regime[key]
        for key, value in row.items():
            if isinstance(value, float):
                row[key] = f"{value:.6g}"
    return row


def first_line(command):
    try:
        return subprocess.run(command, capture_output=True, text=True, cwd=ROOT,
                              check=True).stdout.strip()
    except (OSError, subprocess.CalledProcessError):
        return "unknown"


def machine():
    lines = first_line(["lscpu"]).splitlines()
    model = [x.split(":", 1)[1].strip() for x in lines if x.startswith("Model name")]
    return f"{model[0] if model else 'unknown'}, {len(os.sched_getaffinity(0))} cores"


def readme(rows):
    count = {}
    for row in rows:
        count[row["outcome"]] = count.get(row["outcome"], 0) + 1
    bad = [row for row in rows if row["as_expected"] != "yes"]
    commit = first_line(["git", "rev-parse", "--short", "HEAD"])
    changed = first_line(["git", "status", "--porcelain", "--", "solver", "campaigns"])
    listed = "".join(f"- {r['case']} = {r['value']}: {r['outcome']}. {r['message']}\n" for r in bad)
    slowest = max(rows, key=lambda r: float(r["seconds"]))
    return f"""# Extreme values

What poreclog-solve does at the extreme values of flow, geometry and surface forces that a
scene may hold: every case survives or is refused with a message.

- command: `python3 scripts/extremes.py`
- commit: {commit}{" with local changes" if changed else ""}
- machine: {machine()}
- date: {datetime.date.today()}

{len(rows)} cases: {", ".join(f"{n} {word}" for word, n in sorted(count.items()))}; slowest
{slowest["seconds"]} s ({slowest["case"]} = {slowest["value"]}), limit {TIMEOUT:g} s.
{len(bad)} not as expected{":" if bad else "."}
{listed}
table.csv: one row per case.  Deposits are given with --deposit.  The top of 2 to 40 cells per
colloid is run on a periodic box of 1.75 diameters; the whole throat has 290 x 290 x 436 cells
at 40, about 26 GiB, which measure refuses on smaller machines.

Pores that the grid closes are opened by a conductance (MODEL F15) that is good to a factor: the
touching layer of 7 x 7 has 0.5 times the permeability on 1 cell per colloid, where 85 faces are
opened, that it has on 5.5; the touching simple-cubic pack 3.6 times on 2 cells per edge that on
16.
"""


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--solve", default=str(ROOT / "build/ci/solver/poreclog-solve"))
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "results/evidence/extremes")
    parser.add_argument("--only", default="", help="run only cases whose name contains this")
    arguments = parser.parse_args()
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for group in GROUPS:
            for case in group():
                if arguments.only in case.name:
                    rows.append(run(case, arguments.solve, pathlib.Path(folder)))
                    r = rows[-1]
                    print(f"{r['outcome']:14}{r['as_expected']:5}{r['seconds']:>7} s  "
                          f"{r['case']} = {r['value']}  {r['message'][:160]}", flush=True)
    arguments.output.mkdir(parents=True, exist_ok=True)
    evidence.write_rows(arguments.output / "table.csv", rows, COLUMNS)
    (arguments.output / "README.md").write_text(readme(rows))
    return 1 if any(row["as_expected"] != "yes" for row in rows) else 0


if __name__ == "__main__":
    raise SystemExit(main())
