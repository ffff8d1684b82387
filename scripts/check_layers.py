"""Fail if an #include in solver/src points against the arrows of the table in README.md, or
if that table differs from the one here."""
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
ROW = re.compile(r"^\| (\w+) \| [^|]+ \| ([\w, ]*?) ?\|$", re.MULTILINE)

top = pathlib.Path(__file__).resolve().parent.parent
root = top / "solver/src"
bad = []
for path in sorted(root.glob("*/**/*.[hc]*")):
    here = path.relative_to(root).parts[0]
    for number, line in enumerate(path.read_text().splitlines(), 1):
        match = INCLUDE.match(line)
        if match and match.group(1) not in [here, *MAY_USE.get(here, [])]:
            bad.append(f"{path.relative_to(root)}:{number}: {line.strip()}")
table = (top / "README.md").read_text().partition("| may include |")[2].partition("\n\n")[0]
written = {module: re.findall(r"\w+", uses) for module, uses in ROW.findall(table)}
if written != MAY_USE:
    bad.append(f"README.md: the table of modules says {written}, here it is {MAY_USE}")
print("\n".join(bad))
sys.exit(bool(bad))
