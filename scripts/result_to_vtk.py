#!/usr/bin/python3
"""Writes a result for ParaView.

    result_to_vtk.py RESULT.h5 FOLDER

FOLDER/colloids.pvd    the frames in time; open this one
FOLDER/colloids_*.vtp  one frame each: a point per colloid with id, state, diameter, velocity
FOLDER/grains.vtp      the grains: a point each, with diameter

SI units.  In ParaView, the representation "Point Gaussian" or the filter "Glyph" (sphere,
scaled by diameter, factor 1) shows points as spheres.  state: 1 mobile, 2 bonded,
3 retained, 4 traversed, 5 delayed.
"""
import base64
import pathlib
import struct
import sys

import h5py
import numpy

VTK_TYPES = {"float64": "Float64", "int64": "Int64", "int8": "Int8"}


def data_array(name, values):
    """An array of numbers, [n] or [n][3]: its size in bytes and the bytes, in base64.
    (As text it would break off at the first NaN, which VTK cannot parse.)"""
    values = numpy.ascontiguousarray(values)
    components = 1 if values.ndim == 1 else values.shape[1]
    raw = values.astype(values.dtype.newbyteorder("<")).tobytes()
    text = base64.b64encode(struct.pack("<Q", len(raw)) + raw).decode()
    return (f'<DataArray type="{VTK_TYPES[values.dtype.name]}" Name="{name}" '
            f'NumberOfComponents="{components}" format="binary">{text}</DataArray>')


def write_points(path, points, arrays):
    """A VTK XML PolyData file of one vertex per point."""
    count = len(points)
    point_data = "\n".join(data_array(name, values) for name, values in arrays.items())
    path.write_text(f"""<?xml version="1.0"?>
<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<PolyData>
<Piece NumberOfPoints="{count}" NumberOfVerts="{count}" NumberOfLines="0" \
NumberOfStrips="0" NumberOfPolys="0">
<PointData Scalars="diameter">
{point_data}
</PointData>
<Points>
{data_array("position", points)}
</Points>
<Verts>
{data_array("connectivity", numpy.arange(count))}
{data_array("offsets", numpy.arange(1, count + 1))}
</Verts>
</Piece>
</PolyData>
</VTKFile>
""")


def write_frame(path, colloids, frame):
    """The colloids that are there: places in use, but for the state absent."""
    state = colloids["state/value"]
    absent = h5py.check_enum_dtype(state.dtype)["absent"]
    there = (colloids["id/value"][frame] >= 0) & (state[frame] != absent)
    arrays = {name: colloids[f"{name}/value"][frame][there]
              for name in ("velocity", "id", "state", "diameter")}
    write_points(path, colloids["position/value"][frame][there], arrays)


def write_collection(path, times, names):
    entries = "\n".join(f'<DataSet timestep="{time!r}" part="0" file="{name}"/>'
                        for time, name in zip(times, names))
    path.write_text(f"""<?xml version="1.0"?>
<VTKFile type="Collection" version="1.0" byte_order="LittleEndian">
<Collection>
{entries}
</Collection>
</VTKFile>
""")


def convert(result, folder):
    with h5py.File(result, "r") as file:
        if file.attrs.get("complete", 0) != 1:
            raise ValueError("is not complete")
        folder.mkdir(parents=True, exist_ok=True)
        grains = file["particles/grains"]
        write_points(folder / "grains.vtp", grains["position"][()],
                     {"diameter": grains["diameter"][()]})
        colloids = file["particles/colloids"]
        times = colloids["position/time"][()].tolist()
        names = [f"colloids_{frame:06d}.vtp" for frame in range(len(times))]
        for frame, name in enumerate(names):
            write_frame(folder / name, colloids, frame)
        write_collection(folder / "colloids.pvd", times, names)
        return len(times)


def main(arguments):
    if len(arguments) != 2:
        print(__doc__.split("\n\n")[1].strip(), file=sys.stderr)
        return 2
    result, folder = arguments[0], pathlib.Path(arguments[1])
    try:
        count = convert(result, folder)
    except (OSError, KeyError, ValueError) as error:
        print(f"result_to_vtk.py: {result}: {error}", file=sys.stderr)
        return 2
    print(f"{count} frames: open {folder / 'colloids.pvd'} in ParaView")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
