"""Compares the files of scripts/result_to_vtk.py with the result they came from.

    vtk_files.py RESULT.h5 FOLDER

Reads the XML as the VTK file formats document describes it, number by number.  Prints one
line per difference.
"""
import base64
import pathlib
import sys
import xml.etree.ElementTree as xml

import h5py
import numpy

TYPES = {"Float64": "<f8", "Int64": "<i8", "Int8": "<i1"}


def arrays_of(path):
    """Every data array of the one piece, by name, and its number of points."""
    root = xml.parse(path).getroot()
    assert root.tag == "VTKFile" and root.get("type") == "PolyData", path
    assert (root.get("header_type"), root.get("byte_order")) == ("UInt64", "LittleEndian")
    (piece,) = root.findall("PolyData/Piece")
    arrays = {}
    for array in piece.iter("DataArray"):
        raw = base64.b64decode(array.text, validate=True)
        assert int.from_bytes(raw[:8], "little") == len(raw) - 8, path
        values = numpy.frombuffer(raw[8:], TYPES[array.get("type")])
        components = int(array.get("NumberOfComponents"))
        arrays[array.get("Name")] = values if components == 1 else values.reshape(
            (-1, components))
    assert len(piece.findall("Points/DataArray")) == 1, path
    return arrays, int(piece.get("NumberOfPoints")), int(piece.get("NumberOfVerts"))


def differences(result, folder):
    names = {entry.get("file"): float(entry.get("timestep"))
             for entry in xml.parse(folder / "colloids.pvd").getroot().iter("DataSet")}
    written = {path.name for path in folder.iterdir()}
    if written != {*names, "colloids.pvd", "grains.vtp"}:
        yield f"files {sorted(written)}, collection {sorted(names)}"
    colloids = result["particles/colloids"]
    if list(names.values()) != colloids["position/time"][()].tolist():
        yield f"times {list(names.values())}"
    shown = 0
    for frame, name in enumerate(names):
        found, points, vertices = arrays_of(folder / name)
        rows = [place for place, one in enumerate(colloids["id/value"][frame])
                if one != -1 and colloids["state/value"][frame][place] != 0]
        shown += len(rows)
        wanted = {key: colloids[f"{key}/value"][frame][rows]
                  for key in ("position", "velocity", "id", "state", "diameter")}
        wanted["connectivity"] = numpy.arange(len(rows))
        wanted["offsets"] = numpy.arange(len(rows)) + 1
        if (points, vertices) != (len(rows), len(rows)) or set(found) != set(wanted):
            yield f"{name}: {points} points, {vertices} vertices, arrays {sorted(found)}"
            continue
        for key, values in wanted.items():
            if found[key].tobytes() != numpy.ascontiguousarray(values).tobytes():
                yield f"{name}: {key} is {found[key]}, should be {values}"
    if shown == 0:
        yield "no colloid in any frame"
    grains, points, _ = arrays_of(folder / "grains.vtp")
    for key in ("position", "diameter"):
        if points == 0 or not numpy.array_equal(grains[key], result["particles/grains"][key]):
            yield f"grains.vtp: {key} is {grains[key]}"


def main(result, folder):
    with h5py.File(result, "r") as file:
        found = list(differences(file, pathlib.Path(folder)))
    print("\n".join(found))
    return bool(found)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
