# Sourced by tests of shaders in the WebGPU of headless Chromium. They end with status 77 where there is no node, no Chromium
# or no WebGPU.

command -v node >/dev/null && command -v chromium >/dev/null || { echo 'needs node and Chromium'; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# Opens the page $folder/page.html. What it says between double brackets is `said`.
open_page()
{
    chromium --headless --no-sandbox --disable-gpu --user-data-dir="$folder/profile" --remote-debugging-port=0 \
        --enable-logging=stderr --enable-unsafe-webgpu --use-webgpu-adapter=swiftshader --enable-features=Vulkan \
        "file://$folder/page.html" 2>"$folder/log" &
    local browser=$! tenths
    for ((tenths = 0; tenths < 3000; ++tenths)); do
        said=$(grep -o '\[\[\(different\|failed\|no\).*\]\]' "$folder/log" || true)
        [ -z "$said" ] || break
        sleep 0.1
    done
    kill "$browser"
    wait "$browser" || true
    [ "$said" != '[[no WebGPU]]' ] || exit 77
}
