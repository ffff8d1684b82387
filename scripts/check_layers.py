"""Fail if an #include in solver/src or orchestrator/src points against the arrows of the
tables in README.md, or if those tables differ from the ones here."""
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
    "commands": ["core", "scene", "physics", "flow", "particles", "observe", "io", "tiers"],
}
ORCHESTRATOR = {
    "base": [],
    "campaign": ["base"],
    "store": ["base", "campaign"],
    "execute": ["base", "campaign"],
    "ingest": ["base", "campaign", "store"],
    "attempt": [],
    "statistics": [],
    "report": ["base", "campaign", "store", "ingest", "statistics"],
    "commands": ["base", "campaign", "store", "execute", "ingest", "statistics", "report"],
}
INCLUDE = re.compile(r'^\s*#\s*include\s*"([a-z_]+)/')
ROW = re.compile(r"^\| (\w+) \| [^|]+ \| ([\w, ]*?) ?\|$", re.MULTILINE)

top = pathlib.Path(__file__).resolve().parent.parent
bad = []


def check_includes(root, may_use):
    for path in sorted(root.glob("*/**/*.[hc]*")):
        here = path.relative_to(root).parts[0]
        for number, line in enumerate(path.read_text().splitlines(), 1):
            match = INCLUDE.match(line)
            if match and match.group(1) not in [here, *may_use.get(here, [])]:
                bad.append(f"{path.relative_to(top)}:{number}: {line.strip()}")


check_includes(top / "solver/src", SOLVER)
check_includes(top / "orchestrator/src", ORCHESTRATOR)
tables = (top / "README.md").read_text().split("| may include |")[1:]
written = [{module: re.findall(r"\w+", uses)
            for module, uses in ROW.findall(table.partition("\n\n")[0])} for table in tables]
for program, may_use, found in zip(["solver", "orchestrator"], [SOLVER, ORCHESTRATOR],
                                   [*written, {}, {}]):
    if found != may_use:
        bad.append(f"README.md: the table of {program}/src says {found}, here it is {may_use}")
print("\n".join(bad))
sys.exit(bool(bad))
