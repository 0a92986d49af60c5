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

# link_alone MODULE: prints what is undefined in the program with this module; status 1 if it does not link.
link_alone() {
  local program=$folder/$1
  cmake -S "$source" -B "$program" -G Ninja -DCMAKE_BUILD_TYPE=Release "-DPOISSONLAB_MODULES=$1" >"$program.log" 2>&1
  (cd "$build" && find . -name '*.a' -o -path '*/poissonlab.dir/main.cpp.o') | while read -r file; do
    mkdir -p "$program/${file%/*}"
    ln -sf "$build/$file" "$program/$file"
  done
  ninja -C "$program" -t commands poissonlab >"$program.commands"
  cd "$program"
  # The lists of modules and the files that stand in for modules; precompiled headers are not there.
  grep -E -- '-c [^ ]*/(lab_modules|lab_command_list)\.dir/[^ ]*$' "$program.commands" |
    sed 's/-include [^ ]*cmake_pch[^ ]*//; s/-Winvalid-pch//' | sed 's/ -O[0-9]//g' | bash -e
  grep -E -- ' -o poissonlab( |$)' "$program.commands" | bash -e 2>&1
}

status=0
for module in methods own_methods results tiles other_tiles tilings regions distributions classes textures surfaces surface_textures surface_spectra \
  large_sets particles point_formats processes reference space tile_measures zone_plate; do
  if ! (link_alone "$module") >"$folder/$module.out" 2>&1; then
    echo "the program with the module $module alone does not link:"
    grep -E 'undefined reference|multiple definition|error' "$folder/$module.out" | head -n 20
    status=1
  fi
  rm -rf "${folder:?}/$module"
done
exit $status
