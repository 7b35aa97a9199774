#!/usr/bin/env bash
# render_docs.sh FOLDER: the pages and the API as HTML, in FOLDER/html. Fails on a warning of Doxygen, on a public
# member of the front door (trivium/trivium.hpp and what it includes) that is not documented, and in all headers on a
# class, concept, function, type or constant that is not documented; members of classes beyond the front door are free.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
mathjax=/usr/share/javascript/mathjax # of Debian's libjs-mathjax
type -P doxygen >/dev/null || { echo 'doxygen is not installed'; exit 0; }
[[ -d $mathjax ]] || { echo 'libjs-mathjax is not installed'; exit 0; }
mkdir -p "$1"
write_xml() { # SETTING...: all public entities as XML
  {
    cat docs/Doxyfile
    printf '%s\n' "OUTPUT_DIRECTORY = \"$1\"" 'USE_MDFILE_AS_MAINPAGE =' 'EXTRACT_ALL = NO' 'GENERATE_HTML = NO' \
      'GENERATE_XML = YES' "${@:2}"
  } | doxygen -
}
# the front door
headers=$(sed -n 's|^#include "\(.*\)"|\1|p' trivium/trivium.hpp)
write_xml "$1/checked" "INPUT = trivium/trivium.hpp ${headers//$'\n'/ }" 'WARN_IF_UNDOCUMENTED = YES' 'WARN_NO_PARAMDOC = NO'
rm -r "$1/checked"
# all headers: classes and concepts (one XML file each), members of namespaces and files. Doxygen 1.9.4 does not warn about
# concepts and empty classes, so the check reads its XML.
write_xml "$1/checked"
awk '/<compounddef/ { is_public = !/prot="private"/ }
     /<memberdef/ { in_member = 1 } /<\/memberdef>/ { in_member = 0 }
     /<briefdescription>/ { getline; is_empty = /<\/briefdescription>/ }
     /<location / && is_public && in_member == (FILENAME ~ /\/namespace|_8hpp/) {
       if (is_empty) undocumented[$0] = $2 ", " $3; else ++documented }
     END { for (line in undocumented) print "not documented: " undocumented[line]
           exit length(undocumented) || !documented }' "$1"/checked/xml/{class,concept,namespace,struct,*_8hpp}*.xml | sort >&2
rm -r "$1/checked"
# the pages in the order of their contents
pages=$(sed -n 's|.*\](\([a-z_]*\.md\)).*|docs/\1|p' docs/README.md)
{ cat docs/Doxyfile; echo "OUTPUT_DIRECTORY = \"$1\""; } | sed "s|^INPUT = |&README.md docs/README.md ${pages//$'\n'/ } |" | doxygen -
# what renders formulas, without a network
mkdir -p "$1/html/mathjax/jax/output" "$1/html/mathjax/fonts/HTML-CSS/TeX"
cp -rL $mathjax/{MathJax.js,config,extensions} "$1/html/mathjax"
cp -rL $mathjax/jax/{element,input} "$1/html/mathjax/jax"
cp -rL $mathjax/jax/output/HTML-CSS "$1/html/mathjax/jax/output"
cp -rL $mathjax/fonts/HTML-CSS/TeX/woff "$1/html/mathjax/fonts/HTML-CSS/TeX"
