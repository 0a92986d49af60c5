#!/usr/bin/env bash
# runtime/poisson_tiles.wgsl in the WebGPU of headless Chromium against runtime/poisson_tiles.js, which is the C header to
# the last bit: tiles in the plane and in space. Exit status 77: there is no node, no Chromium or no WebGPU.
#
# Usage: wgsl.sh SOURCE_FOLDER UNTIL_ALL_END
set -euo pipefail

source "$(dirname "$0")/in_chromium.sh"
for set in corner-c4-n64-r075 sphere-c2-n128-r075; do
    node - "$1" "$set" >"$folder/page.html" <<'END'
const read = (name) => require("fs").readFileSync(`${process.argv[2]}/${name}`);
const bytes = JSON.stringify([...read(`runtime/tile_sets/${process.argv[3]}.ptiles`)]);
console.log(`<!doctype html><meta charset="utf-8"><body><script>${read("runtime/poisson_tiles.js")}</script>
<script>const library = ${JSON.stringify(String(read("runtime/poisson_tiles.wgsl")))}; const example = ${JSON.stringify(String(read("runtime/examples/disks.wgsl")))}; const bytes = Uint8Array.from(${bytes});
</script><script>${read("tests/runtime/expected_words.js")}</script><script>${read("tests/runtime/wgsl_test.js")}</script>`);
END
    open_page
    echo "$set: $said"
    # Nearest points by floats may be others where two are as near to the last bits.
    [[ "$said" =~ ^\[\[different:\ 0\ 0\;\ nearest:\ [0-3]\]\]$ ]]
done
