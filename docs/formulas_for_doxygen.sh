#!/bin/sh
# Markdown for Doxygen: displayed formulas between $$, and blocks without a second word.
awk '/^```/ { code = !code; print $1; next }
     !code { while (sub(/\$\$/, inside ? "\\f]" : "\\f[")) inside = !inside }
     { print }' "$1"
