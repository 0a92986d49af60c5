#!/usr/bin/env bash
# runtime/blender/poisson_points.py in Blender without a screen: operator, attributes, geometry nodes. Exit status 77:
# there is no blender. Its look-ups, which need none, are in tests/python/blender_points_test.py.
#
# Usage: blender.sh SOURCE_FOLDER
set -euo pipefail

command -v blender >/dev/null || { echo 'skipped: needs blender'; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
HOME=$folder PYTHONDONTWRITEBYTECODE=1 timeout 300 blender --background --factory-startup --python-exit-code 1 \
  --python "$1/tests/runtime/blender/scatter.py" -- "$1/runtime/blender" "$1/runtime/tile_sets" >"$folder/out" 2>&1 ||
  { cat "$folder/out"; exit 1; }
grep '^DONE' "$folder/out"
