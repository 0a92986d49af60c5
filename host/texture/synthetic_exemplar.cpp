#include "host/texture/synthetic_exemplar.hpp"

#include "base/random/random.hpp"

#include <algorithm>
#include <stdexcept>

namespace poissonlab {
namespace {

constexpr int pebble_pixels = 12, check_pixels_a_square = 8;
constexpr int brick_width = 32, brick_height = 16, mortar = 2;
constexpr int thread_pixels = 8, cloud_octaves = 5, coarsest_cloud = 6; // squares of 2^6 pixels

/// Random words by place, different for each use.
class PatternWords
{
public:
    PatternWords(std::uint64_t seed, std::uint32_t use) : key_(stream_key(seed, Purpose::texture_windows, 100, use)) {}

    std::uint32_t at(std::uint32_t x, std::uint32_t y = 0) const { return philox({x, y, 0, 0}, key_)[0]; }

    /// A number from -reach to reach.
    int jitter(std::uint32_t x, std::uint32_t y, int reach) const
    {
        return static_cast<int>(at(x, y) >> 8) % (2 * reach + 1) - reach;
    }

private:
    StreamKey key_;
};

template <class Value>
PngPixels pattern_of(int size, const Value& value)
{
    PngPixels picture{size, size, 1, {}};
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            picture.values.push_back(static_cast<std::uint8_t>(std::clamp(value(x, y), 0, 255)));
    return picture;
}

PngPixels bricks(int size, std::uint64_t seed)
{
    const PatternWords grain(seed, 1), light(seed, 2);
    return pattern_of(size, [&](int x, int y) {
        const int row = y / brick_height, shifted = x + row % 2 * brick_width / 2;
        const auto noise = grain.jitter(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 10);
        if (y % brick_height < mortar || shifted % brick_width < mortar) return 205 + noise;
        const auto brick =
            light.jitter(static_cast<std::uint32_t>(shifted / brick_width), static_cast<std::uint32_t>(row), 24);
        return 105 + brick + noise;
    });
}

/// Says how far a thread lies over another one: 256 in its middle, 0 at its sides.
int thread_height(int across, int width) { return std::max(0, 256 - 1024 * across * across / (width * width)); }

/// A plain weave: threads of both directions lie over each other by turns, and show most of themselves there.
PngPixels fabric(int size, std::uint64_t seed)
{
    const PatternWords light(seed, 5), wander(seed, 6), grain(seed, 7);
    // Returns how high the thread of a direction lies at a place.
    const auto height = [&](int across, int along, std::uint32_t direction) {
        const int thread = across / thread_pixels;
        const int middle = thread * thread_pixels + thread_pixels / 2 +
                           wander.jitter(static_cast<std::uint32_t>(thread), direction, 1);
        const int crossed = along % thread_pixels - thread_pixels / 2;
        const bool is_upper = (thread + along / thread_pixels + static_cast<int>(direction)) % 2 == 0;
        return thread_height(across - middle, thread_pixels + 2) + (is_upper ? 1 : -1) * thread_height(crossed, 12) / 2;
    };
    return pattern_of(size, [&](int x, int y) {
        const int warp = height(x, y, 0), weft = height(y, x, 1);
        const bool is_warp = warp >= weft;
        const int thread = (is_warp ? x : y) / thread_pixels;
        return 60 + std::max(warp, weft) * 100 / 256 +
               light.jitter(static_cast<std::uint32_t>(thread), is_warp ? 0 : 1, 22) +
               grain.jitter(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 9);
    });
}

/// Light at the corners of squares of 2^level pixels, and between them by 3 t^2 - 2 t^3 (Perlin, An Image Synthesizer,
/// SIGGRAPH 1985); in 256ths.
int smooth_noise(const PatternWords& words, int x, int y, int level)
{
    const auto corner = [&](int dx, int dy) {
        return static_cast<int>(
            words.at(static_cast<std::uint32_t>((x >> level) + dx), static_cast<std::uint32_t>((y >> level) + dy)) >>
            24);
    };
    const auto weight = [&](int place) { // in 2^16ths
        const std::int64_t t = static_cast<std::int64_t>(place & ((1 << level) - 1)) << (16 - level);
        return t * t * (3 * 65536 - 2 * t) >> 32;
    };
    const auto mix = [](std::int64_t a, std::int64_t b, std::int64_t t) { return a + ((b - a) * t >> 16); };
    const std::int64_t along = weight(x);
    return static_cast<int>(mix(mix(256 * corner(0, 0), 256 * corner(1, 0), along),
                                mix(256 * corner(0, 1), 256 * corner(1, 1), along), weight(y)));
}

PngPixels clouds(int size, std::uint64_t seed)
{
    std::vector<PatternWords> octaves;
    for (std::uint32_t i = 0; i < cloud_octaves; ++i) octaves.emplace_back(seed, 8 + i);
    return pattern_of(size, [&](int x, int y) {
        // Each octave has 5/8 of the amplitude of the one that is twice as coarse.
        int sum = 0, amplitude = 256;
        for (int i = 0; i < cloud_octaves; ++i, amplitude = amplitude * 5 / 8)
            sum += (smooth_noise(octaves[static_cast<std::size_t>(i)], x, y, coarsest_cloud - i) - 32640) / 256 *
                   amplitude / 256;
        return 150 + sum * 3 / 4;
    });
}

/// The nearest point of a picture that closes, and by how much the next one is farther.
struct NearestPebble
{
    std::uint32_t number = 0;
    std::int64_t square = INT64_MAX, next_square = INT64_MAX;
};

NearestPebble nearest_pebble(PebblePlaces places, std::uint32_t x, std::uint32_t y)
{
    NearestPebble nearest;
    for (std::size_t i = 0; i + 1 < places.size(); i += 2) {
        // Differences on the torus, in parts of 2^16.
        const auto dx = static_cast<std::int64_t>(static_cast<std::int32_t>(places[i] - x)) / 65536,
                   dy = static_cast<std::int64_t>(static_cast<std::int32_t>(places[i + 1] - y)) / 65536;
        const std::int64_t square = dx * dx + dy * dy;
        if (square < nearest.square) {
            nearest.next_square = nearest.square;
            nearest.square = square;
            nearest.number = static_cast<std::uint32_t>(i / 2);
        } else {
            nearest.next_square = std::min(nearest.next_square, square);
        }
    }
    return nearest;
}

/// Cells of the points, dark where two are equally near, each with a light of its own and lighter in the middle.
PngPixels pebbles(int size, std::uint64_t seed, PebblePlaces places)
{
    if (places.size() < 4) throw std::logic_error("pebbles without places");
    const PatternWords light(seed, 3), grain(seed, 4);
    const auto step = static_cast<std::uint32_t>((std::uint64_t{1} << 32) / static_cast<std::uint64_t>(size));
    return pattern_of(size, [&](int x, int y) {
        const auto column = static_cast<std::uint32_t>(x), row = static_cast<std::uint32_t>(y);
        const NearestPebble nearest = nearest_pebble(places, column * step + step / 2, row * step + step / 2);
        // The weight goes from 0 at the rim to 1 at the point, in 256ths.
        const auto inside = static_cast<int>((nearest.next_square - nearest.square) * 256 /
                                             std::max<std::int64_t>(1, nearest.next_square));
        const int body = 90 + light.jitter(nearest.number, 0, 40) + inside / 3;
        return (inside < 48 ? 40 + (body - 40) * inside / 48 : body) + grain.jitter(column, row, 6);
    });
}

}

const std::vector<std::string>& exemplar_patterns()
{
    static const std::vector<std::string> names{"noise",        "pebbles", "bricks", "ramp",
                                                "checkerboard", "fabric",  "clouds"};
    return names;
}

PngPixels synthetic_exemplar(const std::string& pattern, int size, std::uint64_t seed, PebblePlaces places)
{
    if (pattern == "pebbles") return pebbles(size, seed, places);
    if (pattern == "bricks") return bricks(size, seed);
    if (pattern == "fabric") return fabric(size, seed);
    if (pattern == "clouds") return clouds(size, seed);
    if (pattern == "ramp") return pattern_of(size, [&](int x, int) { return 255 * x / (size - 1); });
    if (pattern == "checkerboard")
        return pattern_of(size, [](int x, int y) {
            return (x / check_pixels_a_square + y / check_pixels_a_square) % 2 == 0 ? 200 : 60;
        });
    const PatternWords words(seed, 0);
    return pattern_of(size, [&](int x, int y) {
        return static_cast<int>(words.at(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)) >> 24);
    });
}

std::size_t pebble_count(int size)
{
    return static_cast<std::size_t>(std::max(4, size * size / (pebble_pixels * pebble_pixels)));
}

}
