#!/usr/bin/env python3
"""Prints "key path" of every source that scripts/check_lint.sh checks.

The key is a hash of all that decides what clang-tidy says of the file: the file, the
headers of this project it includes (directly or not), the list of checks, and the
program's version.  Headers of the system are not in it: they are those of Debian 12."""
import hashlib
import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROGRAMS = ["solver/src", "orchestrator/src"]
INCLUDE = re.compile(rb'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)


def included(path):
    """Headers of the project that a file includes; what is made by the build is not there."""
    for name in INCLUDE.findall(path.read_bytes()):
        for folder in [path.parent, *(ROOT / p for p in PROGRAMS)]:
            header = folder / name.decode()
            if header.is_file():
                yield header.resolve()
                break


def with_headers(source):
    found = {source}
    to_read = [source]
    while to_read:
        for header in included(to_read.pop()):
            if header not in found:
                found.add(header)
                to_read.append(header)
    return sorted(found)


def main():
    version = subprocess.run(["clang-tidy-14", "--version"], capture_output=True, check=True)
    number = re.search(rb"version (\S+)", version.stdout).group(1)
    checks = (ROOT / ".clang-tidy").read_bytes()
    listed = subprocess.run(["git", "ls-files", *(f"{p}/*.cpp" for p in PROGRAMS)], cwd=ROOT,
                            capture_output=True, check=True, text=True)
    for name in listed.stdout.split():
        key = hashlib.sha1(number + checks)
        for path in with_headers((ROOT / name).resolve()):
            key.update(str(path.relative_to(ROOT)).encode())
            key.update(path.read_bytes())
        print(key.hexdigest(), name)


if __name__ == "__main__":
    main()
