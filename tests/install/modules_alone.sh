#!/usr/bin/env bash
# Programs with one module each: `./lab` builds these, so each must link, with what CMake says that it stands on.
#
# modules_alone.sh SOURCE BUILD: BUILD has been built with all modules. Its libraries stand in for those of each program, of
# which only the lists of modules are compiled.
set -euo pipefail
source=$1
build=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# Libraries are where the program's own would be. Each module's program takes the place of the one before.
program=$folder/program
(cd "$build" && find . -name '*.a' -printf '%P\n' -o -path '*/poissonlab.dir/main.cpp.o' -printf '%P\n') >"$folder/made"
(cd "$build" && sed 's#/[^/]*$##' "$folder/made" | sort -u | (cd "$folder" && mkdir program && cd program && xargs mkdir -p))
while read -r file; do ln -s "$build/$file" "$program/$file"; done <"$folder/made"

# link_alone MODULE: prints what is undefined in the program with this module; status 1 if it does not link.
link_alone() {
  cmake -S "$source" -B "$program" -G Ninja -DCMAKE_BUILD_TYPE=Release "-DPOISSONLAB_MODULES=$1" >"$folder/configure.log" 2>&1
  ninja -C "$program" -t commands poissonlab >"$folder/commands"
  cd "$program"
  # The lists of modules and the files that stand in for modules, with the precompiled header of the build (as
  # position-independent code, which the build is for Python) or, where its options are others, without one.
  grep -E -- '-c [^ ]*/(lab_modules|lab_command_list)\.dir/[^ ]*$' "$folder/commands" |
    sed "s#-include $program/#-fPIC -include $build/#; s/-Winvalid-pch//" | bash -e
  grep -E -- ' -o poissonlab( |$)' "$folder/commands" | bash -e 2>&1
}

status=0
for module in methods own_methods results tiles other_tiles tilings regions distributions classes textures surfaces surface_textures surface_spectra geometry_tiles \
  large_sets particles point_formats processes reference space tile_measures zone_plate; do
  if ! (link_alone "$module") >"$folder/$module.out" 2>&1; then
    echo "the program with the module $module alone does not link:"
    grep -E 'undefined reference|multiple definition|error' "$folder/$module.out" | head -n 20
    status=1
  fi
done
exit $status
