// The plain C++ twin of kernels/textures/endless_map.cl: a loop over pixels, samples, probes and the pieces of the
// exemplar that each sees.
#include "host/texture/endless/plain_blending.hpp"
#include "host/texture/mapping/endless_map.hpp"
#include "host/texture/mapping/seen_place.hpp"
#include "tiles/texture/endless_texture.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

using namespace contract::endless_map;
using namespace contract::endless_texture;
using namespace contract::texture_map;

/// The colours or Gaussian numbers that pieces show, and the pieces' weights.
struct ShownPieces
{
    std::vector<Light> values;
    std::vector<float> weights;

    void add(const Light& shown, float weight)
    {
        values.push_back(shown);
        weights.push_back(weight);
    }
};

constexpr double turn_unit = TURN_UNIT, tile_texels = TILE_TEXELS, encoded_steps = ENCODED_STEPS;

float mixed(float a, float b, float part) { return a + (b - a) * part; }

class PlainEndlessMap
{
public:
    PlainEndlessMap(const MappedEndless& mapped, const EndlessWindow& origin, const TextureView& view)
        : mapped_(mapped), texture_(mapped.texture), plane_(mapped.texture.plane), levels_(mapped.levels),
          origin_(origin), view_(view), channels_(static_cast<std::size_t>(texture_.channels))
    {}

    void add_sample(double column, double row, Light& sum) const
    {
        const std::optional<SeenPlace> seen = seen_place(view_, TILE_TEXELS, column, row);
        if (!seen) {
            for (std::size_t c = 0; c < channels_; ++c) sum[c] += static_cast<float>(SKY_LIGHT);
            return;
        }
        LevelPair level = levels_of_footprint(seen->texels, levels_.top);
        if (level.lower == levels_.top) level.upper = 0;
        const auto pixel = [&](double tiles) {
            return view_.filter == FILTER_NEAREST ? std::floor(tiles * tile_texels) : tiles * tile_texels - 0.5;
        };
        const auto share = static_cast<float>(1.0 / seen->probes);
        for (int probe = 0; probe < seen->probes; ++probe) {
            const auto [u, v] = probe_place(*seen, probe);
            const Light shown = light_at(level, origin_.start_x + pixel(u), origin_.start_y + pixel(-v));
            for (std::size_t c = 0; c < channels_; ++c) sum[c] += share * shown[c];
        }
    }

private:
    Light light_at(LevelPair level, double x, double y) const
    {
        if (texture_.method == METHOD_REPEATED)
            return looked_up(level, wrapped(x, plane_.width), wrapped(y, plane_.height));
        const ShownPieces pieces = texture_.method == METHOD_OFFSETS ? square(level, x, y) : triangle(level, x, y);
        return texture_.method == METHOD_BLENDED ? transformed_back(level, pieces) : blended(level, pieces);
    }

    /// Wraps a coordinate to the range from 0 to the size, without it.
    static double wrapped(double at, int size)
    {
        const double inside = at - std::floor(at / size) * size;
        return inside >= size ? 0 : inside;
    }

    bool is_wrapped() const { return texture_.method == METHOD_REPEATED || plane_.is_tileable != 0; }

    Light looked_up(LevelPair level, double column, double row) const
    {
        Light sum{};
        add_level(level.lower, column, row, 1 - level.upper, sum);
        if (level.upper > 0) add_level(level.lower + 1, column, row, level.upper, sum);
        return sum;
    }

    void add_level(int level, double column, double row, float weight, Light& sum) const
    {
        const int width = levels_.widths[level], height = levels_.heights[level];
        const double x = (column + 0.5) * (static_cast<double>(width) / levels_.widths[0]) - 0.5,
                     y = (row + 0.5) * (static_cast<double>(height) / levels_.heights[0]) - 0.5;
        const auto west = static_cast<int>(std::floor(x)), north = static_cast<int>(std::floor(y));
        const auto east = static_cast<float>(x - west), south = static_cast<float>(y - north);
        const auto inside = [&](int at, int count) {
            return is_wrapped() ? (at + count) % count : std::clamp(at, 0, count - 1);
        };
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 2; ++i) {
                const float share = weight * ((i == 1 ? east : 1 - east) * (j == 1 ? south : 1 - south));
                const auto texel =
                    static_cast<std::size_t>(inside(north + j, height)) * static_cast<std::size_t>(width) +
                    static_cast<std::size_t>(inside(west + i, width));
                for (std::size_t c = 0; c < channels_; ++c)
                    sum[c] += share * mapped_.exemplar[levels_.offsets[level] + texel * channels_ + c];
            }
    }

    /// Modulo 2^32.
    static std::uint32_t lattice_number(double number)
    {
        return static_cast<std::uint32_t>(number - std::floor(number * 0x1p-32) * 0x1p32);
    }

    /// Looks up the piece of the lattice point (i, j), from which the place is at (dx, dy).
    Light piece(LevelPair level, double i, double j, double dx, double dy) const
    {
        const std::uint32_t hash =
            endless_word(plane_.seed, origin_.cell_x + lattice_number(i), origin_.cell_y + lattice_number(j));
        if (texture_.is_turned) {
            const std::size_t turn = endless_turn(hash);
            const double cosine = static_cast<double>(texture_.inverse[turn]),
                         sine = static_cast<double>(texture_.inverse[TURNS + turn]);
            const double right = (cosine * dx - sine * dy) / turn_unit;
            dy = (sine * dx + cosine * dy) / turn_unit;
            dx = right;
        }
        const auto along = [&](std::uint32_t word, int choices, int reach, int size, double d) {
            const int middle = reach + static_cast<int>(word * static_cast<std::uint32_t>(choices) >> 16);
            if (plane_.is_tileable == 0)
                return middle + std::clamp(d, static_cast<double>(-reach), static_cast<double>(reach));
            double at = middle + d;
            if (at < 0) at += size;
            return at >= size ? at - size : at; // what was just below 0 may be rounded to the size
        };
        return looked_up(level, along(hash & 0xffffu, plane_.choices_x, plane_.reach_x, plane_.width, dx),
                         along(hash >> 16, plane_.choices_y, plane_.reach_y, plane_.height, dy));
    }

    /// The triangle of lattice points around a place; weights are barycentric coordinates raised to a power.
    ShownPieces triangle(LevelPair level, double x, double y) const
    {
        const double cell = plane_.cell, height = plane_.row, whole = 2 * cell * height;
        const double row = std::floor(y / height), dy = y - row * height;
        const double from_row = x - row * (cell / 2); // from the row's own lattice point
        const double a = 2 * height * from_row - cell * dy, column = std::floor(a / whole);
        const double fa = a - column * whole, fb = 2 * cell * dy;
        ShownPieces pieces;
        const auto add_corner = [&](int east, int south, double part) {
            const float unit = std::max(0.0f, static_cast<float>(part) * plane_.inverse_unit);
            pieces.add(piece(level, column + east, row + south, from_row - (column + east) * cell - south * (cell / 2),
                             dy - south * height),
                       whole_power(unit, texture_.exponent));
        };
        if (fa + fb >= whole) {
            add_corner(1, 1, fa + fb - whole);
            add_corner(1, 0, whole - fb);
            add_corner(0, 1, whole - fa);
        } else {
            add_corner(0, 0, whole - fa - fb);
            add_corner(0, 1, fb);
            add_corner(1, 0, fa);
        }
        return pieces;
    }

    ShownPieces square(LevelPair level, double x, double y) const
    {
        const double cell = plane_.cell, column = std::floor(x / cell), row = std::floor(y / cell),
                     dx = x - column * cell, dy = y - row * cell;
        const float east = smooth_step(static_cast<float>(dx) * plane_.inverse_unit),
                    south = smooth_step(static_cast<float>(dy) * plane_.inverse_unit);
        ShownPieces pieces;
        for (int v = 0; v < 2; ++v)
            for (int u = 0; u < 2; ++u)
                pieces.add(piece(level, column + u, row + v, dx - u * cell, dy - v * cell),
                           (u == 1 ? east : 1.0f - east) * (v == 1 ? south : 1.0f - south));
        return pieces;
    }

    static float weighted(const ShownPieces& pieces, std::size_t channel)
    {
        float sum = 0;
        for (std::size_t k = 0; k < pieces.weights.size(); ++k) sum += pieces.weights[k] * pieces.values[k][channel];
        return sum;
    }

    float encoded(float light) const
    {
        const double root = std::sqrt(static_cast<double>(light)) * encoded_steps;
        const auto entry = std::min(static_cast<std::size_t>(root), std::size_t{ENCODED_ENTRIES - 2});
        return mixed(mapped_.encoded[entry], mapped_.encoded[entry + 1],
                     static_cast<float>(root - static_cast<double>(entry)));
    }

    float mean_light(float number, float variance) const
    {
        number = std::clamp(number, 0.0f, 255.0f);
        const auto entry = std::min(static_cast<std::size_t>(number), std::size_t{254});
        const float part = number - static_cast<float>(entry);
        return mixed(mapped_.light[entry], mapped_.light[entry + 1], part) +
               mixed(mapped_.light[256 + entry], mapped_.light[257 + entry], part) * variance;
    }

    float lightness(const Light& values) const
    {
        const float sum = channels_ == 1 ? 256 * values[0] : 77 * values[0] + 150 * values[1] + 29 * values[2];
        return sum * (1.0f / 65280.0f);
    }

    float mean(LevelPair level, std::size_t channel) const
    {
        const auto at = [&](int which) { return mapped_.means[3 * static_cast<std::size_t>(which) + channel]; };
        return mixed(at(level.lower), at(std::min(level.lower + 1, levels_.top)), level.upper);
    }

    Light blended(LevelPair level, ShownPieces pieces) const
    {
        for (std::size_t k = 0; k < pieces.weights.size(); ++k) {
            for (std::size_t c = 0; c < channels_; ++c) pieces.values[k][c] = encoded(pieces.values[k][c]);
            if (texture_.method == METHOD_HEXAGONS)
                pieces.weights[k] = pieces.weights[k] * (1.0f + plane_.falloff * (lightness(pieces.values[k]) - 1.0f));
        }
        divide_weights(pieces.weights);
        gain_weights(pieces.weights, texture_.gain);
        Light shown{};
        for (std::size_t c = 0; c < channels_; ++c) {
            const float number = weighted(pieces, c), middle = mean(level, c);
            shown[c] = mean_light(
                texture_.is_restored ? middle + (number - middle) * restoring_factor(pieces.weights) : number, 0);
        }
        return shown;
    }

    Light transformed_back(LevelPair level, ShownPieces pieces) const
    {
        divide_weights(pieces.weights);
        const float factor = restoring_factor(pieces.weights);
        Light numbers{}, variances{};
        for (std::size_t c = 0; c < channels_; ++c) numbers[c] = mean(level, c);
        for (std::size_t k = 0; k < channels_; ++k) {
            const int number =
                static_cast<int>(weighted(pieces, k) * factor + (static_cast<float>(GAUSSIAN_ZERO) + 0.5f));
            const auto entry = static_cast<std::size_t>(std::clamp(number, 0, 65'535) / (65'536 / INVERSE_ENTRIES));
            const auto entry_of = [&](int which, std::size_t table) {
                return mapped_
                    .inverse[(2 * (static_cast<std::size_t>(which) * channels_ + k) + table) * INVERSE_ENTRIES + entry];
            };
            const auto between = [&](std::size_t table) {
                return mixed(entry_of(level.lower, table), entry_of(std::min(level.lower + 1, levels_.top), table),
                             level.upper);
            };
            const float coordinate = between(0), variance = between(1);
            for (std::size_t c = 0; c < channels_; ++c) {
                const float axis = plane_.axes[3 * k + c];
                numbers[c] = numbers[c] + coordinate * axis;
                variances[c] = variances[c] + variance * axis * axis;
            }
        }
        Light shown{};
        for (std::size_t c = 0; c < channels_; ++c) shown[c] = mean_light(numbers[c], variances[c]);
        return shown;
    }

    const MappedEndless& mapped_;
    const EndlessTexture& texture_;
    const EndlessPlane& plane_;
    const ExemplarLevels& levels_;
    EndlessWindow origin_;
    const TextureView& view_;
    std::size_t channels_;
};

}

std::vector<float> reference_map_endless(const MappedEndless& mapped, const EndlessWindow& origin,
                                         const TextureView& view)
{
    const PlainEndlessMap map(mapped, origin, view);
    return plain_picture(view, mapped.texture.channels,
                         [&](double column, double row, Light& sum) { map.add_sample(column, row, sum); });
}

}
