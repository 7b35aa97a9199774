#!/bin/sh
# The program trivium ($TRIVIUM), but for its exit code: a defect that hard_cases must find.
"$TRIVIUM" "$@"
exit 0
