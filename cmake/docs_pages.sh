#!/usr/bin/env bash
# docs_pages.sh BIN SOURCES WORK [--update] PAGE...: runs the commands that Markdown pages show, with the programs of the
# folder BIN, in an empty folder below WORK, and compares what they print with what the pages show. With --update the pages
# take the new output. In a page:
#   <!-- file: NAME -->            the block that follows is a file, which later commands of the page find
#   ```sh                          each line is a command. Those of `runs_elsewhere` are not run; only the names of their
#                                  commands, presets and test labels are checked. `# exit code 2` behind a command demands
#                                  this exit code. For a pipe it is the code of the first part that fails.
#   ```text                        the output (stdout and stderr) of the commands before it; `text times`: with CPU times
#   ```json, cpp, cmake            files, programs that are compiled elsewhere, targets that must exist; no other language
#   `./run ...`                    a command in a sentence or a table is run too, for three seconds at most; one with words
#                                  in capital letters is checked for its options alone
#   <!-- output of: COMMAND -->    what follows, up to the next <!-- end -->, is the command's output, as Markdown
# Words must be equal. Numbers must agree to 1 %; the last digits depend on the processor. Numbers below 1e-9 are rounding:
# they may differ by a factor of 1000. In `text times` decimal fractions, which may be times of microseconds, may
# differ by a factor of 100; numbers with an exponent, which are errors of integration, by a factor of 3. Numbers of tests
# (#12: and Start 12:), and how many dots stand behind a test's name, are not compared. Options named in a page must be
# options of a program.
# Numbers in sentences: docs_numbers.sh.
set -euo pipefail
bin=$(realpath "$1") sources=$(realpath "$2") work=$(mkdir -p "$3" && realpath "$3")
shift 3
update=no
[[ $1 != --update ]] || { update=yes; shift; }
# commands of `run` that install, build, measure or typeset, and the tools of the build
runs_elsewhere='^(./run test$|(./run (paper|accept|times|bench|docs)|cmake/docs_pages.sh|cmake|ctest|clang-format|git)( |$))'
export PATH=$bin:$PATH sources
source "$(dirname "${BASH_SOURCE[0]}")/docs_numbers.sh"

# The commands of `run`, without its installing and building. Tests run from a folder of their own.
make_run() {
  cat >"$1/run" <<RUN
#!/usr/bin/env bash
((\$#)) || { lambda_invariance && simbody_reference; exit; }
[[ ! -x $bin/\$1 ]] || exec "\$@"
if [[ \$1 == test ]]; then
  mkdir -p tests && echo 'subdirs("$(dirname "$bin")")' >tests/CTestTestfile.cmake
  exec ctest --test-dir tests "\${@:2}"
fi
exec trivium "\$@"
RUN
  chmod +x "$1/run"
}

# same EXPECTED ACTUAL KIND: whether the two agree; shows the first lines that do not.
same() {
  awk -v kind="$3" '
    function is_number(x) { return x ~ /^[-+]?[0-9]+(\.[0-9]*)?([eE][-+]?[0-9]+)?$/ }
    function size(x) { return x < 0 ? -x : x }
    # numbers below `least` count as least: ten roundings; errors that are rounding; milliseconds
    function within(factor, a, b, least) {
      a = size(a) > least ? size(a) : least; b = size(b) > least ? size(b) : least
      return a <= factor * b && b <= factor * a
    }
    function agree(a, b) {
      if (a == b || (a b) ~ /^\.+$/) return 1
      if (!is_number(a) || !is_number(b)) return 0
      if (size(a) < 1e-9 && size(b) < 1e-9) return within(1000, a, b, 1e-15)
      if (kind == "times" && (a b) ~ /[eE]/) return within(3, a, b, 1e-9)
      if (kind == "times" && (a b) ~ /\./) return within(100, a, b, 1e-3)
      return size(a - b) <= 0.01 * (size(a) > size(b) ? size(a) : size(b))
    }
    function agree_in_words(x, y,   a, b, k, m) {
      # rules below table headings follow the width of the columns
      if (x ~ /^-+$/ && y ~ /^-+$/) return 1
      gsub(/(#|Start +)[0-9]+:/, "test", x); gsub(/(#|Start +)[0-9]+:/, "test", y)
      gsub(/[,;:()\[\]=\/%|]/, " & ", x); gsub(/[,;:()\[\]=\/%|]/, " & ", y)
      m = split(x, a, /[ \t]+/)
      if (m != split(y, b, /[ \t]+/)) return 0
      for (k = 1; k <= m; ++k) if (!agree(a[k], b[k])) return 0
      return 1
    }
    FNR == NR { expected[++lines] = $0; next }
    { actual[++printed] = $0 }
    END {
      for (k = 1; k <= lines || k <= printed; ++k)
        if (!agree_in_words(expected[k], actual[k])) {
          printf "  line %d shows     %s\n          it prints %s\n", k, expected[k], actual[k]
          if (++differing == 3) break
        }
      exit differing > 0
    }' "$1" "$2"
}

# has_option OPTION HELP: whether a help text names the option
has_option() { grep -qE -- "(^|[ ,])$1([ ,)]|$)" <<<"$2"; }

# options_exist COMMAND: each option of a command of this project is in its help; of those that build, in that of `run`.
options_exist() {
  local words option help
  read -ra words <<<"${1%%|*}"
  [[ ${words[0]} == ./run || ${words[0]} == trivium ]] || return 0
  [[ ${words[1]:-} ]] || return 0
  if [[ ${words[1]} == test ]]; then
    help=$(ctest --help)
  elif [[ $1 =~ $runs_elsewhere ]]; then
    help=$("$sources/run" --help)
  else
    help=$(./run "${words[1]}" --help 2>/dev/null) || { echo "  there is no command: $1"; return 1; }
  fi
  for option in $(grep -oE -- ' --?[A-Za-z][A-Za-z-]*' <<<" ${1%%|*}"); do
    has_option "$option" "$help" || { echo "  $option is no option of: $1"; return 1; }
  done
}

all_help=$(for p in "$bin"/*; do "$p" --help; done 2>/dev/null
           for c in $(trivium --help | sed '1,/^Subcommands:/d; s/^  *\([a-z]*\).*/\1/'); do trivium "$c" --help; done)
failed=0
problem() { printf '%s:%d: %s\n' "$page" "$number" "$1"; failed=1; }

read_page() {
  local line text='' state=prose fence='' kind='' block='' file='' generated='' option
  number=0
  : >shown.out
  while IFS= read -r line || [[ $line ]]; do
    number=$((number + 1))
    case $state in
      prose)
        text+=$line$'\n'
        if [[ $line =~ ^'<!-- file: '([A-Za-z0-9_.]+)' -->'$ ]]; then
          file=${BASH_REMATCH[1]}
        elif [[ $line =~ ^'<!-- output of: '(.*)' -->'$ ]]; then
          generated=${BASH_REMATCH[1]} block='' state=generated
        elif [[ $line == '```'* ]]; then
          fence=${line#'```'} kind=${fence#* } block='' state=block
          check_fence
        elif [[ $line =~ ^\ *(~~~|'```') ]]; then
          problem "a block begins with \`\`\` at the beginning of a line"
        elif [[ $line == '<!-- numbers:'* ]]; then
          check_numbers "$line"
        else
          for option in $(grep -oE -- '`--[a-z][a-z-]*' <<<"$line" | tr -d '`'); do
            has_option "$option" "$all_help" || problem "no program has the option $option"
          done
        fi
        ;;
      block)
        if [[ $line != '```' ]]; then
          block+=$line$'\n'
          continue
        fi
        state=prose
        if [[ $file ]]; then
          printf '%s' "$block" >"$file"
          file=''
        elif [[ $fence == sh ]]; then
          run_commands "$block"
        elif [[ $fence == cmake ]]; then
          for option in $(grep -oE 'trivium::[a-z_]+' <<<"$block"); do
            grep -rqE --include=CMakeLists.txt "$option( |\))" "$sources"/{cmake,examples} || problem "there is no target $option"
          done
          for option in $(grep -oE 'find_package\([a-zA-Z]+' <<<"$block"); do
            grep -rqF --include=CMakeLists.txt "$option" "$sources"/{cmake,examples} || problem "nothing calls $option)"
          done
        elif [[ $fence == text || $fence == "text times" ]]; then
          printf '%s' "$block" >expected.out
          if ! same expected.out shown.out "$kind" >difference.out; then
            [[ $update == yes ]] || { problem "the output is another"; cat difference.out; }
            block=$(<shown.out)$'\n'
          fi
          printf '%s' "$block" >shown.out # what sentences are compared with, so that they agree with the page
        fi
        text+=$block$line$'\n'
        ;;
      generated)
        if [[ $line != '<!-- end -->' ]]; then
          block+=$line$'\n'
          continue
        fi
        state=prose
        (cd "$sources" && bash -c "$generated") >shown.out || problem "failed: $generated"
        if [[ $(<shown.out) != "${block%$'\n'}" ]]; then
          [[ $update == yes ]] || problem "this is not the output of: $generated"
          block=$(<shown.out)$'\n'
        fi
        text+=$block$line$'\n'
        ;;
    esac
  done <"$page"
  [[ $state == prose ]] || problem "the last block does not end"
  run_inline_commands
  check_sentences
  if [[ $update == yes ]]; then printf '%s' "$text" >"$page"; fi
}

check_fence() {
  case $fence in
    sh | text | 'text times' | cpp | cmake) ;;
    json) [[ $file ]] || problem "a json block is a file: name it" ;;
    '') [[ $file || ! -s shown.out ]] || problem "the block behind commands is their output: text" ;;
    *) problem "no page has blocks of the kind $fence" ;;
  esac
}

# is_run_elsewhere COMMAND: whether a page's command is not run here; a command of `run`, a preset and a label must exist.
is_run_elsewhere() {
  local name
  [[ $1 =~ $runs_elsewhere ]] || return 1
  for name in $(grep -oE -- '--preset [a-z]+' <<<"$1" | cut -d' ' -f2); do
    grep -q "\"name\": \"$name\"" "$sources/CMakePresets.json" || problem "there is no preset $name"
  done
  for name in $(grep -oE -- '-L [a-z]+' <<<"$1" | cut -d' ' -f2); do
    grep -rqE --include=CMakeLists.txt --include='*.cmake' "LABELS \"?$name\b" "$sources" || problem "no test has the label $name"
  done
  [[ ! $1 =~ ^./run\ ([a-z]+) ]] || grep -qE "^#.*\./run ${BASH_REMATCH[1]}\b" "$sources/run" ||
    problem "run has no command ${BASH_REMATCH[1]}"
}

# The commands in sentences and tables of the page.
run_inline_commands() {
  local command status
  while IFS= read -r command; do
    [[ $command != './run COMMAND'* ]] || continue
    options_exist "$command" || problem "see above"
    ! is_run_elsewhere "$command" && [[ $command != './run test '* ]] || continue
    [[ ! $command =~ [A-Z][A-Z]|\.\.\. ]] || continue
    [[ ! $command =~ ^./run\ (solve|check|simulate|compare|generate)$ ]] || continue # a name in a sentence
    status=0
    timeout 3 bash -c "$command" >inline.out 2>&1 </dev/null || status=$?
    # 124: stopped by timeout while it ran, so its arguments are right; 1: a criterion failed, which is a valid answer
    ((status == 0 || status == 1 || status == 124)) || { problem "failed: $command"; tail -n 3 inline.out; }
  done < <(awk '/^```/ { code = !code; next } !code' "$page" | awk 'BEGIN { RS = "" } { gsub("\n", " "); print }' |
           grep -oE '`\./run [^`]*`' | tr -d '`' | sort -u)
}

run_commands() {
  local command status demanded
  : >shown.out
  while IFS= read -r command; do
    demanded=0
    [[ ! $command =~ '  # exit code '([0-9]+) ]] || demanded=${BASH_REMATCH[1]}
    command=$(sed 's/ *  #.*$//; s/ *$//' <<<"$command")
    [[ $command && $command != '#'* ]] || continue
    options_exist "$command" || { problem "see above"; continue; }
    ! is_run_elsewhere "$command" || continue
    # every part of a pipe must succeed; a pipe into head ends the program silently (141), also where SIGPIPE is
    # ignored outside
    status=0
    env --default-signal=PIPE bash -c "$command
      for code in \"\${PIPESTATUS[@]}\"; do ((code == 0 || code == 141)) || exit \$code; done" >>shown.out 2>&1 </dev/null ||
      status=$?
    ((status == demanded)) || { problem "failed: $command, exit code $status instead of $demanded"; tail -n 5 shown.out; }
  done < <(sed -e ':a' -e '/\\$/{N;s/\\\n *//;ba' -e '}' <<<"$1")
  sed -i 's/[ \t]*$//' shown.out
}

mapfile -t pages < <(realpath "$@")
for page in "${pages[@]}"; do
  folder=$work/$(basename "$(dirname "$page")")_$(basename "$page" .md) # pages of two folders may have one name
  rm -rf "$folder"
  mkdir -p "$folder"
  cd "$folder"
  make_run .
  read_page
done
exit $failed
