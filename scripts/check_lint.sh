#!/usr/bin/env bash
# clang-tidy on the sources of both programs, in parallel; its findings are errors.
#   check_lint.sh            what has changed since it was last found clean
#   check_lint.sh --all      every file
#   check_lint.sh --record   the first, then writes down that all are clean now
# One file takes seconds, so a file is checked again only when something that decides the
# answer has changed (lint_keys.py): since this machine checked it, or since it was
# written down in scripts/lint_record.txt.  A record that is old, or merged wrongly, costs
# time and hides nothing: its keys are those of other contents.
set -eu
cd "$(dirname "$0")/.."
mode=${1-}
case "$mode" in
  "" | --all | --record) ;;
  *) echo "usage: check_lint.sh [--all | --record]" >&2; exit 2 ;;
esac
cache=build/ci/lint
record=scripts/lint_record.txt
mkdir -p "$cache"
keys=$(python3 scripts/lint_keys.py)
export cache

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

check_one() {  # "KEY PATH"
  tidy "${1#* }" && touch "$cache/${1%% *}"
}
export -f tidy check_one

while read -r key path; do
  if [ "$mode" = --all ] || { [ ! -e "$cache/$key" ] && ! grep -q "^$key " "$record"; }; then
    printf '%s\0' "$key $path"
  fi
done <<<"$keys" | xargs -0 -r -n 1 -P "$(nproc)" bash -c 'check_one "$0"'
[ "$mode" != --record ] || sort -k 2 <<<"$keys" >"$record"
