"""Run the marked commands of README.md and compare their output with what is quoted.

A ```sh block is run if the line above it is a mark:

    <!-- check: -->                    every line of the output counts
    <!-- check: varies "work units" -->  numbers of lines that hold this text may differ

The next fenced block is the output that the README promises.  A line `...` in it stands for
any number of lines.  Other lines must follow in that order; numbers may differ by 0.1 %, and
so may numbers that are rounding errors beside the largest one on their line.

Usage: python3 scripts/check_readme.py [--build build/release]
The commands' `build/release` is replaced by that folder.
"""
import argparse
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
EXAMPLE = re.compile(r"^<!-- check:([^\n]*)-->\n```sh\n(.*?)^```\n+```\w*\n(.*?)^```$",
                     re.MULTILINE | re.DOTALL)
MARK = re.compile(r"^<!-- check:", re.MULTILINE)
NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
RELATIVE = 1e-3   # compilers and processors round differently
NOISE = 1e-6      # of the largest number on a line: a rounding error
SECONDS = 300


def same(quoted, printed, varies):
    """Are the two lines the same, but for what may differ?"""
    if NUMBER.sub("#", quoted) != NUMBER.sub("#", printed):
        return False
    if any(text in quoted for text in varies):
        return True
    pairs = [(float(a), float(b))
             for a, b in zip(NUMBER.findall(quoted), NUMBER.findall(printed))]
    scale = max((abs(a) for a, _ in pairs), default=0.0)
    return all(abs(a - b) <= RELATIVE * abs(a) or max(abs(a), abs(b)) <= NOISE * scale
               for a, b in pairs)


def missing_line(quoted, printed, varies):
    """The first quoted line that the output lacks, or None."""
    at = 0
    skipping = False
    for line in quoted:
        if line.strip() == "...":
            skipping = True
            continue
        while at < len(printed) and skipping and not same(line, printed[at], varies):
            at += 1
        if at == len(printed) or not same(line, printed[at], varies):
            return line
        at += 1
        skipping = False
    if at < len(printed) and not skipping:
        return "(end of the output)"
    return None


def check(mark, commands, quoted, build):
    varies = re.findall(r'"([^"]*)"', mark)
    done = subprocess.run(["bash", "-euo", "pipefail", "-c",
                           commands.replace("build/release", build)],
                          cwd=ROOT, capture_output=True, text=True, timeout=SECONDS)
    if done.returncode != 0:
        return f"ended with {done.returncode}: {done.stderr.strip()}"
    line = missing_line(quoted.splitlines(), done.stdout.splitlines(), varies)
    if line is None:
        return None
    return f"does not print, where README.md quotes it: '{line}'"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", default="build/release",
                        help="where the programs are, relative to the repository")
    options = parser.parse_args()
    text = (ROOT / "README.md").read_text()
    examples = EXAMPLE.findall(text)
    bad = []
    if not examples or len(examples) != len(MARK.findall(text)):
        bad.append("README.md: a mark `<!-- check: -->` is not followed by a ```sh block and "
                   "its output")
    for mark, commands, quoted in examples:
        problem = check(mark, commands, quoted, options.build)
        if problem:
            bad.append(f"README.md: {commands.strip()}\n  {problem}")
    print("\n".join(bad), end="\n" if bad else "")
    sys.exit(bool(bad))


if __name__ == "__main__":
    main()
