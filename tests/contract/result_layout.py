"""Compares a result file with schemas/result.md, in both directions, and with the values
that were meant to be in it.

    result_layout.py RESULT.h5 schemas/result.md VALUES.json

VALUES.json: {"/series/time_s": [...], "/@t1_s": ...}, numbers with all digits, so that equal
means equal; null for NaN; enumerated values by name.  It must speak of every attribute and
dataset.  Prints one line per difference.
"""
import json
import math
import pathlib
import re
import sys

import h5py
import numpy

ANY = "*"


def documented(text, heading):
    """Rows of the table under a heading: path -> the other cells."""
    section = text.split(f"## {heading}\n")[1].split("\n## ")[0]
    rows = [re.split(r" \| ", line.strip("| \n")) for line in section.splitlines()
            if line.startswith("| /")]
    return {row[0]: row[1:] for row in rows}


def type_of(dtype):
    names = h5py.check_enum_dtype(dtype)
    if names == {"FALSE": 0, "TRUE": 1} or dtype == bool:
        return "bool"
    if names is not None:
        assert dtype.itemsize == 1
        return "enum " + ", ".join(sorted(names, key=names.get))
    info = h5py.check_string_dtype(dtype)
    if info is not None:
        return "string" if info.encoding == "utf-8" else f"string in {info.encoding}"
    return dtype.name


def shape_matches(written, shape, lengths):
    """Whether `shape` is as documented; letters must mean the same length everywhere."""
    names = [] if written == "scalar" else written.split(", ")
    if len(names) != len(shape):
        return False
    return all(length == (int(name) if name.isdigit() else lengths.setdefault(name, length))
               for name, length in zip(names, shape))


def plain(value):
    """As in VALUES.json."""
    if isinstance(value, numpy.ndarray):
        return [plain(one) for one in value]
    if isinstance(value, bytes):
        return value.decode()
    if isinstance(value, (float, numpy.floating)):
        return None if math.isnan(value) else float(value)
    if isinstance(value, (bool, numpy.bool_)):
        return bool(value)
    return int(value) if isinstance(value, (int, numpy.integer)) else value


def words(dataset, value):
    """Enumerated values by name."""
    names = h5py.check_enum_dtype(dataset.dtype)
    if names is None or value.dtype == bool:
        return value
    return numpy.vectorize({number: name for name, number in names.items()}.get,
                           otypes=[object])(value)


def found(file):
    """All attributes and datasets of the file, but for unit and description."""
    attributes, datasets = {}, {}

    def visit(path, thing):
        if isinstance(thing, h5py.Dataset):
            datasets[path] = thing
            return
        for name in thing.attrs:
            attributes[f"{path}@{name}"] = thing.attrs.get_id(name), thing.attrs[name]
        for name in thing:
            visit(f"{path.rstrip('/')}/{name}", thing[name])

    visit("/", file)
    return attributes, datasets


def compare(file, text, values):
    differences = []
    lengths = {}
    attributes, datasets = found(file)
    want_attributes = documented(text, "Attributes")
    want_datasets = documented(text, "Datasets")

    def both(kind, here, there, here_name):
        differences.extend(f"{kind} {path} only in {here_name}"
                           for path in sorted(set(here) - set(there)))

    open_ended = {p[:-1] for p in want_attributes if p.endswith("@" + ANY)}
    named = {p: a for p, a in attributes.items() if p.split("@")[0] + "@" not in open_ended}
    for path, (identity, _) in attributes.items():
        if path not in named and type_of(identity.dtype) != "float64":
            differences.append(f"{path}: is {type_of(identity.dtype)}, documented float64")
    both("attribute", named, want_attributes, "the file")
    both("attribute", [p for p in want_attributes if not p.endswith(ANY)], named,
         "the document")
    both("dataset", datasets, want_datasets, "the file")
    both("dataset", want_datasets, datasets, "the document")

    for path, (kind, shape, *_) in want_attributes.items():
        if path in named:
            identity, _ = named[path]
            if type_of(identity.dtype) != kind:
                differences.append(f"{path}: is {type_of(identity.dtype)}, documented {kind}")
            if not shape_matches(shape, identity.shape, lengths):
                differences.append(f"{path}: has shape {identity.shape}, documented {shape}")
    for path, (kind, shape, unit, meaning) in want_datasets.items():
        if path not in datasets:
            continue
        dataset = datasets[path]
        if type_of(dataset.dtype) != kind:
            differences.append(f"{path}: is {type_of(dataset.dtype)}, documented {kind}")
        if not shape_matches(shape, dataset.shape, lengths):
            differences.append(f"{path}: has shape {dataset.shape}, documented {shape}; {lengths}")
        has = {name: plain(dataset.attrs[name]) for name in dataset.attrs}
        if has != {"unit": unit, "description": meaning}:
            differences.append(f"{path}: says {has}, documented {unit}, {meaning}")

    both("value of", {**attributes, **datasets}, values, "the file")
    for path, value in values.items():
        if path in attributes:
            is_there = plain(attributes[path][1])
        elif path in datasets:
            is_there = plain(words(datasets[path], datasets[path][()]))
        else:
            is_there = "nothing"
        if is_there != value:
            differences.append(f"{path}: is {is_there}, should be {value}")
    version = re.search(r"^Version (\d+),", text, re.MULTILINE).group(1)
    if str(file.attrs["schema_version"]) != version:
        differences.append(f"schema_version {file.attrs['schema_version']}, document {version}")
    return differences


def storage(file):
    """Each element of the colloids shares step and time with position; what is large is
    packed, what is small is not (a page of index for a line of numbers)."""
    colloids = file["particles/colloids"]
    for name in ("velocity", "id", "diameter", "state"):
        for one in ("step", "time"):
            if colloids[name][one] != colloids["position"][one]:
                yield f"{name}/{one} is not the one of position"
    packed = {path for path, one in found(file)[1].items()
              if one.chunks and one.shuffle and one.compression == "gzip"}
    large = {path for path, one in found(file)[1].items()
             if one.shape and one.size * one.dtype.itemsize >= 4096}
    if packed != large:
        yield f"packed {sorted(packed)}, large {sorted(large)}"
    if "/particles/colloids/position/value" not in large or "/series/time_s" in large:
        yield "neither large nor small datasets to try this on"


def main(result, document, values):
    with h5py.File(result, "r") as file:
        differences = compare(file, pathlib.Path(document).read_text(),
                              json.loads(pathlib.Path(values).read_text()))
        differences += storage(file)
    print("\n".join(differences))
    return bool(differences)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
