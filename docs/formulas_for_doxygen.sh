#!/bin/sh
# Markdown for Doxygen: displayed formulas between $$, blocks without a second word, and two forms that Doxygen 1.9.4 does
# not know, bold code and links to files that are no pages.
awk '/^```/ { code = !code; print $1; next }
     !code { while (sub(/\$\$/, inside ? "\\f]" : "\\f[")) inside = !inside }
     !code { while (match($0, /\*\*(`[^`]*`,? ?)+\*\*/))
               $0 = substr($0, 1, RSTART - 1) "<b>" substr($0, RSTART + 2, RLENGTH - 4) "</b>" substr($0, RSTART + RLENGTH)
             sub(/\[LICENSE\]\(LICENSE\)/, "<a href=\"LICENSE\">LICENSE</a>")
             sub(/\[CITATION.cff\]\(CITATION.cff\)/, "<a href=\"CITATION.cff\">CITATION.cff</a>") }
     { print }' "$1"
