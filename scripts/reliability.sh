#!/usr/bin/env bash
# Injures the orchestrator and records the counts: results/evidence/reliability/README.md.
# Usage: [PRESET=release] scripts/reliability.sh [KILLS]   (default 1000)
set -eu
cd "$(dirname "$0")/.."
kills=${1:-1000}
preset=${PRESET:-release}
cmake --preset "$preset" >/dev/null
cmake --build --preset "$preset" --target poreclog poreclog-solve fake_solver fake_clock \
  -j "$(nproc)" >/dev/null
build=$PWD/build/$preset
export PORECLOG=$build/orchestrator/poreclog FAKE_SOLVER=$build/tests/anomaly/fake_solver
export FAKE_CLOCK=$build/tests/anomaly/libfake_clock.so
out=results/evidence/reliability
mkdir -p "$out"
log=$(mktemp)
trap 'rm -f "$log"' EXIT

load=$(cut -d' ' -f1 /proc/loadavg)
KILLS=$kills python3 tests/anomaly/kill_test.py >"$log" 2>&1 || { cat "$log"; exit 1; }
counts=$(grep '^kills ' "$log")
KILLS=20 KILL_SCENE=campaigns/throat.scene.json FAKE_SOLVER=$build/solver/poreclog-solve \
  python3 tests/anomaly/kill_test.py >"$log" 2>&1 || { cat "$log"; exit 1; }
real=$(grep '^kills ' "$log")
python3 tests/anomaly/injury_test.py -v >"$log" 2>&1 || { cat "$log"; exit 1; }

{
  echo "# What is lost when the orchestrator is injured"
  echo
  echo "kill -9 of the orchestrator, of a solver, of a solver's keeper, or of all of them, at"
  echo "random moments of campaigns of 24 realisations; each campaign is resumed and its"
  echo "database compared with that of an undisturbed run (tests/anomaly/kill_test.py)."
  echo
  echo "    $counts"
  echo
  echo "The same with the real solver and the reference throat for a second, which goes on from"
  echo "checkpoints that it writes every tenth of a second:"
  echo
  echo "    $real"
  echo
  echo "Every other injury (tests/anomaly/injury_test.py), each with what must hold after it:"
  echo
  sed -n 's/^\(test_[a-z_]*\) (__main__\.\([A-Za-z]*\)\..*) \.\.\. \(.*\)$/\2 \1: \3/p' "$log" |
    sed 's/ test_/ /; s/_/ /g; s/^/- /'
  echo
  echo "- command: \`PRESET=$preset scripts/reliability.sh $kills\`"
  echo "- program: $("$PORECLOG" --version)"
  echo "- machine: $(sed -n 's/^model name.*: //p' /proc/cpuinfo | head -n 1), $(nproc) cores"
  echo "- load before the run: $load"
  echo "- date: $(date -u '+%Y-%m-%d %H:%M UTC')"
} >"$out/README.md"
cat "$out/README.md"
