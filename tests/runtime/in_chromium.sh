# Sourced by tests of shaders in the WebGPU of headless Chromium, whose second argument is the program until_all_end: see
# tests/support/until_all_end.cpp. They end with status 77 where there is no node, no Chromium or no WebGPU.

command -v node >/dev/null && command -v chromium >/dev/null || { echo 'needs node and Chromium'; exit 77; }
until_all_end=$2
folder=$(mktemp -d)
browser=
trap 'end_browser; rm -rf "$folder"' EXIT

# Ends all processes of the browser: while one is there, it writes into its profile.
end_browser()
{
    [ -n "$browser" ] || return 0
    kill "$browser" 2>/dev/null || true
    wait "$browser" || true
    browser=
}

# Opens the page $folder/page.html. What it says between double brackets is `said`.
open_page()
{
    "$until_all_end" chromium --headless --no-sandbox --disable-gpu --user-data-dir="$folder/profile" \
        --remote-debugging-port=0 --enable-logging=stderr --enable-unsafe-webgpu --use-webgpu-adapter=swiftshader \
        --enable-features=Vulkan "file://$folder/page.html" 2>"$folder/log" &
    browser=$!
    local tenths
    for ((tenths = 0; tenths < 3000; ++tenths)); do
        said=$(grep -so '\[\[\(different\|failed\|no\).*\]\]' "$folder/log" || true)
        [ -z "$said" ] || break
        sleep 0.1
    done
    end_browser
    [ "$said" != '[[no WebGPU]]' ] || exit 77
}
