#!/usr/bin/env bash
# runtime/ as a package of npm: packed, installed from the file that comes out, and used by require() and by import. Its
# points are those of `poissonlab tiles points`; its types name what its classes have. Where there is no npm, its files are
# copied to where npm installs them. Exit status 77: there is no node.
#
# Usage: npm_package.sh SOURCE_FOLDER PROGRAM
set -euo pipefail
source=$1 program=$2

command -v node >/dev/null || { echo 'skipped: needs node'; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fail() { echo "npm_package.sh: $*" >&2; exit 1; }
export npm_config_cache=$folder/cache npm_config_offline=true npm_config_audit=false npm_config_fund=false \
  npm_config_update_notifier=false

cd "$source/runtime"
files=(LICENSE README.md package.json monotile_points{.js,.d.ts} poisson_tiles{.js,.mjs,.d.ts,.d.mts,_gpu.h,.wgsl} tile_sets/*)

# What is packed: a new file of the package has to be named in package.json.
check_packed() {
  package=$(npm pack "$source/runtime" --pack-destination "$folder" 2>"$folder/log") || fail "$(<"$folder/log")"
  local version
  version=$(sed -n 's/^project(poissonlab VERSION \([0-9.]*\).*/\1/p' "$source/CMakeLists.txt")
  [[ $package == "poissonlab-runtime-$version.tgz" ]] || fail "the package is $package, the project has version $version"
  tar -tzf "$folder/$package" | sed 's|^package/||' | sort >"$folder/packed"
  printf '%s\n' "${files[@]}" | sort | diff - "$folder/packed" || fail "the package holds other files"
}

# A project of someone else.
mkdir "$folder/project"
echo '{ "private": true }' >"$folder/project/package.json"
if command -v npm >/dev/null; then
  check_packed
  cd "$folder/project"
  npm install "$folder/$package" >"$folder/log" 2>&1 || fail "$(<"$folder/log")"
else
  mkdir -p "$folder/project/node_modules/poissonlab-runtime"
  cp --parents "${files[@]}" "$folder/project/node_modules/poissonlab-runtime"
  cd "$folder/project"
fi
cp "$source/tests/runtime/npm_package.js" by_require.js
sed 's|^const { TileSet, Tiling } = .*|import { TileSet, Tiling } from "poissonlab-runtime";\
import { createRequire } from "module";\
const require = createRequire(import.meta.url);|' by_require.js >by_import.mjs
grep -q '^import { TileSet' by_import.mjs

# Windows of whole tiles, from whose corners the program counts: no difference of coordinates is rounded.
for arguments in 'corner-c3-n64-r075 1 1 -2 1 3 2' 'corner-c4-n64-r085 77 0.3 1000 -7 4 4' \
  'sphere-c2-n128-r075 5 1 -1 2 3 1 2 1'; do
  read -r set seed density window <<<"$arguments"
  # shellcheck disable=SC2086 # numbers
  "$program" tiles points "$source/runtime/tile_sets/$set.ptiles" --window $window --seed "$seed" \
    --density "$density" --out expected.npy --quiet
  for script in by_require.js by_import.mjs; do
    # shellcheck disable=SC2086
    node "$script" "$set" "$seed" "$density" expected.npy $window || fail "$script: $arguments"
  done
done

node "$source/tests/runtime/typed_names.js" node_modules/poissonlab-runtime
command -v tsc >/dev/null || exit 0 # TypeScript's compiler
cp "$source/tests/runtime/npm_types.ts" . # a module of require()
cp npm_types.ts npm_types.mts             # one of import
check_types() { tsc --noEmit --strict --target es2020 --lib es2020 "$@" || fail "types: $*"; }
check_types --module commonjs --moduleResolution node npm_types.ts
check_types --module node16 npm_types.ts npm_types.mts
