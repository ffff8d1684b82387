"""Fail if an #include in solver/src points against the arrows drawn in README.md."""
import pathlib
import re
import sys

MAY_USE = {
    "core": [],
    "scene": ["core"],
    "physics": ["core"],
    "flow": ["core"],
    "particles": ["core", "physics"],
    "observe": ["core", "scene", "flow"],
    "io": ["core", "scene"],
    "tiers": ["core", "scene", "physics", "flow", "particles", "observe", "io"],
    "commands": ["core", "scene", "physics", "flow", "particles", "observe", "io", "tiers"],
}
INCLUDE = re.compile(r'^\s*#\s*include\s*"([a-z_]+)/')

root = pathlib.Path(__file__).resolve().parent.parent / "solver/src"
bad = []
for path in sorted(root.glob("*/**/*.[hc]*")):
    here = path.relative_to(root).parts[0]
    for number, line in enumerate(path.read_text().splitlines(), 1):
        match = INCLUDE.match(line)
        if match and match.group(1) not in [here, *MAY_USE.get(here, [])]:
            bad.append(f"{path.relative_to(root)}:{number}: {line.strip()}")
print("\n".join(bad))
sys.exit(bool(bad))
