#!/usr/bin/env bash
# runtime/texture_tiles.h in the shaders beside it, for corner and for Wang tiles: texture_plane.frag and
# texture_look_up.glsl as GLSL 4.3, the latter as GLSL ES 3.00, and texture_look_up.hlsl. They are compiled where
# glslangValidator is there; otherwise texture_plane.frag is preprocessed, with a look that nothing of C is left.
#
# Usage: compile_texture_glsl.sh HEADER
set -euo pipefail

header=$1
runtime=$(dirname "$header")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

numbers() { printf '#define TTILES_COLORS %su\n#define TTILES_SIZE 64\n#define TTILES_LEVELS 7\n#define TTILES_WANG %s\n' 3 "$1"; }

# glsl VERSION WANG: a shader that calls each look-up.
glsl() {
    printf '#version %s\nprecision highp float;\nprecision highp int;\n#define TTILES_GLSL\n' "$1"
    numbers "$2"
    cat "$header" "$runtime/texture_look_up.glsl"
    cat <<'END'
uniform sampler2D atlas;
uniform highp sampler2DArray layers;
uniform uint seed;
in vec2 place;
out vec4 color;
void main()
{
    ivec2 tile = ivec2(floor(place));
    vec2 inside = place - floor(place);
    color = ttiles_exact(atlas, seed, tile, inside, 2.5) + ttiles_layered(layers, seed, tile, inside, 2.5) +
            ttiles_packed(atlas, seed, tile, inside, dFdx(place), dFdy(place));
}
END
}

hlsl() {
    printf '#define TTILES_HLSL\n'
    numbers "$1"
    cat "$header" "$runtime/texture_look_up.hlsl"
    cat <<'END'
Texture2D<float4> atlas;
Texture2DArray<float4> layers;
SamplerState repeating;
cbuffer Plane { uint seed; };
float4 show(float2 place : TEXCOORD0) : SV_Target
{
    int2 tile = int2(floor(place));
    float2 inside = place - floor(place);
    return ttiles_exact(atlas, seed, tile, inside, 2.5) + ttiles_layered(layers, seed, tile, inside, 2.5) +
           ttiles_packed(atlas, repeating, seed, tile, inside, ddx(place), ddy(place));
}
END
}

{
    echo '#define TTILES_GLSL'
    cat "$header" "$runtime/texture_plane.frag"
} >"$folder/plane.frag"

if command -v glslangValidator >/dev/null; then
    sed -i '1i #version 430' "$folder/plane.frag"
    glslangValidator -S frag "$folder/plane.frag"
    for wang in 0 1; do
        for version in '430' '300 es'; do
            glsl "$version" $wang >"$folder/look_up.frag"
            glslangValidator "$folder/look_up.frag"
        done
        hlsl $wang >"$folder/look_up.hlsl"
        glslangValidator -D -V -S frag -e show -o "$folder/look_up.spv" "$folder/look_up.hlsl"
        [[ -s $folder/look_up.spv ]]
        ! command -v spirv-val >/dev/null || spirv-val "$folder/look_up.spv"
    done
else
    echo 'no glslangValidator: preprocessed only'
    cpp -undef -P "$folder/plane.frag" "$folder/plane.out"
    grep -q 'uint ttiles_place(uint seed, uint colors, uint x, uint y)' "$folder/plane.out"
    grep -q 'uint ttiles_wang_place(uint seed, uint colors, uint x, uint y)' "$folder/plane.out"
    ! grep -E '\bstatic\b|\binline\b|uint32_t|TTILES_|ttiles_uint' "$folder/plane.out"
fi
