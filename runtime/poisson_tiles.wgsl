// SPDX-License-Identifier: MIT-0
//
// Poisson disk (sphere) distributions in WGSL: the look-ups of poisson_tiles.h for WebGPU.
//
// The points of a tile set file (docs/tile-set-file.md), its bytes from 128 on, are a buffer of 32-bit words, the last one
// filled up with zeros, which the shader declares beside this text:
//     @group(0) @binding(0) var<storage, read> ptiles_words: array<u32>;
// Sums may be rounded in other ways than elsewhere: of two points that are as near, to the last bit of a float, either may
// be taken for the nearest.

/// The numbers of the file's header, and which tile is where: see ptiles_set and ptiles_tiling in poisson_tiles.h. Tiles
/// with strips: low 0, step 1, below and above 0. `ranks` says where ranks are in the buffer: in terms of poisson_tiles.h
/// set.ranks - set.points; 0: the set is not ranked.
struct PtilesTiling {
    kind: u32,
    dimension: u32,
    colors: u32,
    tiles: u32,
    points_per_tile: u32,
    seed: u32,
    period: i32,
    low: i32,
    step: i32,
    below: i32,
    above: i32,
    ranks: u32,
}

struct PtilesNearest {
    distance: f32,
    tile: vec3<i32>, ///< the place of the point's tile
    index: u32,      ///< in its tile
    id: u32,         ///< random bits that stay with the point
}

fn ptiles_mix(value: u32) -> u32 {
    var v = value;
    v = (v ^ (v >> 16u)) * 0x21f0aaadu;
    v = (v ^ (v >> 15u)) * 0xd35a2d97u;
    return v ^ (v >> 15u);
}

fn ptiles_hash(seed: u32, x: u32, y: u32, z: u32) -> u32 {
    return ptiles_mix(ptiles_mix(ptiles_mix(ptiles_mix(seed) + x) + y) + z);
}

fn ptiles_color(t: PtilesTiling, x: u32, y: u32, z: u32) -> u32 {
    return ptiles_hash(t.seed, x, y, z) % t.colors;
}

/// A place as the hash function takes it, and those after and before it, on the circle of a period or of 2^32.
fn ptiles_place(i: i32, period: i32) -> u32 {
    if (period == 0) { return u32(i); }
    let rest = i % period;
    return u32(select(rest, rest + period, rest < 0));
}
fn ptiles_after(x: u32, period: i32) -> u32 { return select(x + 1u, 0u, x + 1u == u32(period)); }
fn ptiles_before(x: u32, period: i32) -> u32 { return select(x, u32(period), x == 0u) - 1u; }

/// The digits of a corner tile at the height z.
fn ptiles_corners(t: PtilesTiling, x: u32, y: u32, z: u32) -> u32 {
    let east = ptiles_after(x, t.period);
    let north = ptiles_after(y, t.period);
    let tile = ptiles_color(t, east, north, z) * t.colors + ptiles_color(t, east, y, z);
    return (tile * t.colors + ptiles_color(t, x, y, z)) * t.colors + ptiles_color(t, x, north, z);
}

/// Two more digits: the edges that go east from (x0, y0) and north from (x1, y1).
fn ptiles_edge_pair(t: PtilesTiling, tile: u32, x0: u32, y0: u32, x1: u32, y1: u32) -> u32 {
    return (tile * t.colors + ptiles_color(t, x0, y0, 0u)) * t.colors + ptiles_color(t, x1, y1, 1u);
}

/// The number of the tile at a place; z is 0 in 2D.
fn ptiles_tile(t: PtilesTiling, at: vec3<i32>) -> u32 {
    let x = ptiles_place(at.x, t.period);
    let y = ptiles_place(at.y, t.period);
    if (t.kind == 2u) { return ptiles_hash(t.seed, x, y, 0u) % t.tiles; }
    if (t.kind == 0u && t.dimension == 2u) { return ptiles_corners(t, x, y, 0u); }
    if (t.kind == 0u) {
        let z = ptiles_place(at.z, t.period);
        return ptiles_corners(t, x, y, ptiles_after(z, t.period)) * (t.colors * t.colors * t.colors * t.colors) +
               ptiles_corners(t, x, y, z);
    }
    let east = ptiles_after(x, t.period);
    let west = ptiles_before(x, t.period);
    let north = ptiles_after(y, t.period);
    let south = ptiles_before(y, t.period);
    var tile = ptiles_edge_pair(t, 0u, x, north, east, y);
    tile = ptiles_edge_pair(t, tile, x, y, x, y);
    tile = ptiles_edge_pair(t, tile, east, north, east, north);
    tile = ptiles_edge_pair(t, tile, east, y, east, south);
    tile = ptiles_edge_pair(t, tile, west, y, x, south);
    return ptiles_edge_pair(t, tile, west, north, x, north);
}

/// The number of this place among all of the buffer.
fn ptiles_number(n: u32) -> u32 {
    return (ptiles_words[n >> 1u] >> ((n & 1u) * 16u)) & 0xffffu;
}

/// A number as a coordinate, in tiles from the tile's lowest corner, without rounding.
fn ptiles_coordinate(t: PtilesTiling, n: u32) -> f32 {
    return f32(t.low + t.step * i32(ptiles_number(n))) / 65536.0;
}

/// The point of this index of a tile: from the tile's lowest corner, without rounding. In 2D z is 0.
fn ptiles_point(t: PtilesTiling, tile: u32, index: u32) -> vec3<f32> {
    let n = (tile * t.points_per_tile + index) * t.dimension;
    var p = vec3<f32>(ptiles_coordinate(t, n), ptiles_coordinate(t, n + 1u), 0.0);
    if (t.dimension == 3u) { p.z = ptiles_coordinate(t, n + 2u); }
    return p;
}

/// Random bits that stay with a point, and with its repetitions.
fn ptiles_id(t: PtilesTiling, at: vec3<i32>, index: u32) -> u32 {
    return ptiles_mix(ptiles_hash(t.seed, ptiles_place(at.x, t.period), ptiles_place(at.y, t.period),
                                  ptiles_place(at.z, t.period)) + 1u + index);
}

/// Returns the minimum distance of every tiling, in tiles, from the file's header: its 32-bit words 10 and 11, at the bytes 40
/// and 44. It is 0 where the file promises none.
fn ptiles_min_distance(word10: u32, word11: u32) -> f32 {
    return sqrt(f32(word11) * 4294967296.0 + f32(word10)) / 65536.0;
}

/// The density, from 0 to 1, above which a point is there: ranked sets are spread evenly at any density, others lose
/// points at random. `tile` is the number of its tile, `id` its random bits.
fn ptiles_level(t: PtilesTiling, tile: u32, index: u32, id: u32) -> f32 {
    if (t.ranks == 0u) { return f32(id >> 8u) / 16777216.0; }
    return (f32(ptiles_number(t.ranks + tile * t.points_per_tile + index)) + 0.5) / f32(t.points_per_tile);
}

/// The squared distance along an axis of a position in the tile 0 from where points of the tile `offset` tiles away can
/// be, which is `below` and `above` more than its square.
fn ptiles_gap(f: f32, offset: i32, below: f32, above: f32) -> f32 {
    var gap = 0.0;
    if (offset > 0) { gap = max(f32(offset) - below - f, 0.0); }
    if (offset < 0) { gap = max(f - (f32(offset + 1) + above), 0.0); }
    return gap * gap;
}

/// The point nearest to a position in the tile at `home`, which is `f` from that tile's lowest corner; 0 <= f < 1, in 2D
/// f.z = 0. Rings of tiles around that tile are visited as long as they can have a nearer point.
fn ptiles_nearest_point(t: PtilesTiling, home: vec3<i32>, f: vec3<f32>) -> PtilesNearest {
    let is_3d = t.dimension == 3u;
    var border = min(min(f.x, 1.0 - f.x), min(f.y, 1.0 - f.y));
    if (is_3d) { border = min(border, min(f.z, 1.0 - f.z)); }
    var nearest: PtilesNearest;
    var squared = 1e30;
    let below = f32(t.below) / 65536.0;
    let above = f32(t.above) / 65536.0;
    for (var ring = 0; ; ring++) {
        let away = border + f32(ring - 1) - max(below, above); // of points in the ring, at least
        if (ring > 0 && away > 0.0 && away * away >= squared) { break; }
        let layers = select(0, ring, is_3d);
        for (var k = -layers; k <= layers; k++) {
            for (var j = -ring; j <= ring; j++) {
                // Rows inside the ring contribute only their ends.
                let outer = ring == 0 || j == -ring || j == ring || (is_3d && (k == -ring || k == ring));
                for (var i = -ring; i <= ring; i += select(2 * ring, 1, outer)) {
                    let gap = ptiles_gap(f.x, i, below, above) + ptiles_gap(f.y, j, below, above) +
                              ptiles_gap(f.z, k, below, above);
                    if (gap >= squared) { continue; }
                    let place = home + vec3<i32>(i, j, k);
                    let tile = ptiles_tile(t, place);
                    for (var n = 0u; n < t.points_per_tile; n++) {
                        let d = ptiles_point(t, tile, n) + vec3<f32>(f32(i), f32(j), f32(k)) - f;
                        let sum = d.x * d.x + d.y * d.y + d.z * d.z;
                        if (sum >= squared) { continue; }
                        squared = sum;
                        nearest.tile = place;
                        nearest.index = n;
                    }
                }
            }
        }
    }
    nearest.distance = sqrt(squared);
    nearest.id = ptiles_id(t, nearest.tile, nearest.index);
    return nearest;
}
