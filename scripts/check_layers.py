"""Fail if an #include in solver/src or orchestrator/src points against the arrows of the
tables in README.md, or if those tables differ from the ones here.

A folder with a row of its own is a module, also inside another's; a program's main.cpp may
include any module but those of other programs.  Headers of OpenFOAM and LIGGGHTS are included
by the sources of tiers/transient and by nothing else; of its headers by those named foam*
alone, which such sources share."""
import pathlib
import re
import sys

SOLVER = {
    "core": [],
    "scene": ["core"],
    "physics": ["core"],
    "flow": ["core"],
    "particles": ["core", "physics"],
    "observe": ["core", "scene", "flow"],
    "io": ["core", "scene"],
    "tiers": ["core", "scene", "physics", "flow", "particles", "observe", "io"],
    "tiers/transient": ["core", "scene", "physics", "flow", "particles", "observe", "io",
                        "tiers"],
    "commands": ["core", "scene", "physics", "flow", "particles", "observe", "io", "tiers"],
}
ORCHESTRATOR = {
    "base": [],
    "campaign": ["base"],
    "store": ["base", "campaign"],
    "execute": ["attempt", "base", "campaign"],
    "ingest": ["base", "campaign", "store"],
    "attempt": [],
    "statistics": [],
    "report": ["base", "campaign", "store", "ingest", "statistics"],
    "commands": ["base", "campaign", "store", "execute", "ingest", "statistics", "report"],
}
INCLUDE = re.compile(r'^\s*#\s*include\s*"([a-z_/]+)/\w+\.h"')
# OpenFOAM's headers end in .H; of LIGGGHTS', those without which nothing can be done.
FOREIGN = re.compile(r'^\s*#\s*include\s*[<"](\S+\.H|liggghts/\S+|'
                     r'(lammps|library\w*|atom(_vec\w*)?|fix\w*|pair\w*|modify|update|'
                     r'style_\w+)\.h)[>"]')
HAS_FOREIGN = "tiers/transient"
ROW = re.compile(r"^\| ([\w/]+) \| [^|]+ \| ([\w, /]*?) ?\|$", re.MULTILINE)

top = pathlib.Path(__file__).resolve().parent.parent
bad = []


def module_of(folder, modules):
    """The innermost module that the folder, relative to src, lies in."""
    while folder not in modules and "/" in folder:
        folder = folder.rpartition("/")[0]
    return folder


def check_includes(root, may_use):
    for path in sorted(root.glob("*/**/*.[hc]*")):
        here = module_of(path.relative_to(root).parent.as_posix(), may_use)
        allowed = {here, *may_use.get(here, [])}
        if path.name == "main.cpp":
            allowed |= {module for module in may_use if "/" not in module}
        for number, line in enumerate(path.read_text().splitlines(), 1):
            match = INCLUDE.match(line)
            points_up = match and module_of(match.group(1), may_use) not in allowed
            shared = path.suffix != ".h" or path.name.startswith("foam")
            foreign = FOREIGN.match(line) and not (here == HAS_FOREIGN and shared)
            if points_up or foreign:
                bad.append(f"{path.relative_to(top)}:{number}: {line.strip()}")


check_includes(top / "solver/src", SOLVER)
check_includes(top / "orchestrator/src", ORCHESTRATOR)
tables = (top / "README.md").read_text().split("| may include |")[1:]
written = [{module: re.findall(r"[\w/]+", uses)
            for module, uses in ROW.findall(table.partition("\n\n")[0])} for table in tables]
for program, may_use, found in zip(["solver", "orchestrator"], [SOLVER, ORCHESTRATOR],
                                   [*written, {}, {}]):
    if found != may_use:
        bad.append(f"README.md: the table of {program}/src says {found}, here it is {may_use}")
print("\n".join(bad))
sys.exit(bool(bad))
