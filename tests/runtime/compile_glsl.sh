#!/usr/bin/env bash
# runtime/poisson_tiles_gpu.h in a GLSL 4.3 shader: compiled where glslangValidator is there, otherwise only
# preprocessed, with a look that nothing of OpenCL C is left. As HLSL it is preprocessed, with a look that nothing of GLSL
# is left, see also hlsl_test.cpp and examples.sh; as GLSL ES, see glsl_es_test.cpp.
#
# Usage: compile_glsl.sh HEADER
set -euo pipefail

shader=$(mktemp --suffix=.comp)
trap 'rm -f "$shader" "$shader.out"' EXIT
{
    echo 'layout(local_size_x = 64) in;'
    echo 'layout(std430, binding = 0) readonly buffer PoissonTiles { uint ptiles_words[]; };'
    echo 'layout(std430, binding = 1) writeonly buffer Result { uint ids[]; };'
    echo 'layout(std140, binding = 2) uniform TileSet { uvec4 numbers; };'
    cat "$1" "$(dirname "$1")/object_distribution_gpu.h"
    cat <<'END'
void main()
{
    ptiles_tiling t = ptiles_tiling(0u, 2u, numbers.x, numbers.y, numbers.z, numbers.w, 0, -32768, 2, 9000, 2000, 8192u);
    ivec3 home = ivec3(gl_GlobalInvocationID);
    ptiles_nearest n = ptiles_nearest_point(t, home, vec3(0.5, 0.5, 0.0));
    pobjects_object o = pobjects_at(t, 0.1, home, vec3(0.25, 0.5, 0.0));
    vec3 u = pobjects_local(o.offset, 0.1 * pobjects_uniform(o.id, 3u), 1.0, 0.0, 1.0 + pobjects_normal(o.id, 4u));
    if (u.z > 0.5) ids[home.y] = o.index;
    if (n.distance < ptiles_min_distance(numbers.x, 0u)) ids[home.z] = 0u;
    ids[home.x] = ptiles_level(t, ptiles_tile(t, n.tile), n.index, n.id) < 0.5 ? n.id : 0u;
}
END
} >"$shader"

if command -v glslangValidator >/dev/null; then
    sed -i '1i #version 430' "$shader"
    glslangValidator -S comp "$shader"
    glslangValidator --target-env vulkan1.0 -S comp -o "$shader.out" "$shader"
else
    echo 'no glslangValidator: preprocessed only'
    cpp -undef -P "$shader" "$shader.out"
    grep -q 'ivec3 place = home + ivec3(i, j, k);' "$shader.out"
    ! grep -E '\(int3\)|\bglobal\b|\bstruct ptiles_tiling t\b|PTILES_' "$shader.out"
fi

cpp -undef -P -DPTILES_HLSL "$1" "$shader.out"
grep -q 'int3 place = home + int3(i, j, k);' "$shader.out"
! grep -E '\bi?vec3\b|texelFetch|PTILES_' "$shader.out"
