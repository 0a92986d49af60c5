// Views of endless textures of corner or Wang tiles, as light: a work-item a pixel.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 5.4. Hashes of lattice points or edges make tiles, and
// a tile's place in the packed atlas follows, runtime/texture_tiles.h. The plain twin is
// host/texture/mapping/texture_map_reference.cpp: no library function but square root and floor, which are exact, and
// the same order of sums, so the same bits.
//
// Needs LOOKUP (one of those of the contract), CHANNELS (1 or 3), WANG (0 or 1: tiles are Wang tiles) and COLORS, by
// which so much is divided that it is known when the kernel is built.

#include "kernels/common/fields/plane_view.clh"
#include "runtime/texture_tiles.h"

/// A tile's column and row in the atlas.
typedef struct
{
    int x, y;
} PackedTile;

/// A place in the texture: a tile, relative to the view's, and what is beyond its lower left corner, in tiles.
typedef struct
{
    int x, y;
    double fx, fy;
    PackedTile packed; ///< where that tile lies in the atlas
} TexturePlace;

PackedTile packed_tile(const struct TextureView* view, const struct TextureLevels* levels, int x, int y)
{
    const int side = COLORS * COLORS;
    PackedTile tile;
    if (LOOKUP == LOOKUP_REPEATED) {
        tile.x = ((x + (int)view->tile_x) % side + side) % side;
        tile.y = ((y + (int)view->tile_y) % side + side) % side;
        return tile;
    }
    const uint tile_x = view->tile_x + (uint)x, tile_y = view->tile_y + (uint)y;
    const uint place = WANG ? ttiles_wang_place(levels->seed, COLORS, tile_x, tile_y)
                            : ttiles_place(levels->seed, COLORS, tile_x, tile_y);
    tile.x = (int)(place % (uint)side);
    tile.y = (int)(place / (uint)side);
    return tile;
}

/// Moves a place to another one; where its tile stays the same, so does that in the atlas.
void move_place(const struct TextureView* view, const struct TextureLevels* levels, double u, double v, int is_first,
                TexturePlace* place)
{
    const double west = floor(u), south = floor(v);
    const int x = (int)west, y = (int)south;
    if (is_first || x != place->x || y != place->y) place->packed = packed_tile(view, levels, x, y);
    place->x = x;
    place->y = y;
    place->fx = u - west;
    place->fy = v - south;
}

/// Adds a texel of the atlas.
void add_texel(const struct TextureLevels* levels, global const float* light, int level, int x, int y, float weight,
               float* sum)
{
    const int width = COLORS * COLORS * (levels->size >> level);
    global const float* texel = light + levels->offsets[level] + (y * width + x) * CHANNELS;
    for (int c = 0; c < CHANNELS; ++c) sum[c] += weight * texel[c];
}

/// Adds a texel of a tile in the atlas, by column and row from its lower left, which may be one outside.
void add_tile_texel(const struct TextureLevels* levels, global const float* light, int level, PackedTile tile,
                    int column, int row, float weight, float* sum)
{
    const int size = levels->size >> level, width = COLORS * COLORS * size;
    if (LOOKUP == LOOKUP_CLAMPED) {
        column = clamp(column, 0, size - 1);
        row = clamp(row, 0, size - 1);
    }
    int x = tile.x * size + column, y = tile.y * size + row;
    x = x < 0 ? width - 1 : x >= width ? 0 : x;
    y = y < 0 ? width - 1 : y >= width ? 0 : y;
    add_texel(levels, light, level, x, y, weight, sum);
}

/// The tiles of four texels, west and east, then north of these; `west` and `south` are the first one's column and row.
/// Exact look-ups find the tile of each texel, once where several have the same one; `far` is 1 where it is the tile
/// beyond the eastern or northern border, -1 beyond the others.
void find_tiles(const struct TextureView* view, const struct TextureLevels* levels, const TexturePlace* place, int size,
                int west, int south, PackedTile* tiles, int* far_x, int* far_y)
{
    for (int k = 0; k < 2; ++k) {
        far_x[k] = LOOKUP != LOOKUP_EXACT ? 0 : west + k < 0 ? -1 : west + k >= size ? 1 : 0;
        far_y[k] = LOOKUP != LOOKUP_EXACT ? 0 : south + k < 0 ? -1 : south + k >= size ? 1 : 0;
    }
    for (int k = 0; k < 4; ++k) {
        const int i = k % 2, j = k / 2;
        if (i == 1 && far_x[1] == far_x[0])
            tiles[k] = tiles[k - 1];
        else if (j == 1 && far_y[1] == far_y[0])
            tiles[k] = tiles[k - 2];
        else if (far_x[i] == 0 && far_y[j] == 0)
            tiles[k] = place->packed;
        else
            tiles[k] = packed_tile(view, levels, place->x + far_x[i], place->y + far_y[j]);
    }
}

/// Adds the mean of a block of tiles. Neighbours share lattice points, whose colours are found once.
void add_block(const struct TextureView* view, const struct TextureLevels* levels, global const float* light, int x,
               int y, int block, float weight, float* sum)
{
    const uint west = view->tile_x + (uint)x, seed = levels->seed;
    uint south = view->tile_y + (uint)y;
    uint below[(1 << WHOLE_LEVELS) + 1], above[(1 << WHOLE_LEVELS) + 1]; // of lattice points, or of edges east of them
    float mean[CHANNELS];
    for (int c = 0; c < CHANNELS; ++c) mean[c] = 0;
    for (int i = 0; i <= block; ++i) below[i] = ttiles_color(seed, COLORS, west + (uint)i, south);
    for (int row = 0; row < block; ++row, ++south) {
        for (int i = 0; i <= block; ++i) above[i] = ttiles_color(seed, COLORS, west + (uint)i, south + 1u);
        for (int i = 0; i < block; ++i) {
            const uint at = west + (uint)i;
            const uint place =
                WANG ? ttiles_wang_place_of(COLORS, above[i], ttiles_edge_color(seed, COLORS, at + 1u, south, 1u),
                                            below[i], ttiles_edge_color(seed, COLORS, at, south, 1u))
                     : ttiles_corner_place(COLORS, above[i + 1], below[i + 1], below[i], above[i]);
            // A tile is one texel at this level: its number is the place.
            add_texel(levels, light, levels->top, (int)place, 0, 1, mean);
        }
        for (int i = 0; i <= block; ++i) below[i] = above[i];
    }
    for (int c = 0; c < CHANNELS; ++c) sum[c] += weight * (float)(1.0 / (block * block)) * mean[c];
}

/// Bilinear between means of blocks of tiles.
void add_blocks(const struct TextureView* view, const struct TextureLevels* levels, global const float* light,
                int block, const TexturePlace* place, float weight, float* sum)
{
    const int in_x = (int)((view->tile_x + (uint)place->x) % (uint)block);
    const int in_y = (int)((view->tile_y + (uint)place->y) % (uint)block);
    const double x = (in_x + place->fx) / block - 0.5, y = (in_y + place->fy) / block - 0.5;
    const int column = x < 0 ? -1 : 0, row = y < 0 ? -1 : 0;
    const float east = (float)(x - column), north = (float)(y - row);
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i)
            add_block(view, levels, light, place->x - in_x + (column + i) * block, place->y - in_y + (row + j) * block,
                      block, weight * ((i ? east : 1 - east) * (j ? north : 1 - north)), sum);
}

/// Adds the texture at a place and a level: the four nearest texels, or the nearest one.
void add_level(const struct TextureView* view, const struct TextureLevels* levels, global const float* light, int level,
               const TexturePlace* place, float weight, float* sum)
{
    if (weight == 0) return;
    if (LOOKUP != LOOKUP_EXACT) level = min(level, levels->top);
    if (level > levels->top + WHOLE_LEVELS) {
        for (int c = 0; c < CHANNELS; ++c) sum[c] += weight * light[levels->offsets[levels->top + 1] + c];
        return;
    }
    if (level > levels->top) {
        add_blocks(view, levels, light, 1 << (level - levels->top), place, weight, sum);
        return;
    }
    const int size = levels->size >> level;
    if (view->filter == FILTER_NEAREST) {
        add_tile_texel(levels, light, level, place->packed, (int)(place->fx * size), (int)(place->fy * size), weight,
                       sum);
        return;
    }
    const double x = place->fx * size - 0.5, y = place->fy * size - 0.5;
    const int west = (int)floor(x), south = (int)floor(y);
    const float east = (float)(x - west), north = (float)(y - south);
    PackedTile tiles[4];
    int far_x[2], far_y[2];
    find_tiles(view, levels, place, size, west, south, tiles, far_x, far_y);
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i)
            add_tile_texel(levels, light, level, tiles[2 * j + i], west + i - far_x[i] * size,
                           south + j - far_y[j] * size, weight * ((i ? east : 1 - east) * (j ? north : 1 - north)),
                           sum);
}

/// Adds a look-up for a footprint of so many texels: between two powers of two, its level goes on linearly.
void add_mipmap(const struct TextureView* view, const struct TextureLevels* levels, global const float* light,
                double footprint, const TexturePlace* place, float weight, float* sum)
{
    float upper;
    const int level = lower_level(footprint, levels->top + WHOLE_LEVELS + 1, &upper);
    add_level(view, levels, light, level, place, weight * (1 - upper), sum);
    add_level(view, levels, light, level + 1, place, weight * upper, sum);
}

/// Adds the texture where a sample sees it.
void add_sample(const struct TextureView* view, const struct TextureLevels* levels, global const float* light,
                double column, double row, float* sum)
{
    SeenPlace seen;
    if (!see_plane(view, levels->size, column, row, &seen)) {
        for (int c = 0; c < CHANNELS; ++c) sum[c] += (float)SKY_LIGHT;
        return;
    }
    TexturePlace place;
    if (view->filter < FILTER_MIPMAP) {
        move_place(view, levels, seen.u, seen.v, 1, &place);
        add_level(view, levels, light, 0, &place, 1, sum);
        return;
    }
    for (int probe = 0; probe < seen.probes; ++probe) {
        double u, v;
        find_probe(&seen, probe, &u, &v);
        move_place(view, levels, u, v, probe == 0, &place);
        add_mipmap(view, levels, light, seen.texels, &place, (float)(1.0 / seen.probes), sum);
    }
}

/// Pixels from `first` on, `count` of them.
kernel void map_texture(struct TextureView view, struct TextureLevels levels, uint first, uint count,
                        global const float* light, global float* pixels)
{
    const uint id = get_global_id(0);
    if (id >= count) return;
    const uint column = (first + id) % (uint)view.width, row = (first + id) / (uint)view.width;
    float sum[CHANNELS];
    for (int c = 0; c < CHANNELS; ++c) sum[c] = 0;
    for (int j = 0; j < view.samples; ++j)
        for (int i = 0; i < view.samples; ++i)
            add_sample(&view, &levels, light, (double)column * view.samples + i + 0.5,
                       (double)row * view.samples + j + 0.5, sum);
    for (int c = 0; c < CHANNELS; ++c)
        pixels[id * CHANNELS + c] = (float)(sum[c] / (double)(view.samples * view.samples));
}
