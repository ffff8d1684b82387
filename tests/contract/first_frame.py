"""Exits with 0 if a result's first frame and its list of injections begin with colloids at
the places given.  Usage: first_frame.py RESULT.h5 X,Y,Z ..."""
import sys

import h5py

places = [[float(x) for x in place.split(",")] for place in sys.argv[2:]]
with h5py.File(sys.argv[1]) as file:
    colloids = file["particles/colloids"]
    assert colloids["position/time"][0] == 0.0
    for index, place in enumerate(places):
        assert colloids["id/value"][0][index] == index
        assert list(colloids["position/value"][0][index]) == place
        assert file["injections/index"][index] == index
        assert list(file["injections/position_m"][index]) == place
