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

mkdir "$folder/objects"
gold=$(! command -v ld.gold >/dev/null || echo -fuse-ld=gold) # links in a third of the time

# objects_of COMMAND: compiles the files that a unity file joins, or a single file, and prints the objects. Programs have
# most of these files in common: those of the source folder are compiled once. Those that CMake wrote go into lists.cpp.
objects_of() {
  local file=${1##* -c } files object
  files=$file
  [[ $file != */Unity/* ]] || files=$(sed -n 's/^#include "\(.*\)"$/\1/p' "$file")
  for file in $files; do
    if [[ $file != "$source"/* ]]; then
      cat "$file" >>"$folder/lists.cpp"
      continue
    fi
    object=$folder/objects/$(basename "$(dirname "$file")")_$(basename "$file").o
    [[ -f $object ]] || bash -c "${1%% -MD *} -o '$object' -c '$file'"
    echo "$object"
  done
}

# link_alone MODULE: prints what is undefined in the program with this module; status 1 if it does not link.
link_alone() {
  cmake -S "$source" -B "$program" -G Ninja -DCMAKE_BUILD_TYPE=Release "-DPOISSONLAB_MODULES=$1" 2>&1 || return
  ninja -C "$program" -t commands poissonlab >"$folder/commands" || return
  cd "$program"
  local link command compiler
  rm -f "$folder"/lists.*
  link=$(grep -E -- ' -o poissonlab( |$)' "$folder/commands") || return # no command would be one that succeeds
  # The lists of modules and the files that stand in for modules, with the precompiled header of the build (as
  # position-independent code, which the build is for Python) or, where its options are others, without one.
  while read -r command; do
    compiler=${command%% -MD *}
    link=${link/$(sed 's/.* -o \([^ ]*\) -c .*/\1/' <<<"$command")/$(objects_of "$command" | tr '\n' ' ')}
  done < <(grep -E -- '-c [^ ]*/(lab_modules|lab_command_list)(\.dir/[^ ]*|\.cpp)$' "$folder/commands" |
    sed "s#-include $program/#-fPIC -include $build/#; s/-Winvalid-pch//")
  bash -c "$compiler -o '$folder/lists.o' -c '$folder/lists.cpp'" || return
  bash -e <<<"${link/ -o poissonlab/ $folder/lists.o $gold -o poissonlab}" 2>&1
}

status=0
for module in methods own_methods results tiles other_tiles tilings regions distributions classes textures surfaces surface_textures surface_spectra surface_classes geometry_tiles recursive_tiles sphere \
  large_sets particles point_formats processes reference space tile_measures zone_plate; do
  if ! (link_alone "$module") >"$folder/$module.out" 2>&1; then
    echo "the program with the module $module alone does not link:"
    grep -ioE '(undefined reference|multiple definition|error|no such file).*' "$folder/$module.out" | head -n 20
    status=1
  fi
done
exit $status
