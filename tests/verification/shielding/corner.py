"""Resistance of a sphere near two perpendicular walls, from the resolved flow.

    python3 corner.py poreclog-solve > corner.csv            (5 minutes)

The sphere (radius 1 um) moves at a given velocity in a box 32 radii wide, h above the wall
z- and d from the wall x-, far from the others; forces over 6 pi mu a U.  Two grids.
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile

EDGE = 32
FACES = {side: "wall" for side in ("x-", "x+", "y-", "y+", "z-", "z+")}


def resistance(solver, folder, d, h, axis, cells):
    velocity = ["0 um/s"] * 3
    velocity[axis] = "1 um/s"
    scene = {"geometry": {"box": [f"{EDGE} um"] * 3, "faces": FACES,
                          "bodies": [{"center": [f"{d} um", f"{EDGE / 2} um", f"{h} um"],
                                      "diameter": "2 um", "velocity": velocity}]},
             "fluid": {"viscosity": "1 mPa s"}, "fidelity": {"lubrication": "resolved_only"}}
    path = pathlib.Path(folder) / "corner.json"
    path.write_text(json.dumps(scene))
    done = subprocess.run([solver, "measure", path, "--cells", *[str(cells)] * 3],
                          capture_output=True, text=True, check=True)
    force = json.loads(done.stdout)["bodies"][0]["force_N"][axis]
    return abs(force) / (6 * math.pi * 1e-3 * 1e-6 * 1e-6)


with tempfile.TemporaryDirectory() as folder:
    print("h,d,r_x,r_y,r_z,coarse_r_x,coarse_r_y,coarse_r_z")
    for h in (1.6, 2.5):
        for d in (1.6, 2.5, 4.4, EDGE / 2):
            if d < h:
                continue  # the same with x and z exchanged
            found = [resistance(sys.argv[1], folder, d, h, axis, cells)
                     for cells in (160, 112) for axis in range(3)]
            print(h, d, *(f"{value:.4f}" for value in found), sep=",", flush=True)
