# What a task of an array does with each of its lines.  poreclog writes `list`, `keeper`,
# `per_task`, `seconds` and `seconds_to_stop` above.
#
# A task that Slurm begins again (its node was lost, or somebody requeued it) leaves the
# attempt it had begun alone, because that may still run where nobody sees it, and begins
# another.  Endings that were written without a task say "stopped":"asked", with no blank:
# they are never gone on with.

stopped=
trap 'stopped=yes' TERM INT QUIT
restarts=${SLURM_RESTART_COUNT:-0}
job=${SLURM_ARRAY_JOB_ID}_${SLURM_ARRAY_TASK_ID}.$restarts
if [ "$restarts" -gt 10 ]; then
  echo "task $SLURM_ARRAY_TASK_ID: begun $restarts times again, given up" >&2
  exit 1
fi

attempt() {
  realisation=${1%/*}
  folder=$1
  if [ -e "$1/ending.json" ] || [ -e "$1/lock" ]; then
    [ "$restarts" -gt 0 ] || return
    for result in "$realisation"/attempt-*/result.h5; do
      [ -e "$result" ] && return
    done
    if [ -e "$1/ending.json" ]; then
      grep -q '"stopped": "asked"' "$1/ending.json" || return
    fi
    number=2
    while folder=$realisation/attempt-$(printf %03d $number) && ! mkdir "$folder"; do
      [ "$number" -lt 999 ] || return
      number=$((number + 1))
    done 2>/dev/null
    cp "$1/command" "$folder/command"
  fi
  "$keeper" "$folder" "$seconds" "$seconds_to_stop" --job "$job" -- \
    sh -c "exec $(cat "$folder/command")"
}

first=$((SLURM_ARRAY_TASK_ID * per_task + 1))
line=$first
while [ "$line" -lt $((first + per_task)) ] && [ -z "$stopped" ]; do
  folder=$(sed -n "${line}{p;q;}" "$list")
  if [ -z "$folder" ]; then
    [ -r "$list" ] || exit 1
    break  # the last task has fewer
  fi
  attempt "$folder"
  line=$((line + 1))
done
exit 0
