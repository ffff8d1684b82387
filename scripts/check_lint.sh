#!/usr/bin/env bash
# clang-tidy on the sources of both programs, in parallel; its findings are errors.
# One file takes seconds, so a file is checked again only when it or a header changed.
set -eu
cd "$(dirname "$0")/.."
cache=build/ci/lint
mkdir -p "$cache"
headers=$(git ls-files -z '*.h' .clang-tidy | xargs -0 cat | sha1sum | cut -d' ' -f1)
export cache headers

check_one() {
  local stamp
  stamp="$cache/$(cat "$1" <(echo "$headers") | sha1sum | cut -d' ' -f1)"
  [ -e "$stamp" ] || { clang-tidy-14 --quiet -p build/ci "$1" 2>/dev/null && touch "$stamp"; }
}
export -f check_one
git ls-files -z 'solver/src/*.cpp' 'orchestrator/src/*.cpp' | xargs -0 -r -n 1 -P "$(nproc)" bash -c 'check_one "$0"'
