#!/usr/bin/env bash
# clang-tidy on the sources of both programs, in parallel; its findings are errors.
# One file takes seconds, so a file is checked again only when it or a header changed.
set -eu
cd "$(dirname "$0")/.."
cache=build/ci/lint
mkdir -p "$cache"
headers=$(git ls-files -z '*.h' .clang-tidy | xargs -0 cat | sha1sum | cut -d' ' -f1)
export cache headers

# Sources of the tier transient are checked like the others, 5 to 10 s each, but headers of
# OpenFOAM are no C++ to clang (attributes where the standard has none): what it says of them
# does not count, what it says of our files does.
tidy() {
  case "$1" in
    */tiers/transient/*)
      ! clang-tidy-14 --quiet --extra-arg=-ferror-limit=0 -p build/ci "$1" 2>/dev/null |
        grep -A 3 -E "^$PWD/.*: (fatal )?(error|warning): " ;;
    *) clang-tidy-14 --quiet -p build/ci "$1" 2>/dev/null ;;
  esac
}

check_one() {
  local stamp
  stamp="$cache/$(cat "$1" <(echo "$headers") | sha1sum | cut -d' ' -f1)"
  [ -e "$stamp" ] || { tidy "$1" && touch "$stamp"; }
}
export -f tidy check_one
git ls-files -z 'solver/src/*.cpp' 'orchestrator/src/*.cpp' | xargs -0 -r -n 1 -P "$(nproc)" bash -c 'check_one "$0"'
