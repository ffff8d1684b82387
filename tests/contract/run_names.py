"""Reads a result by the names of the interface and checks what must hold in it."""
import sys

import h5py
import numpy as np

with h5py.File(sys.argv[1]) as file:
    assert file.attrs["complete"] == 1
    for name in ["tier", "ending", "seed", "t1_s", "tc_s", "alpha_deg"]:
        assert name in file.attrs, name
    for name in ["id", "position", "velocity"]:
        element = file["particles/colloids"][name]
        assert {"value", "step", "time"} <= set(element), name
    series = file["series"]
    for name in ["time_s", "critical_diameter_m", "permeability_m2", "permeability_ratio",
                 "retained", "first_layer", "multilayer", "traversed", "mobile"]:
        assert len(series[name]) == len(series["time_s"]), name
    time = series["time_s"][()]
    assert time[0] == 0 and len(time) == 501 and np.all(np.diff(time) > 0)
    injected = series["injected"][()]
    parts = sum(series[n][()] for n in ["delayed", "mobile", "retained", "traversed"])
    assert np.array_equal(injected, parts), "colloids are lost or made"
    layers = sum(series[n][()] for n in ["first_layer", "multilayer", "wall_layer"])
    assert np.array_equal(layers, series["retained"][()])
    assert np.all(series["bonded"][()] <= series["mobile"][()])
    # Certified to 1e-9 of the smallest sphere, so it may rise by that much.
    assert np.all(np.diff(series["critical_diameter_m"][()]) <= 1e-9 * 20e-6)
    retained = file["retained"]
    for name in ["order", "colloid", "time_s", "contact_time_s", "position_m", "layer",
                 "mechanism", "injection_position_m", "injection_time_s", "alpha_deg",
                 "partners", "bond_load_N"]:
        assert len(retained[name]) == series["retained"][-1], name
    layer = retained["layer"].asstr()[()]
    assert set(layer) <= {"first", "multilayer", "wall"}
    first = np.flatnonzero(layer == "first")
    assert file.attrs["t1_s"] == retained["time_s"][first[0]]
    assert file.attrs["alpha_deg"] == retained["alpha_deg"][first[0]]
    assert np.all(np.abs(retained["alpha_deg"][()][first]) <= 90)
    assert np.all(np.isnan(retained["alpha_deg"][()][layer != "first"]))
    assert np.all(retained["contact_time_s"][()] <= retained["time_s"][()])
    assert np.all(retained["injection_time_s"][()] < retained["time_s"][()])
    # No two colloids of the last frame overlap.
    position = file["particles/colloids/position/value"][-1]
    position = position[np.isfinite(position[:, 0])]
    distance = np.linalg.norm(position[:, None] - position[None], axis=2)
    distance += 1.0 * np.eye(len(position))
    assert distance.min() > 20e-6 * (1 - 1e-7), distance.min()
