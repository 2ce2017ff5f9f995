#!/usr/bin/env bash
# campaign.sh ROOT READER SECONDS: fuzzes one reader for that much CPU time and adds a line to ROOT/build/fuzz/campaigns.tsv: when,
# the reader, seconds of CPU time, inputs tried, edges and features covered, and the exit status (0: nothing found). What was
# learnt stays in ROOT/build/fuzz/corpus; an input that broke the reader is left in ROOT/build/fuzz.
set -euo pipefail
root=$1 reader=$2 seconds=$3

cd "$root/build/fuzz"
mkdir -p "corpus/$reader"
seeds=("$root/tests/fuzz/seeds/$reader"/*)
[ "$reader" != scenario ] || mapfile -O "${#seeds[@]}" -t seeds < <(find "$root/scenarios" -name '*.toml')
(IFS=,; echo "${seeds[*]}") >"$reader.seeds"

# libFuzzer counts time by the clock: on a busy machine it is started again until the reader has had its share.
status=0 cpu_s=0 tried=0
while [ "$status" -eq 0 ] && [ "$cpu_s" -lt "$seconds" ]; do
    "tests/fuzz_$reader" -max_total_time=$((seconds - cpu_s)) -timeout=60 -rss_limit_mb=2048 -max_len=8192 \
        -print_final_stats=1 -artifact_prefix="$reader-" -seed_inputs=@"$reader.seeds" "corpus/$reader" 2>&1 |
        tee "$reader.log" | sed "s/^/$reader: /" || status=${PIPESTATUS[0]}
    times >"$reader.times"  # not in a pipe: there it would be those of another shell
    cpu_s=$(tail -1 "$reader.times" | awk -F'[ms ]+' '{ printf "%d", 60 * ($1 + $3) + $2 + $4 }')
    tried=$((tried + $(sed -n 's/^stat::number_of_executed_units: *//p' "$reader.log" | grep . || echo 0)))
done
covered=$(sed -n 's/.* cov: \([0-9]*\) ft: \([0-9]*\) .*/\1 edges, \2 features/p' "$reader.log" | tail -1)
printf '%s\t%s\t%s s\t%s inputs\t%s\texit %s\n' "$(date -u +%FT%TZ)" "$reader" "$cpu_s" "$tried" "$covered" "$status" >>campaigns.tsv
awk -F'\t' -v reader="$reader" '$2 == reader { cpu_s += $3; tried += $4; runs += 1 }
    END { printf "%s: in all %d s of CPU time and %d inputs, in %d campaigns\n", reader, cpu_s, tried, runs }' campaigns.tsv
exit "$status"
