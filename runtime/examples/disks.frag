#version 300 es
// SPDX-License-Identifier: MIT-0
//
// WebGL2, GLSL ES 3.00: a fragment shader that draws the points of an endless tiling as disks, each in a grey of its own.
// The words of a tile set file from byte 128 on are texels of ptiles_texture: see poisson_tiles_gpu.h, whose text goes to
// where it is named below.
precision highp float;
precision highp int;
precision highp usampler2D;
uniform usampler2D ptiles_texture;
//! poisson_tiles_gpu.h

uniform ptiles_tiling tiling; // the numbers of the file's header, a seed and a period
uniform ivec2 first_tile;     // at the lower left of the picture: integers, so that nothing is lost far from the origin
uniform float tiles_a_pixel;
uniform float radius; // of a disk, in tiles
out vec4 color;

void main()
{
    vec2 place = gl_FragCoord.xy * tiles_a_pixel;
    vec2 home = floor(place);
    ptiles_nearest nearest = ptiles_nearest_point(tiling, ivec3(first_tile + ivec2(home), 0), vec3(place - home, 0.0));
    float grey = nearest.distance < radius ? float(nearest.id & 0xffu) / 510.0 : 1.0;
    color = vec4(vec3(grey), 1.0);
}
