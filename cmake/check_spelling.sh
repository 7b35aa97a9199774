#!/usr/bin/env bash
# check_spelling.sh SOURCES PAGE...: every word of the pages' prose is an English word, and every name in backticks occurs in
# the sources or in a block of the page; or they stand in docs/words.txt. Names of files and addresses of links are left out.
set -euo pipefail
sources=$1
shift
type -P aspell >/dev/null || { echo 'aspell is not installed'; exit 0; }
failed=0
# prose PAGE: a paragraph without its comments on one line
prose() {
  awk '/^```/ { code = !code; next } !code' "$1" | awk 'BEGIN { RS = "" } { gsub("\n", " "); print }' |
    sed -E 's/<!--[^>]*-->//g'
}
words_in() { grep -ohE '[A-Za-z_][A-Za-z0-9_]*' "$@" | sort -u; }
names=$(cd "$sources" && find . \( -name build -o -name .git \) -prune -o \( -name '*.[hc]pp' -o -name '*.json' \
  -o -name '*.cmake' -o -name '*.in' -o -name CMakeLists.txt -o -name '*.sh' -o -name run -o -name '*.csv' \) -exec cat {} + |
  words_in -)
for page in "$@"; do
  unknown=$(prose "$page" | grep -oE '`[^`]+`' | words_in - |
    grep -vxFf <(printf '%s\n' "$names"; awk '/^```/ { code = !code } code' "$page" | words_in -; cat "$sources/docs/words.txt") || true)
  [[ -z $unknown ]] || { printf '%s: names that nothing has: %s\n' "$(basename "$page")" "$(tr '\n' ' ' <<<"$unknown")"; failed=1; }
  unknown=$(prose "$page" |
    sed -E 's/`[^`]*`//g; s/\$\$[^$]*\$\$//g; s/\]\([^)]*\)//g; s/[A-Za-z_/]+\.(md|cff)//g; s/[A-Za-z_]*[_0-9][A-Za-z_0-9^.]*//g' |
    aspell list --lang=en_GB --encoding=utf-8 | sort -u | grep -vxFf "$sources/docs/words.txt" || true)
  [[ -z $unknown ]] || { printf '%s: unknown words: %s\n' "$(basename "$page")" "$(tr '\n' ' ' <<<"$unknown")"; failed=1; }
done
exit $failed
