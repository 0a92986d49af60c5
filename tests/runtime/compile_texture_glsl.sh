#!/usr/bin/env bash
# runtime/texture_tiles.h in the GLSL 4.3 shader runtime/texture_plane.frag: compiled where glslangValidator is there, otherwise only preprocessed, with
# a look that nothing of C is left.
#
# Usage: compile_texture_glsl.sh HEADER
set -euo pipefail

shader=$(mktemp --suffix=.frag)
trap 'rm -f "$shader" "$shader.out"' EXIT
{
    echo '#define TTILES_GLSL'
    cat "$1"
    cat "$(dirname "$1")/texture_plane.frag"
} >"$shader"

if command -v glslangValidator >/dev/null; then
    sed -i '1i #version 430' "$shader"
    glslangValidator -S frag "$shader"
else
    echo 'no glslangValidator: preprocessed only'
    cpp -undef -P "$shader" "$shader.out"
    grep -q 'uint ttiles_place(uint seed, uint colors, uint x, uint y)' "$shader.out"
    grep -q 'uint ttiles_wang_place(uint seed, uint colors, uint x, uint y)' "$shader.out"
    ! grep -E '\bstatic\b|\binline\b|uint32_t|TTILES_|ttiles_uint' "$shader.out"
fi
