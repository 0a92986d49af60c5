#!/usr/bin/env bash
# runtime/godot in Godot 3 without a screen: the look-ups against runtime/test_vectors.csv and `poissonlab tiles points`,
# what is said of damaged files, and the node that scatters. Exit status 77: there is no godot3-server (Debian's package of
# that name).
#
# Usage: godot3.sh SOURCE_FOLDER PROGRAM
set -euo pipefail
source=$1 program=$2

command -v godot3-server >/dev/null || { echo 'skipped: needs godot3-server'; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fail() { echo "godot3.sh: $*" >&2; exit 1; }
cp "$source"/runtime/godot/poisson_tiles.gd "$source"/runtime/godot/poisson_scatter_godot3.gd \
  "$source"/runtime/test_vectors.csv "$source"/runtime/tile_sets/*.ptiles "$source"/tests/runtime/godot3/points.gd "$folder"
printf 'config_version=4\n[application]\nconfig/name="points"\n' >"$folder/project.godot"
cd "$folder"

# Windows of whole tiles, from whose corners the program counts, so that no difference is rounded: set, seed, density, axes,
# the window, and the file that Godot writes.
cat >windows.txt <<'END'
corner-c3-n64-r075 1 1 2 -2 1 3 2 a
corner-c4-n64-r085 77 0.3 2 1000 -7 4 4 b
corner-c4-n64-r085 4294967295 0.99 2 -1000000 7 1 2 c
sphere-c2-n128-r075 5 1 3 -1 2 3 1 2 1 d
END
HOME=$folder timeout 300 godot3-server --path "$folder" -s points.gd >out 2>&1 || fail "$(<out)"
grep -qx DONE out && ! grep -q -e FAILED -e 'SCRIPT ERROR' out || fail "$(<out)"
grep -E 'vectors|scatter' out
(($(sed -n 's/ vectors$//p' out) >= 90)) || fail "too few vectors"

while read -r set seed density axes numbers; do
  read -ra words <<<"$numbers"
  file=${words[-1]} window=("${words[@]::${#words[@]}-1}")
  ((${#window[@]} == 2 * axes)) || fail "windows.txt"
  "$program" tiles points "$set.ptiles" --window "${window[@]}" --seed "$seed" --density "$density" --out "$file.npy" --quiet
  header=$(od -An -tu2 -j8 -N2 "$file.npy") # NumPy's format 1.0
  tail -c +$((11 + header)) "$file.npy" >expected
  [[ -s expected ]] || fail "no points in $set"
  cmp expected "$file" || fail "$set: other points"
done <windows.txt

sed -n 's/^problem: //p' out >problems
diff - problems <<'END' || fail "other words for damaged files"
shorter than the header of a tile set file
not a tile set file
an unknown version of the file format
numbers of colours, tiles and points that do not fit together
too short or too long for its points
END

# All, half of them, how many of these moved, the least distance, how many the MultiMesh has.
read -r all half moved least instances < <(sed -n 's/^scatter: //p' out)
awk -v all="$all" -v half="$half" -v moved="$moved" -v least="$least" -v instances="$instances" 'BEGIN {
  exit !(all > 100 && half > 0.4 * all && half < 0.6 * all && moved == 0 && least >= 1.5 - 1e-4 && least < 1.7 &&
         instances == half) }' || fail "scattered: $all $half $moved $least $instances"
