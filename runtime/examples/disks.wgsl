// SPDX-License-Identifier: MIT-0
//
// WebGPU: a fragment shader that draws the points of an endless tiling as disks, each in a grey of its own. The words of a
// tile set file from byte 128 on are a storage buffer. The text of poisson_tiles.wgsl goes to the end of this one.
@group(0) @binding(0) var<storage, read> ptiles_words: array<u32>;

struct View {
    tiling: PtilesTiling,  // the numbers of the file's header, a seed and a period
    first_tile: vec2<i32>, // at the upper left of the picture: integers, so that nothing is lost far from the origin
    tiles_a_pixel: f32,
    radius: f32,           // of a disk, in tiles
}
@group(0) @binding(1) var<uniform> view: View;

@fragment
fn draw_disks(@builtin(position) pixel: vec4<f32>) -> @location(0) vec4<f32> {
    let place = pixel.xy * view.tiles_a_pixel;
    let home = floor(place);
    let tile = vec3<i32>(view.first_tile + vec2<i32>(home), 0);
    let nearest = ptiles_nearest_point(view.tiling, tile, vec3<f32>(place - home, 0.0));
    let grey = select(1.0, f32(nearest.id & 0xffu) / 510.0, nearest.distance < view.radius);
    return vec4<f32>(grey, grey, grey, 1.0);
}
