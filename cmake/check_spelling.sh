#!/usr/bin/env bash
# check_spelling.sh SOURCES PAGE...: every word of the pages' prose is an English word or stands in docs/words.txt. Code, names
# of files and addresses of links are left out.
set -euo pipefail
sources=$1
shift
type -P aspell >/dev/null || { echo 'aspell is not installed'; exit 0; }
failed=0
for page in "$@"; do
  unknown=$(awk '/^```/ { code = !code; next } !code' "$page" |
    awk 'BEGIN { RS = "" } { gsub("\n", " "); print }' |
    sed -E 's/<!--[^>]*-->//g; s/`[^`]*`//g; s/\$\$[^$]*\$\$//g; s/\]\([^)]*\)//g; s/[A-Za-z_/]+\.(md|cff)//g; s/[A-Za-z_]*[_0-9][A-Za-z_0-9^.]*//g' |
    aspell list --lang=en_GB --encoding=utf-8 | sort -u | grep -vxFf "$sources/docs/words.txt" || true)
  [[ -z $unknown ]] || { printf '%s: unknown words: %s\n' "$(basename "$page")" "$(tr '\n' ' ' <<<"$unknown")"; failed=1; }
done
exit $failed
