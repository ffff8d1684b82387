#!/usr/bin/env bash
# Runs the benchmarks of the release build and writes results/evidence/bench.  On a quiet
# machine; about four minutes.
set -eu
cd "$(dirname "$0")/.."
out=results/evidence/bench
mkdir -p "$out"
build/release/tests/bench/bench_stokes --benchmark_min_time=0.2 >"$out/stokes.txt"
# The re-solve is asked for in work units, which scatter by a tenth from run to run.
build/release/tests/bench/bench_stokes --benchmark_min_time=0.2 --benchmark_repetitions=7 \
  --benchmark_report_aggregates_only=true \
  --benchmark_filter='after_retention/across:(40|80)' >"$out/resolve.txt"
build/release/tests/bench/bench_critical_diameter >"$out/critical_diameter.txt"
{
  cat <<'TEXT'
# Benchmarks

**Question.** What do a residual evaluation, a smoothing sweep, a multigrid cycle, a solve from
zero, a solve after one retention and the critical diameter cost?

`stokes.txt` and `critical_diameter.txt` are what the programs of tests/bench print; `resolve.txt` is
the re-solve after one retention, seven times (mean, median, standard deviation). The counters are
explained at the top of their sources. Times are processor time; a work unit is the cost of one
residual evaluation in the same run. 40 cells across are 96,000 cells.

TEXT
  echo "Command: \`bash scripts/bench.sh\` (release build), commit $(git rev-parse --short HEAD),"
  echo "$(date -u +%F), $(lscpu | sed -n 's/^Model name: *//p'), $(nproc) cores, load before the run"
  echo "$(cut -d' ' -f1 /proc/loadavg)."
} >"$out/README.md"
