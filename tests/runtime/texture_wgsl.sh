#!/usr/bin/env bash
# runtime/texture_look_up.wgsl in the WebGPU of headless Chromium: the places of a hundred thousand tiles for each number
# of colours, against packings that texture_wgsl_test.js puts together by their definitions. Exit status 77: there is no
# node, no Chromium or no WebGPU.
#
# Usage: texture_wgsl.sh SOURCE_FOLDER
set -euo pipefail

command -v node >/dev/null && command -v chromium >/dev/null || { echo 'needs node and Chromium'; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
node - "$1" >"$folder/page.html" <<'END'
const read = (name) => String(require("fs").readFileSync(`${process.argv[2]}/${name}`));
console.log(`<!doctype html><meta charset="utf-8"><body><script>const library = ${JSON.stringify(read("runtime/texture_look_up.wgsl"))};
</script><script>${read("tests/runtime/texture_wgsl_test.js")}</script>`);
END
chromium --headless --no-sandbox --disable-gpu --user-data-dir="$folder/profile" --remote-debugging-port=0 \
    --enable-logging=stderr --enable-unsafe-webgpu --use-webgpu-adapter=swiftshader --enable-features=Vulkan \
    "file://$folder/page.html" 2>"$folder/log" &
browser=$!
for ((tenths = 0; tenths < 3000; ++tenths)); do
    said=$(grep -o '\[\[\(different\|failed\|no\).*\]\]' "$folder/log" || true)
    [ -z "$said" ] || break
    sleep 0.1
done
kill "$browser"
wait "$browser" || true
echo "$said"
[ "$said" != '[[no WebGPU]]' ] || exit 77
[ "$said" = '[[different: 0 0 0 0 0 0 0]]' ]
