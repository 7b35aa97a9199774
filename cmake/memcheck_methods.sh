#!/usr/bin/env bash
# memcheck_methods.sh TRIVIUM
# No method decides on memory that was never written: valgrind's memcheck watches a short run by every method in
# r-omega, r-p and r-epsilon (rattle: r-omega).
set -euo pipefail
trivium=$1 failed=0
methods=$("$trivium" list | sed -n 's/^integrators *//p' | tr -d ,)
for method in $methods; do
  for formulation in r-omega r-p r-epsilon; do
    [[ $method != rattle* || $formulation == r-omega ]] || continue
    steps=(--rtol 1e-7)
    [[ $method != rattle4 ]] || steps=(--step 1e-3)
    valgrind -q --error-exitcode=9 "$trivium" simulate spatial_slider_crank --t-end 0.05 --integrator "$method" \
      --formulation "$formulation" "${steps[@]}" >/dev/null || { echo "$method, $formulation: exit code $?"; failed=1; }
  done
done
exit $failed
