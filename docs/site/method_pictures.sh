#!/usr/bin/env bash
# Makes the pictures of points and spectra on the pages of methods, docs/methods/pictures, by the configs beside this file.
#
#   docs/site/method_pictures.sh PROGRAM OUT     OUT: a folder for the results
set -euo pipefail

here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
program=$1
out=$2
pictures=$here/../methods/pictures
mkdir -p "$pictures"
for config in methods methods-3d; do
  "$program" run "$here/$config.toml" --out "$out/$config" --quiet
  for sampler in $(sed -n 's/^sampler = "\(.*\)"$/\1/p' "$here/$config.toml"); do
    folders=("$out/$config/$sampler"*/) # parameters follow the name
    cp "${folders[0]}points.svg" "$pictures/$sampler-points.svg"
    cp "${folders[0]}spectrum-small.png" "$pictures/$sampler-spectrum.png"
  done
done
