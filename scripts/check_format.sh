#!/usr/bin/env bash
# Every C++ source is as clang-format 14 leaves it.
set -eu
cd "$(dirname "$0")/.."
git ls-files -z '*.cpp' '*.h' | xargs -0 -r clang-format-14 --dry-run --Werror
