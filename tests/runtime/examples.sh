#!/usr/bin/env bash
# The short examples of the runtimes: those in GLSL ES and HLSL, with runtime/poisson_tiles_gpu.h, are compiled by
# glslang, and what comes out of HLSL is checked by spirv-val where that is there; the one in JavaScript prints what the
# one in C++ prints, and finds what runtime/test_vectors.csv says. The one in WGSL: wgsl.sh. Exit status 77: glslang or node is missing.
#
# Usage: examples.sh RUNTIME_FOLDER C_EXAMPLE
set -euo pipefail
runtime=$1 c_example=$2

command -v glslangValidator >/dev/null && command -v node >/dev/null || { echo 'needs glslang and node'; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

sed "/^\/\/! poisson_tiles_gpu.h/r $runtime/poisson_tiles_gpu.h" "$runtime/examples/disks.frag" >"$folder/disks.frag"
grep -q '^void main' "$folder/disks.frag" && grep -q 'ptiles_nearest_point(PTILES_BUFFER' "$folder/disks.frag"
glslangValidator "$folder/disks.frag"

glslangValidator -D -V -S comp -e place_points -I"$runtime" -o "$folder/instances.spv" "$runtime/examples/instances.hlsl"
[[ -s $folder/instances.spv ]]
! command -v spirv-val >/dev/null || spirv-val "$folder/instances.spv"

for arguments in 'corner-c3-n64-r075 -1.5 0.25 2 1' 'corner-c4-n64-r085 1000 -77 1 1 0.3' 'sphere-c2-n128-r075 0 0 1 1'; do
    read -r set window <<<"$arguments"
    file=$runtime/tile_sets/$set.ptiles
    # shellcheck disable=SC2086 # numbers
    "$c_example" "$file" $window | grep -v '^#' >"$folder/expected"
    # shellcheck disable=SC2086
    node "$runtime/examples/points.js" "$file" $window >"$folder/printed"
    [[ $(wc -l <"$folder/expected") -gt 15 ]]
    diff "$folder/expected" <(awk '!/^#/ { printf "%.9g %.9g %.9g\n", $1, $2, $3 }' "$folder/printed")
done

node "$(dirname "$0")/test_vectors.js" "$runtime"
