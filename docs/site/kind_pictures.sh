#!/usr/bin/env bash
# Makes the pictures on the pages of kinds of work, docs/kinds/pictures, by the examples that these pages show.
#
#   docs/site/kind_pictures.sh PROGRAM OUT     OUT: a folder for the results
set -euo pipefail

kinds=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../kinds
out=$2
mkdir -p "$kinds/pictures"
"$1" run "$kinds/examples.toml" --out "$out" --quiet
while read -r page folder picture; do
  files=("$out"/$folder) # labels are part of some names
  cp "${files[0]}/$picture" "$kinds/pictures/$page.${picture##*.}"
done <"$kinds/pictures.txt"
