#!/usr/bin/env bash
# runtime/texture_tiles.h in a GLSL 4.3 shader: compiled where glslangValidator is there, otherwise only preprocessed, with
# a look that nothing of C is left.
#
# Usage: compile_texture_glsl.sh HEADER
set -euo pipefail

shader=$(mktemp --suffix=.frag)
trap 'rm -f "$shader" "$shader.out"' EXIT
{
    echo '#define TTILES_GLSL'
    cat "$1"
    cat <<'END'
layout(binding = 0) uniform sampler2D atlas;
layout(location = 0) in vec2 place; // in tiles
layout(location = 0) out vec4 color;
void main()
{
    const uint colors = 3u;
    const uint side = colors * colors;
    vec2 tile = floor(place);
    uint packed = ttiles_place(1u, colors, uint(int(tile.x)), uint(int(tile.y)));
    vec2 shown = (vec2(packed % side, packed / side) + place - tile) / float(side);
    color = textureGrad(atlas, vec2(shown.x, 1.0 - shown.y), dFdx(place) / float(side), dFdy(place) / float(side));
}
END
} >"$shader"

if command -v glslangValidator >/dev/null; then
    sed -i '1i #version 430' "$shader"
    glslangValidator -S frag "$shader"
else
    echo 'no glslangValidator: preprocessed only'
    cpp -undef -P "$shader" "$shader.out"
    grep -q 'uint ttiles_place(uint seed, uint colors, uint x, uint y)' "$shader.out"
    ! grep -E '\bstatic\b|\binline\b|uint32_t|TTILES_|ttiles_uint' "$shader.out"
fi
