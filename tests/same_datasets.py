"""Whether two result files have the same datasets, bit for bit, and the same numbers in
/solver.  Usage: same_datasets.py A.h5 B.h5; prints what differs, exit code 1 if any."""
import sys

import h5py


def content(path):
    found = {}
    with h5py.File(path) as file:
        for name, value in file["solver"].attrs.items():
            found["solver@" + name] = repr(value)

        def visit(name, item):
            if isinstance(item, h5py.Dataset):
                value = item[()]
                text = value.tolist() if getattr(value, "dtype", None) == object else None
                found[name] = repr(text) if text is not None else \
                    value.tobytes() if hasattr(value, "tobytes") else value
        file.visititems(visit)
    return found


a, b = (content(path) for path in sys.argv[1:3])
different = sorted(name for name in a.keys() | b.keys() if a.get(name) != b.get(name))
print("\n".join(different))
sys.exit(1 if different or len(a) < 40 else 0)
