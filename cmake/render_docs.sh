#!/usr/bin/env bash
# render_docs.sh FOLDER: the pages and the API as HTML, in FOLDER/html. Fails on a warning of Doxygen, and on a public
# member of the front door (trivium/trivium.hpp and what it includes) that is not documented.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
mathjax=/usr/share/javascript/mathjax # of Debian's libjs-mathjax
type -P doxygen >/dev/null || { echo 'doxygen is not installed'; exit 0; }
[[ -d $mathjax ]] || { echo 'libjs-mathjax is not installed'; exit 0; }
mkdir -p "$1"
# the check of the front door; Doxygen must write something: XML, which is removed
headers=$(sed -n 's|^#include "\(.*\)"|\1|p' trivium/trivium.hpp)
{
  cat docs/Doxyfile
  printf '%s\n' "INPUT = trivium/trivium.hpp ${headers//$'\n'/ }" "OUTPUT_DIRECTORY = \"$1/front_door\"" \
    'USE_MDFILE_AS_MAINPAGE =' 'EXTRACT_ALL = NO' 'WARN_IF_UNDOCUMENTED = YES' 'WARN_NO_PARAMDOC = NO' \
    'GENERATE_HTML = NO' 'GENERATE_XML = YES'
} | doxygen -
rm -r "$1/front_door"
# the pages in the order of their contents
pages=$(sed -n 's|.*\](\([a-z_]*\.md\)).*|docs/\1|p' docs/README.md)
{ cat docs/Doxyfile; echo "OUTPUT_DIRECTORY = \"$1\""; } | sed "s|^INPUT = |&README.md docs/README.md ${pages//$'\n'/ } |" | doxygen -
# what renders formulas, without a network
mkdir -p "$1/html/mathjax/jax/output" "$1/html/mathjax/fonts/HTML-CSS/TeX"
cp -rL $mathjax/{MathJax.js,config,extensions} "$1/html/mathjax"
cp -rL $mathjax/jax/{element,input} "$1/html/mathjax/jax"
cp -rL $mathjax/jax/output/HTML-CSS "$1/html/mathjax/jax/output"
cp -rL $mathjax/fonts/HTML-CSS/TeX/woff "$1/html/mathjax/fonts/HTML-CSS/TeX"
