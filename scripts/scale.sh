#!/usr/bin/env bash
# What the orchestrator itself costs, and how it grows: results/evidence/scale/README.md.
# Usage: [PRESET=release] scripts/scale.sh [REALISATIONS] [JOBS]   (defaults 100000, 1000)
#   - JOBS realisations of a solver that only writes its file, beside GNU parallel --joblog
#     running the same commands (if it is installed: apt-get install parallel);
#   - REALISATIONS results of 500 output times in one database: rate, size, and time and
#     memory of each question that has a name, statistics, report and dry run.
set -eu
cd "$(dirname "$0")/.."
realisations=${1:-100000}
jobs=${2:-1000}
preset=${PRESET:-release}
cmake --preset "$preset" >/dev/null
cmake --build --preset "$preset" --target poreclog fake_solver -j "$(nproc)" >/dev/null
build=$PWD/build/$preset
poreclog=$build/orchestrator/poreclog
export PORECLOG_SOLVER=$build/tests/anomaly/fake_solver FAKE_ROWS=500 PORECLOG_NO_REPORT=1
out=$PWD/results/evidence/scale
mkdir -p "$out"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

campaign() {
  echo "{\"campaign\": \"$1\", \"scene\": {}, \"realisations\": $2, \"master_seed\": 1," \
       "\"limits\": {\"workers\": 2}}" >"$1.json"
}
field() { sed -n "s/^ *\"$2\": \([0-9.]*\),*$/\1/p" "$1"; }
now() { date +%s.%N; }
ratio() { awk "BEGIN {printf \"$1\", $2}"; }
# measure COMMAND...: "elapsed s | CPU s | MB" of it; what it prints goes to ./answer
measure() {
  python3 - "$@" <<'END'
import resource, subprocess, sys, time
def cpu(used):
    return used.ru_utime + used.ru_stime
# A python3 that is a script in front of the real one has children of its own before us.
before = resource.getrusage(resource.RUSAGE_CHILDREN)
begin = time.monotonic()
with open("answer", "wb") as answer:
    subprocess.run(sys.argv[1:], stdout=answer, check=True)
seconds = time.monotonic() - begin
used = resource.getrusage(resource.RUSAGE_CHILDREN)
print(f"{seconds:.2f} | {cpu(used) - cpu(before):.2f} | {used.ru_maxrss / 1024:.0f}")
END
}
load=$(cut -d' ' -f1 /proc/loadavg)

# 1. The cost of running one, three times.  ext4 searches long for places of new folders while it
# remembers deleted ones, half a minute: what was deleted before is not our cost.
campaign jobs "$jobs"
sleep 40
cpu=""
for round in 1 2 3; do
  begin=$(now)
  "$poreclog" run jobs.json --json --database "$round.sqlite" --runs "runs$round" >run.json 2>/dev/null
  wall=$(ratio %.3f "1000*($(now)-$begin)/$jobs")
  cpu="$cpu${cpu:+, }$(ratio %.3f "1000*$(field run.json orchestrator_cpu_s)/$jobs")"
done
memory=$(field run.json orchestrator_memory_kB)
beside="not installed"
if command -v parallel >/dev/null; then
  mkdir p
  seq "$jobs" | sed "s|.*|$PORECLOG_SOLVER run runs3/jobs/p0000-one_way/scene.json -o p/&.h5 --seed &|" >lines
  begin=$(now)
  { time -p parallel -j 2 --joblog p.log <lines; } 2>times
  beside="$(ratio %.3f "1000*($(now)-$begin)/$jobs") ms elapsed, $(awk -v n="$jobs" \
    '/user|sys/ {s += $2} END {printf "%.3f", 1000*s/n}' times) ms of CPU with its jobs"
  { time -p sh lines; } 2>times
  beside="$beside (the jobs alone: $(awk -v n="$jobs" '/user|sys/ {s += $2} END {printf "%.3f", 1000*s/n}' times) ms)"
fi

# 2. Many in one database: results written beforehand, then ingested.
campaign many "$realisations"
timeout -s INT 3 "$poreclog" run many.json >/dev/null 2>&1 || true   # writes plan and rows
rm -rf results/runs/many/p0000-one_way/0* results/poreclog.sqlite*
"$poreclog" repair >/dev/null
"$poreclog" query "SELECT idx, seed FROM v_realisation ORDER BY idx" --csv |
  tr -d '\r' | sed 1d | tr , ' ' >seeds
"$PORECLOG_SOLVER" fill results/runs/many/p0000-one_way/scene.json \
  results/runs/many/p0000-one_way <seeds
begin=$(now)
"$poreclog" resume many --json >many.json.out 2>/dev/null
seconds=$(ratio %.1f "$(now)-$begin")
size=$(stat -c %s results/poreclog.sqlite)
{
  echo "# What the orchestrator costs"
  echo
  echo "Running $jobs realisations of a solver that only writes its file, 2 at once:"
  echo
  echo "| | |"
  echo "|---|---|"
  echo "| CPU of the orchestrator (getrusage of itself, from start to end, without its children), per realisation, three runs | $cpu ms |"
  echo "| elapsed, with the solver, per realisation, of the last | $wall ms |"
  echo "| memory of the orchestrator | $memory kB |"
  echo "| GNU parallel --joblog, the same commands without ingestion | $beside |"
  echo
  echo "$realisations results of 500 output times, about 40 retained colloids each, ingested"
  echo "into one database:"
  echo
  echo "| | |"
  echo "|---|---|"
  echo "| ingested | $(field many.json.out ingested) |"
  echo "| time | $seconds s, $(ratio %.0f "$realisations/$seconds") per second |"
  echo "| CPU, per realisation | $(ratio %.3f "1000*$(field many.json.out orchestrator_cpu_s)/$realisations") ms |"
  echo "| memory of the orchestrator | $(field many.json.out orchestrator_memory_kB) kB |"
  echo "| database | $(ratio %.0f "$size/1e6") MB, $(ratio %.0f "$size/$realisations") bytes per realisation |"
  echo
  echo "Questions to that database, with the program's start and the printing of the answer"
  echo "(as CSV, into a file), and what else reads all of it; memory counts from the 14 MB of"
  echo "the script that measures it:"
  echo
  echo "| question | rows | elapsed s | CPU s | memory MB |"
  echo "|---|---|---|---|---|"
  ask() { # NAME WORDS...
    local name=$1 times
    shift
    times=$(measure "$poreclog" query many "$@" --csv)
    echo "| $name | $(($(wc -l <answer) - 1)) | $times |"
  }
  for name in progress points clogging curves layers costs failures incidents programs realisations; do
    ask "$name" "$name"
  done
  ask "v_series of one realisation" \
    "SELECT * FROM v_series WHERE campaign = :campaign AND point = 0 AND idx = $((realisations / 23))"
  echo "| status | | $(measure "$poreclog" status many --json) |"
  echo "| resume --dry-run | | $(measure "$poreclog" resume many --dry-run --json) |"
  echo "| statistics | | $(measure "$poreclog" statistics many --json) |"
  echo "| report | | $(measure "$poreclog" report many --output report) |"
  echo
  echo "- command: \`PRESET=$preset scripts/scale.sh $realisations $jobs\`"
  echo "- program: $("$poreclog" --version)"
  echo "- machine: $(sed -n 's/^model name.*: //p' /proc/cpuinfo | head -n 1), $(nproc) cores"
  echo "- load before the run: $load (times are too long if other programs were running)"
  echo "- date: $(date -u '+%Y-%m-%d %H:%M UTC')"
} >"$out/README.md"
cat "$out/README.md"
