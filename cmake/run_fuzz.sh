#!/bin/sh
# run_fuzz.sh FUZZER SCENES WORK [SECONDS]: runs a fuzzer of scenes from the files of the folder SCENES, keeps what it
# learns in WORK, and fails if it finds an input that breaks a law. Inputs have at most 20 000 bytes, since short ones are
# tried faster. Two scenes are longer; they are cut, and so malformed. An input takes milliseconds and megabytes; 10 s or 2 GiB
# are findings.
set -eu
fuzzer=$1 scenes=$2 work=$3 seconds=${4:-60}
mkdir -p "$work/seeds/catalogue" "$work/seeds/wellformed" "$work/seeds/malformed" "$work/corpus" "$work/findings"
cp "$scenes"/catalogue/*.json "$work/seeds/catalogue"
cp "$scenes"/testing/wellformed/*.json "$work/seeds/wellformed"
cp "$scenes"/testing/malformed/*.json "$work/seeds/malformed"
exec "$fuzzer" -max_total_time="$seconds" -max_len=20000 -timeout=10 -rss_limit_mb=2048 -print_final_stats=1 \
  -dict="$scenes/format/scene.dict" -artifact_prefix="$work/findings/" "$work/corpus" "$work/seeds"
