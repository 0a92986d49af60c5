// The plain C++ twin of kernels/textures/endless_texture.cl: a loop over pixels and the pieces of the exemplar that
// each sees.
#include "base/programs/interrupt.hpp"
#include "host/texture/endless/endless_texture.hpp"
#include "host/texture/endless/plain_blending.hpp"
#include "tiles/texture/endless_texture.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace poissonlab {
namespace {

using namespace contract::endless_texture;

std::uint32_t byte_of_color(float v) { return static_cast<std::uint32_t>(std::clamp(v + 0.5f, 0.0f, 255.0f)); }

/// The pieces that a pixel sees: texels of the exemplar, and their weights. Of turned pieces what is between texels.
struct SeenPieces
{
    int count = 3;
    std::array<std::size_t, 4> texels{};
    std::array<std::uint32_t, 4> turned{};
    std::array<float, 4> weights{};

    std::span<float> seen_weights() { return std::span(weights).first(static_cast<std::size_t>(count)); }
};

class PlainPlane
{
public:
    PlainPlane(const EndlessTexture& texture, const PixelWindow& window)
        : texture_(texture), plane_(texture.plane), window_(contract_window(texture, window))
    {}

    /// Channels in bytes from the lowest.
    std::uint32_t bytes(int column, int row) const
    {
        const int x = window_.start_x + column, y = window_.start_y + row;
        switch (texture_.method) {
        case METHOD_REPEATED:
            return texture_.texels[static_cast<std::size_t>(y % plane_.row * plane_.cell + x % plane_.cell)];
        case METHOD_TILES:
        case METHOD_WANG_TILES:
            return tile_texel(x, window_.start_y + window_.height - 1 - row);
        case METHOD_OFFSETS:
            return blended(square(x, y));
        case METHOD_HEXAGONS:
            return blended(triangle(x, y));
        default:
            return transformed_back(triangle(x, y));
        }
    }

private:
    std::uint32_t tile_texel(int x, int from_south) const
    {
        const auto side = static_cast<std::uint32_t>(plane_.cell);
        const auto at_x = static_cast<std::uint32_t>(x), at_y = static_cast<std::uint32_t>(from_south);
        const TileKind kind = texture_.method == METHOD_WANG_TILES ? TileKind::wang : TileKind::corner;
        return texture_.texels[endless_texel(kind, plane_.seed, texture_.colors, side, window_.cell_x + at_x / side,
                                             window_.cell_y + at_y / side, at_x % side, at_y % side)];
    }

    /// Adds the piece of the lattice point (i, j), from which the pixel is at (dx, dy).
    void see(SeenPieces& pieces, int piece, int i, int j, int dx, int dy, float weight) const
    {
        const std::uint32_t hash = endless_word(plane_.seed, window_.cell_x + static_cast<std::uint32_t>(i),
                                                window_.cell_y + static_cast<std::uint32_t>(j));
        const auto at = static_cast<std::size_t>(piece);
        pieces.weights[at] = weight;
        if (texture_.is_turned) {
            pieces.turned[at] = turned(hash, dx, dy);
            return;
        }
        int column = plane_.reach_x + place(hash & 0xffffu, plane_.choices_x);
        int row = plane_.reach_y + place(hash >> 16, plane_.choices_y);
        if (plane_.is_tileable != 0) {
            column = (column + dx + plane_.width) % plane_.width;
            row = (row + dy + plane_.height) % plane_.height;
        } else {
            column += std::clamp(dx, -plane_.reach_x, plane_.reach_x);
            row += std::clamp(dy, -plane_.reach_y, plane_.reach_y);
        }
        pieces.texels[at] =
            static_cast<std::size_t>(row) * static_cast<std::size_t>(plane_.width) + static_cast<std::size_t>(column);
    }

    static int place(std::uint32_t word, int choices)
    {
        return static_cast<int>(word * static_cast<std::uint32_t>(choices) >> 16);
    }

    /// The byte of a channel of the exemplar, which goes on at its other side where it is tileable. A turned piece
    /// reaches less than two exemplars far.
    int byte_at(int column, int row, int channel) const
    {
        if (plane_.is_tileable != 0) {
            column = (column + 2 * plane_.width) % plane_.width;
            row = (row + 2 * plane_.height) % plane_.height;
        }
        const auto at = static_cast<std::size_t>(row * plane_.width + column);
        return static_cast<int>(texture_.texels[at] >> (8 * channel) & 255u);
    }

    /// Returns the colour of a piece that is turned by the angle of its hash, bilinearly at 256ths of a texel.
    std::uint32_t turned(std::uint32_t hash, int dx, int dy) const
    {
        const std::size_t turn = endless_turn(hash);
        const int cosine = static_cast<int>(texture_.inverse[turn]),
                  sine = static_cast<int>(texture_.inverse[TURNS + turn]);
        const int right = (cosine * dx - sine * dy + 64) >> 7, down = (sine * dx + cosine * dy + 64) >> 7;
        const int east = right & 255, south = down & 255;
        const int column = plane_.reach_x + place(hash & 0xffffu, plane_.choices_x) + (right >> 8),
                  row = plane_.reach_y + place(hash >> 16, plane_.choices_y) + (down >> 8);
        std::uint32_t bytes = 0;
        for (int c = 0; c < texture_.channels; ++c) {
            const int upper = (256 - east) * byte_at(column, row, c) + east * byte_at(column + 1, row, c);
            const int lower = (256 - east) * byte_at(column, row + 1, c) + east * byte_at(column + 1, row + 1, c);
            const int sum = (256 - south) * upper + south * lower;
            bytes |= static_cast<std::uint32_t>((sum + (1 << 15)) >> 16) << (8 * c);
        }
        return bytes;
    }

    /// The triangle of lattice points around a pixel; weights are barycentric coordinates raised to a power.
    SeenPieces triangle(int x, int y) const
    {
        const int cell = plane_.cell, height = plane_.row, whole = 2 * cell * height;
        const int j = y / height, dy = y % height;
        const int from_row = x - j * (cell / 2); // from the row's own lattice point
        const int a = 2 * height * from_row - cell * dy;
        const int i = a >= 0 ? a / whole : -((-a + whole - 1) / whole);
        const int fa = a - i * whole, fb = 2 * cell * dy;
        const auto corner = [&](SeenPieces& pieces, int piece, int east, int south, int part) {
            see(pieces, piece, i + east, j + south, from_row - (i + east) * cell - south * (cell / 2),
                dy - south * height, whole_power(static_cast<float>(part) * plane_.inverse_unit, texture_.exponent));
        };
        SeenPieces pieces;
        if (fa + fb >= whole) {
            corner(pieces, 0, 1, 1, fa + fb - whole);
            corner(pieces, 1, 1, 0, whole - fb);
            corner(pieces, 2, 0, 1, whole - fa);
        } else {
            corner(pieces, 0, 0, 0, whole - fa - fb);
            corner(pieces, 1, 0, 1, fb);
            corner(pieces, 2, 1, 0, fa);
        }
        return pieces;
    }

    SeenPieces square(int x, int y) const
    {
        const int cell = plane_.cell, i = x / cell, j = y / cell, dx = x % cell, dy = y % cell;
        const float east = smooth_step(static_cast<float>(dx) * plane_.inverse_unit),
                    south = smooth_step(static_cast<float>(dy) * plane_.inverse_unit);
        SeenPieces pieces{4, {}, {}};
        see(pieces, 0, i, j, dx, dy, (1.0f - east) * (1.0f - south));
        see(pieces, 1, i + 1, j, dx - cell, dy, east * (1.0f - south));
        see(pieces, 2, i, j + 1, dx, dy - cell, (1.0f - east) * south);
        see(pieces, 3, i + 1, j + 1, dx - cell, dy - cell, east * south);
        return pieces;
    }

    /// The lightness of a texel, from 0 to 1.
    float lightness(std::uint32_t texel) const
    {
        const std::uint32_t red = texel & 255u, green = texel >> 8 & 255u, blue = texel >> 16 & 255u;
        const std::uint32_t sum = texture_.channels == 1 ? 256u * red : 77u * red + 150u * green + 29u * blue;
        return static_cast<float>(sum) * (1.0f / 65280.0f);
    }

    std::uint32_t blended(SeenPieces pieces) const
    {
        const auto count = static_cast<std::size_t>(pieces.count);
        std::array<std::uint32_t, 4> found{};
        for (std::size_t k = 0; k < count; ++k) {
            found[k] = texture_.is_turned ? pieces.turned[k] : texture_.texels[pieces.texels[k]];
            if (texture_.method == METHOD_HEXAGONS)
                pieces.weights[k] = pieces.weights[k] * (1.0f + plane_.falloff * (lightness(found[k]) - 1.0f));
        }
        divide_weights(pieces.seen_weights());
        gain_weights(pieces.seen_weights(), texture_.gain);
        const float factor = texture_.is_restored ? restoring_factor(pieces.seen_weights()) : 1.0f;
        std::uint32_t bytes = 0;
        for (int c = 0; c < texture_.channels; ++c) {
            const auto value = [&](std::size_t k) { return static_cast<float>(found[k] >> (8 * c) & 255u); };
            float sum = pieces.weights[0] * value(0);
            for (std::size_t k = 1; k < count; ++k) sum += pieces.weights[k] * value(k);
            const float mean = plane_.means[c];
            if (texture_.is_restored) sum = mean + (sum - mean) * factor;
            bytes |= byte_of_color(sum) << (8 * c);
        }
        return bytes;
    }

    /// The Gaussian value of a texel's channel k, relative to the mean.
    float gaussian(std::size_t texel, int k) const
    {
        const std::uint32_t word = texture_.channels == 1
                                       ? texture_.texels[texel]
                                       : texture_.texels[2 * texel + static_cast<std::size_t>(k / 2)] >> (16 * (k % 2));
        return static_cast<float>(static_cast<int>(word & 65'535u) - GAUSSIAN_ZERO);
    }

    std::uint32_t transformed_back(SeenPieces pieces) const
    {
        divide_weights(pieces.seen_weights());
        const float factor = restoring_factor(pieces.seen_weights());
        std::array<float, 3> colors{plane_.means[0], plane_.means[1], plane_.means[2]};
        for (int k = 0; k < texture_.channels; ++k) {
            float sum = pieces.weights[0] * gaussian(pieces.texels[0], k);
            for (std::size_t piece = 1; piece < 3; ++piece)
                sum += pieces.weights[piece] * gaussian(pieces.texels[piece], k);
            const int number = static_cast<int>(sum * factor + (static_cast<float>(GAUSSIAN_ZERO) + 0.5f));
            const int entry = std::clamp(number, 0, 65'535) / (65'536 / INVERSE_ENTRIES);
            const float coordinate = texture_.inverse[static_cast<std::size_t>(k * INVERSE_ENTRIES + entry)];
            for (std::size_t c = 0; c < 3; ++c)
                colors[c] = colors[c] + coordinate * plane_.axes[3 * static_cast<std::size_t>(k) + c];
        }
        std::uint32_t bytes = 0;
        for (int c = 0; c < texture_.channels; ++c)
            bytes |= byte_of_color(colors[static_cast<std::size_t>(c)]) << (8 * c);
        return bytes;
    }

    const EndlessTexture& texture_;
    const EndlessPlane& plane_;
    EndlessWindow window_;
};

}

PngPixels reference_endless_window(const EndlessTexture& texture, const PixelWindow& window)
{
    const PlainPlane plane(texture, window);
    PngPixels picture{window.width, window.height, texture.channels, {}};
    picture.values.reserve(picture.at(0, window.height, 0));
    for (int row = 0; row < window.height; ++row) {
        stop_if_interrupted();
        for (int column = 0; column < window.width; ++column) {
            const std::uint32_t bytes = plane.bytes(column, row);
            for (int c = 0; c < texture.channels; ++c)
                picture.values.push_back(static_cast<std::uint8_t>(bytes >> (8 * c)));
        }
    }
    return picture;
}

}
