#!/usr/bin/env bash
# Fuzzes the reader and the way from reader to wheel path for so many seconds each: packaging/fuzz.sh [SECONDS]
# Both run at once. What they find stays in build/fuzz/findings; a finding that was mended belongs into
# tests/fuzz/findings, where a test reads it again. The corpus grown so far stays in build/fuzz/corpus-*.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
seconds=${1-600}
build=$root/build/fuzz

"$root/packaging/set-up.sh" build test
cmake -S "$root" --preset fuzz
cmake --build "$build"

mkdir -p "$build/findings"
pids=()
for target in reader wheel_path; do
  mkdir -p "$build/corpus-$target"
  cp "$root"/tests/fuzz/corpus/* "$root"/tests/fuzz/findings/* "$build/corpus-$target/"
  # Sanitizers make it thirty times slower: a minute is two seconds.
  "$build/bin/fuzz_$target" "$build/corpus-$target" "-dict=$root/tests/fuzz/dxf.dict" \
    "-artifact_prefix=$build/findings/$target-" "-max_total_time=$seconds" -max_len=4096 -len_control=20 \
    -timeout=60 -rss_limit_mb=2048 -print_final_stats=1 >"$build/fuzz_$target.log" 2>&1 </dev/null &
  pids+=($!)
done
failed=0
for pid in "${pids[@]}"; do
  wait "$pid" || failed=1
done
for target in reader wheel_path; do
  echo "fuzz_$target:"
  grep -E 'ERROR|Broken promise|Test unit written|number_of_executed_units|cov:' "$build/fuzz_$target.log" | tail -n 4
done
exit $failed
