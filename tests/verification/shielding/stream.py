"""Drive and motion of a colloid in the throat of the reference scene, from the resolved flow.

    python3 stream.py poreclog-solve > stream.csv            (10 minutes)

The colloid (13.3 um) is held in campaigns/throat.scene.json, or moves along x, y or z.  The forces
on it over 6 pi mu a give the drive D and the resistance R
to motion of its centre; U = R^-1 D is its motion free of force and held from turning.  In mm/s;
places in um from the corner of the box.  Two resolutions, cells per colloid.  Needs numpy.
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

SCENE = pathlib.Path(__file__).parents[3] / "campaigns/throat.scene.json"
DIAMETER = 13.3
CELLS = (8, 5.5)
PLACES = (
    (83.77, 84.12, 128.4), (82.59, 82.97, 122.7), (80.68, 81.11, 114.1),  # along the throat's axis
    (48.3, 83.97, 128.4), (70, 84, 110), (75, 88, 105),                   # beside one wall, and two
    (84, 84, 102),                                                        # at a grain
)


def force(solver, folder, place, velocity, cells):
    scene = json.loads(SCENE.read_text())
    scene["fidelity"] = {"tier": "quasi_steady"}
    scene["geometry"]["bodies"] = [{"center": [f"{c} um" for c in place],
                                    "diameter": f"{DIAMETER} um",
                                    "velocity": [f"{v} mm/s" for v in velocity]}]
    path = pathlib.Path(folder) / "stream.json"
    path.write_text(json.dumps(scene))
    done = subprocess.run([solver, "measure", path, "--cells-per-colloid", str(cells), "--json"],
                          capture_output=True, text=True, check=True)
    drag_of_one_mm_per_s = 6 * math.pi * 1e-3 * DIAMETER / 2 * 1e-6 * 1e-3
    return [f / drag_of_one_mm_per_s for f in json.loads(done.stdout)["bodies"][0]["force_N"]]


def drive_and_motion(solver, folder, place, cells):
    drive = np.array(force(solver, folder, place, (0, 0, 0), cells))
    resistance = [drive - force(solver, folder, place, velocity, cells) for velocity in np.eye(3)]
    return [*drive, *np.linalg.solve(np.transpose(resistance), drive)]


with tempfile.TemporaryDirectory() as folder:
    names = [f"{what}_{axis}" for what in ("d", "u") for axis in "xyz"]
    print("x,y,z", *names, *(f"coarse_{name}" for name in names), sep=",")
    for place in PLACES:
        found = [v for cells in CELLS for v in drive_and_motion(sys.argv[1], folder, place, cells)]
        print(*place, *(f"{v:.5f}" for v in found), sep=",", flush=True)
