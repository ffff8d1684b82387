"""What the scripts that write results/evidence share: run, say where from, draw."""
import csv
import datetime
import json
import math
import os
import pathlib
import shlex
import statistics
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
SOLVER = ROOT / "build/release/solver/poreclog-solve"


def add_common_options(parser, folder):
    parser.add_argument("--solver", type=pathlib.Path, default=SOLVER,
                        help="the program poreclog-solve (default: that of the release preset)")
    parser.add_argument("--output", type=pathlib.Path,
                        default=ROOT / "results/evidence" / folder,
                        help="folder to write into (default: results/evidence/%s)" % folder)


def finished(command, **options):
    """What `command` printed (`.stdout`, `.stderr`); ends this script if it fails."""
    command = [str(word) for word in command]
    done = subprocess.run(command, capture_output=True, text=True, **options)
    if done.returncode != 0:
        sys.exit(f"{shlex.join(command)}\nended with {done.returncode}: {done.stderr.strip()}")
    return done


def measure(solver, scene, *options):
    """The JSON object that `poreclog-solve measure` prints."""
    return json.loads(finished([solver, "measure", scene, *options]).stdout)


def provenance(solver):
    """Lines for a README: command, program, machine, date.  Call it before measuring, so
    that the load is that of other programs."""
    version = subprocess.run([str(solver), "--version"], capture_output=True, text=True,
                             check=True).stdout.strip()
    # Not where things lie on this machine.
    options = [pathlib.Path(a).name if a.startswith("/") else a for a in sys.argv[1:]]
    command = shlex.join(["python3", "scripts/" + pathlib.Path(sys.argv[0]).name, *options])
    model = "unknown processor"
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            model = line.split(":", 1)[1].strip()
            break
    memory = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE") / 2**30
    load = os.getloadavg()[0]
    quiet = ("quiet" if load < 0.5 else
             "busy with other programs: times are too long")
    date = datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%d %H:%M UTC")
    return [f"- command: `{command}`",
            f"- program: {version}",
            f"- machine: {model}, {os.cpu_count()} cores, {memory:.0f} GiB; one thread used",
            f"- load before the run: {load:.2f} ({quiet})",
            f"- date: {date}"]


def commit(solver):
    """The commit that `solver` was built from."""
    return finished([solver, "--version"]).stdout.split("commit ")[1].split(",")[0]


def write_rows(path, rows, columns=None):
    """Dictionaries as they are, into a CSV file; `columns`: default those of the first."""
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, columns or rows[0].keys(), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def text(attribute):
    """An attribute of a result file: fixed and variable strings alike."""
    return attribute.decode() if isinstance(attribute, bytes) else str(attribute)


def interval(values):
    """Mean and half of the 95 % t-interval; nan where there are fewer than two."""
    quantile = {1: 12.706, 2: 4.303, 3: 3.182, 4: 2.776, 5: 2.571, 6: 2.447, 7: 2.365,
                8: 2.306, 9: 2.262}
    n = len(values)
    if n == 0:
        return math.nan, math.nan
    mean = statistics.fmean(values)
    return mean, (math.nan if n < 2 else
                  quantile[n - 1] * statistics.stdev(values) / math.sqrt(n))


def write_csv(path, columns, rows):
    """Each column is (name, format)."""
    lines = [",".join(name for name, _ in columns)]
    for row in rows:
        lines.append(",".join(format(row[name], spec) for name, spec in columns))
    path.write_text("\n".join(lines) + "\n")


def gnuplot(script):
    subprocess.run(["gnuplot"], input=script, text=True, check=True)
