# The part of docs_pages.sh that compares numbers in sentences with their sources.
# A number in prose with an exponent, a decimal point or two digits must stand in a block above it or in the next block
# below. If it does not, a comment behind its paragraph, list or table says where it comes from:
#   <!-- numbers: 36615 1.4e-9 of the output -->      the output above has these numbers, rounded to the digits given here
#   <!-- numbers: 3.2 of `COMMAND` -->                the same for a command, in this order; $sources are the sources
#   <!-- numbers: 1e-8 of FILE, WORDS -->             a line of FILE has WORDS and exactly this number (of a CSV file: rounded)
#   <!-- numbers: 1989 not compared -->               literature, examples, measurements that no cheap command repeats

# The numbers of a text, and their comparison, for awk.
numbers_of='
  function numbers(text, list,   n, before) {
    while (match(text, /[0-9][ \047]000/)) text = substr(text, 1, RSTART) substr(text, RSTART + 2) # 20 000
    while (match(text, /[0-9]+(\.[0-9]+)?([eE][-+]?[0-9]+)?/)) {
      before = substr(text, 1, RSTART - 1)
      if (before !~ /([A-Za-z_.0-9]|[A-Za-z]-)$/) list[++n] = (before ~ /-$/ ? "-" : "") substr(text, RSTART, RLENGTH)
      text = substr(text, RSTART + RLENGTH)
    }
    return n + 0
  }
  # one name for all notations of a number, without its sign
  function name_of(x) { sub(/^-/, "", x); return sprintf("%.15g", x) }
  # whether y is x, rounded to the digits of x unless exact; an x without a sign stands for both signs. Numbers below 1e-9 are
  # rounding errors: in sentences they may differ by a factor of 10.
  function is(x, y, exact,   digits, format) {
    if (x !~ /^-/) sub(/^-/, "", y)
    if (exact || x + 0 == 0 || y + 0 == 0) return x + 0 == y + 0
    if (x < 1e-9 && x > -1e-9) return y / x <= 10 && x / y <= 10 && x / y > 0
    digits = x
    sub(/[eE].*/, "", digits); gsub(/[-.]/, "", digits); sub(/^0+/, "", digits)
    format = "%." (length(digits) - 1) "e"
    return sprintf(format, x) == sprintf(format, y)
  }'

# check_numbers COMMENT: the source that a comment names has its numbers.
check_numbers() {
  local list source exact=1 x
  [[ $1 =~ ^'<!-- numbers: '([-0-9.e ]+)' '(of .+|not compared)' -->'$ ]] || { problem "no source in the comment"; return; }
  list=${BASH_REMATCH[1]} source=${BASH_REMATCH[2]#of }
  case $source in
    'not compared') return ;;
    'the output') exact=0; cp shown.out source.out ;;
    \`*\`) exact=0; bash -c "${source:1:-1}" >source.out 2>&1 </dev/null || problem "failed: $source" ;;
    *', '*) [[ ${source%%,*} != *.csv ]] || exact=0
            grep -F -- "${source#*, }" "$sources/${source%%, *}" >source.out || problem "there is no line: $source" ;;
    *) problem "a file needs words that its line has: $source"; return ;;
  esac
  if [[ $source == \`* ]]; then
    awk -v all="$list" "$numbers_of"'
      BEGIN { n = split(all, x, / +/); next_one = 1 }
      { m = numbers($0, list); for (k = 1; k <= m; ++k) if (next_one <= n && is(x[next_one], list[k], 0)) ++next_one }
      END { exit next_one <= n }' source.out || problem "the numbers $list are not, in this order, in: $source"
    return
  fi
  for x in $list; do
    awk -v x="$x" -v exact=$exact "$numbers_of"'
      { for (k = numbers($0, list); k > 0; --k) if (is(x, list[k], exact)) found = 1 }
      END { exit !found }' source.out || problem "the number $x is not in: $source"
  done
}

# check_sentences: each number in a sentence is compared, and the numbers of a comment stand in the paragraph before it, in
# the same order.
# `100 u kappa`, the unit roundoff of double, and the names of compilers and systems need no comment.
check_sentences() {
  local text
  while IFS=: read -r number text; do problem "$text"; done < <(awk "$numbers_of"'
    # the text of a line that is not between two marks (backticks or $$), which may stand on different lines
    function outside(line, mark,   k, n, part, kept) {
      n = split(line, part, mark)
      for (k = 1; k <= n; ++k) {
        if (!inside[mark]) kept = kept " " part[k]
        if (k < n) inside[mark] = !inside[mark]
      }
      return kept
    }
    function new_paragraph() { split("", inside); split("", paragraph); length_of = rows = 0; start = NR }
    # whether the numbers of the comment, list[1] to list[n], are between two places of the paragraph
    function in_order(from, to, ordered,   j, k) {
      for (k = 1; k <= n; ++k) {
        for (j = from; j <= to && sequence[j] != name_of(list[k]); ++j) {}
        if (j > to) return 0
        if (ordered) from = j + 1
      }
      return 1
    }
    function complain(   k) {
      for (k = 1; k <= open; ++k) if (!(name[k] in shown)) print line[k] ":nothing compares the number " number[k]
      open = 0
    }
    in_block ? /^(```|<!-- end -->)$/ : /^(```|<!-- output of: )/ {
      if (in_block) complain()
      in_block = !in_block
      new_paragraph()
      next
    }
    in_block { for (k = numbers($0, list); k > 0; --k) shown[name_of(list[k])]; next }
    /^<!-- numbers: / {
      sub(/ (of|not) .*/, "")
      n = numbers($0, list)
      for (k = 1; k <= n; ++k) {
        x = name_of(list[k])
        if (!(x in paragraph)) print NR ":the number " list[k] " is not in the paragraph above"
        for (j = 1; j <= open; ++j) if (line[j] >= start && name[j] == x) name[j] = "compared"
      }
      # a line that has all of them must have them in this order, such as a row of a table; else the paragraph
      is_in_order = in_order(1, length_of, 1)
      for (r = 1; r <= rows; ++r) {
        last = r < rows ? first[r + 1] - 1 : length_of
        if (in_order(first[r], last, 0)) is_in_order = is_in_order && in_order(first[r], last, 1)
      }
      if (!is_in_order) print NR ":the paragraph above does not have these numbers in this order"
      next
    }
    /^ *$/ { new_paragraph(); next }
    {
      gsub(/<!--.*-->/, ""); gsub(/\]\([^)]*\)/, "]")
      text = outside(outside($0, "`"), "[$][$]")
      gsub(/100 u kappa|1\.1e-16|Debian 12|(C|g|clang)\+\+ ?[0-9]+|x86-64/, "", text)
      n = numbers(text, list)
      if (n) first[++rows] = length_of + 1
      for (k = 1; k <= n; ++k) {
        x = name_of(list[k])
        paragraph[x]; sequence[++length_of] = x
        if (x in shown || list[k] !~ /[.e]|[0-9][0-9]/) continue
        line[++open] = NR; name[open] = x; number[open] = list[k]
      }
    }
    BEGIN { shown["compared"] }
    END { complain() }' "$page")
}
