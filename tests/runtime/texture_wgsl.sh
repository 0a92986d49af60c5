#!/usr/bin/env bash
# runtime/texture_look_up.wgsl in the WebGPU of headless Chromium: the places of a hundred thousand tiles for each number
# of colours, against packings that texture_wgsl_test.js puts together by their definitions. Exit status 77: there is no
# node, no Chromium or no WebGPU.
#
# Usage: texture_wgsl.sh SOURCE_FOLDER UNTIL_ALL_END
set -euo pipefail

source "$(dirname "$0")/in_chromium.sh"
node - "$1" >"$folder/page.html" <<'END'
const read = (name) => String(require("fs").readFileSync(`${process.argv[2]}/${name}`));
console.log(`<!doctype html><meta charset="utf-8"><body><script>const library = ${JSON.stringify(read("runtime/texture_look_up.wgsl"))};
</script><script>${read("tests/runtime/texture_wgsl_test.js")}</script>`);
END
open_page
echo "$said"
[ "$said" = '[[different: 0 0 0 0 0 0 0]]' ]
