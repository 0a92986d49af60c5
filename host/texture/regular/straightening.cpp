#include "host/texture/regular/straightening.hpp"

#include "base/errors/errors.hpp"
#include "host/texture/regular/seen_waves.hpp"
#include "tiles/texture/texture_set.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <complex>

namespace poissonlab {
namespace {

/// Places that move by less than this stay where they are, in pixels.
constexpr double least_movement = 0.25;

/// The longest period that is fitted to a tile, in tiles.
constexpr double most_period_in_tiles = 1.5;

constexpr int most_times_as_long = 8;

/// A linear map of the plane.
struct Linear
{
    double xx = 1, xy = 0, yx = 0, yy = 1;

    Place operator()(const Place& p) const { return {xx * p.x + xy * p.y, yx * p.x + yy * p.y}; }
    double determinant() const { return xx * yy - xy * yx; }
    Linear inverse() const
    {
        const double d = determinant();
        return {yy / d, -xy / d, -yx / d, xx / d};
    }
    Linear transposed() const { return {xx, yx, xy, yy}; }
};

Linear product(const Linear& a, const Linear& b)
{
    return {a.xx * b.xx + a.xy * b.yx, a.xx * b.xy + a.xy * b.yy, a.yx * b.xx + a.yy * b.yx, a.yx * b.xy + a.yy * b.yy};
}

/// Whole numbers of periods over a tile, those nearest to a wave's; at least one along an axis.
Place whole_periods(const RegularWave& wave, int size)
{
    Place whole{std::round(wave.x * size), std::round(wave.y * size)};
    if (whole.x == 0 && whole.y == 0)
        (std::abs(wave.x) >= std::abs(wave.y) ? whole.x : whole.y) =
            std::copysign(1.0, std::abs(wave.x) >= std::abs(wave.y) ? wave.x : wave.y);
    return whole;
}

/// Two waves as columns: as they are, or with whole numbers of periods over a tile.
Linear known_waves(const std::vector<RegularWave>& waves) { return {waves[0].x, waves[1].x, waves[0].y, waves[1].y}; }
Linear whole_waves(const std::vector<RegularWave>& waves, int size)
{
    const Place first = whole_periods(waves[0], size), second = whole_periods(waves[1], size);
    return {first.x / size, second.x / size, first.y / size, second.y / size};
}

/// The waves of which all can have whole numbers of periods: where that would mirror the picture, the first alone.
std::vector<RegularWave> waves_that_fit(std::vector<RegularWave> waves, int size)
{
    if (waves.size() == 2 && whole_waves(waves, size).determinant() * known_waves(waves).determinant() <= 0)
        waves.pop_back();
    return waves;
}

/// The map from places of the straightened picture to places of the plane as it is from straight above: a wave k of
/// the plane is the wave transposed(k) of the straightened picture.
Linear plane_of_tiles(const std::vector<RegularWave>& waves, int size)
{
    if (waves.size() == 2) return product(whole_waves(waves, size), known_waves(waves).inverse()).transposed();
    const Place first = whole_periods(waves[0], size);
    // As complex numbers, the quotient of two waves turns and scales one into the other.
    const std::complex<double> turn =
        std::complex(first.x, first.y) / static_cast<double>(size) / std::complex(waves[0].x, waves[0].y);
    return Linear{turn.real(), -turn.imag(), turn.imag(), turn.real()}.transposed();
}

/// The largest rectangle of a shape around the middle, grown along each axis, that lies within the picture.
class InnerRectangle
{
public:
    InnerRectangle(const Linear& plane, const Slope& slope, double width, double height)
        : plane_(plane), slope_(slope), half_width_(width / 2), half_height_(height / 2)
    {
        const double size = largest([&](double part) { return Place{part * half_width_, part * half_height_}; });
        half_ = {size * half_width_, size * half_height_};
        const double wider = largest([&](double part) { return Place{part * half_width_, half_.y}; });
        half_.x = wider * half_width_;
        const double higher = largest([&](double part) { return Place{half_.x, part * half_height_}; });
        half_.y = higher * half_height_;
    }

    Place half() const { return half_; }

private:
    /// The largest part with which all corners are within the picture; what is between them is within as well.
    template <class Half>
    double largest(const Half& half) const
    {
        double low = 0, high = 2;
        for (int i = 0; i < 40; ++i) (holds(half((low + high) / 2)) ? low : high) = (low + high) / 2;
        return low;
    }

    bool holds(const Place& half) const
    {
        for (const double x : {-half.x, half.x})
            for (const double y : {-half.y, half.y}) {
                const Place above = plane_({x, y});
                const Place part{above.x / half_width_, above.y / half_height_};
                if (1 + slope_.east * part.x + slope_.south * part.y <= 0) return false;
                const Place seen = slope_.seen(part);
                if (std::abs(seen.x) > 1 || std::abs(seen.y) > 1) return false;
            }
        return true;
    }

    Linear plane_;
    Slope slope_;
    double half_width_, half_height_;
    Place half_;
};

/// The numbers of Straightening::to_source.
std::array<double, 9> source_map(const Linear& plane, const Slope& slope, const PngPixels& exemplar, int width,
                                 int height)
{
    // From columns and rows to places around the middle, to the plane, to the picture's.
    const double half_x = exemplar.width / 2.0, half_y = exemplar.height / 2.0;
    const double left = (1 - width) / 2.0, top = (1 - height) / 2.0;
    const std::array<double, 3> x{plane.xx, plane.xy, plane.xx * left + plane.xy * top},
        y{plane.yx, plane.yy, plane.yx * left + plane.yy * top};
    std::array<double, 9> map{};
    for (std::size_t i = 0; i < 3; ++i) {
        map[6 + i] = slope.east * x[i] / half_x + slope.south * y[i] / half_y + (i == 2 ? 1 : 0);
        map[i] = x[i] + (half_x - 0.5) * map[6 + i];
        map[3 + i] = y[i] + (half_y - 0.5) * map[6 + i];
    }
    return map;
}

/// Rounds a side down to whole pixels, and by one more where a source of `source` pixels could not be centred on them.
int whole_pixels(double side, int source)
{
    const int pixels = static_cast<int>(side + 1e-6);
    return pixels - std::abs(source - pixels) % 2;
}

/// Pixels that hardly move stay what they are.
void keep_pixels_that_stay(Straightening& map)
{
    std::array<double, 9>& m = map.to_source;
    const auto seen = [&](double x, double y) {
        const double w = m[6] * x + m[7] * y + m[8];
        return Place{(m[0] * x + m[1] * y + m[2]) / w, (m[3] * x + m[4] * y + m[5]) / w};
    };
    const double right = map.width - 1, bottom = map.height - 1;
    const Place middle = seen(right / 2, bottom / 2);
    const double left = std::round(middle.x - right / 2), top = std::round(middle.y - bottom / 2);
    for (const double x : {0.0, right})
        for (const double y : {0.0, bottom}) {
            const Place place = seen(x, y);
            if (std::abs(place.x - x - left) > least_movement || std::abs(place.y - y - top) > least_movement) return;
        }
    m = {1, 0, left, 0, 1, top, 0, 0, 1};
}

/// Says why nothing is regular: waves stand out too little, or hold too little.
InputError nothing_regular(const PngPixels& exemplar, const SeenWaves& seen)
{
    const std::string begin = "straighten = true: nothing in the picture is regular: ";
    if (seen.most_times >= least_regular_times)
        return InputError(begin +
                          fmt::format("its waves hold less than {:.0f} % of its variance", 100 * least_regular_share));
    return InputError(begin + fmt::format("its strongest wave of {:.0f} pixels and more has {:.1f} times the power "
                                          "around it and needs {} times, and no harmonics stand out together",
                                          std::ceil(least_seen_period(exemplar)), seen.most_times,
                                          least_regular_times));
}

/// Copies in which waves are looked for are as long as they are wide; of longer pictures they would show others.
void check_sides(const PngPixels& exemplar)
{
    if (std::max(exemplar.width, exemplar.height) > most_times_as_long * std::min(exemplar.width, exemplar.height))
        throw InputError(fmt::format("straighten = true: the picture has {} x {} pixels: must be at most {} times as "
                                     "long as wide",
                                     exemplar.width, exemplar.height, most_times_as_long));
}

bool can_be_straightened(const PngPixels& exemplar, int size)
{
    try {
        straightening_for(exemplar, size);
        return true;
    } catch (const InputError&) {
        return false;
    }
}

}

Straightening straightening_for(const PngPixels& exemplar, int size)
{
    if (std::min(exemplar.width, exemplar.height) < size)
        throw invalid_value(
            {}, "size", fmt::format("{}", size),
            fmt::format("must be at most the exemplar's, {} x {} pixels", exemplar.width, exemplar.height));
    check_sides(exemplar);
    const SeenWaves seen = seen_waves(exemplar);
    if (seen.is_lost)
        throw InputError("straighten = true: what is regular in the picture's middle does not go on to its rim");
    if (seen.waves.empty()) throw nothing_regular(exemplar, seen);
    for (const RegularWave& wave : seen.waves)
        if (wave.period() > most_period_in_tiles * size)
            throw invalid_value({}, "size", fmt::format("{}", size),
                                fmt::format("the picture repeats every {:.1f} pixels: must be at least {:.0f}",
                                            wave.period(), std::ceil(wave.period() / most_period_in_tiles)));
    const std::vector<RegularWave> waves = waves_that_fit(seen.waves, size);
    const Linear plane = plane_of_tiles(waves, size);
    const Place half = InnerRectangle(plane, seen.slope, exemplar.width, exemplar.height).half();
    Straightening map{whole_pixels(2 * half.x, exemplar.width), whole_pixels(2 * half.y, exemplar.height), {}, {}, 1};
    if (std::min(map.width, map.height) < size)
        throw invalid_value(
            {}, "size", fmt::format("{}", size),
            fmt::format("must be at most the straightened exemplar's, {} x {} pixels", map.width, map.height));
    map.to_source = source_map(plane, seen.slope, exemplar, map.width, map.height);
    keep_pixels_that_stay(map);
    map.scale = 1 / std::sqrt(std::abs(plane.determinant()));
    for (const RegularWave& wave : waves) {
        const Place whole = whole_periods(wave, size);
        map.periods.push_back(size / std::hypot(whole.x, whole.y));
    }
    return map;
}

std::string straightening_note(const Straightening& map)
{
    std::string periods = fmt::format("{:.4g}", map.periods.front());
    if (map.periods.size() > 1) periods += fmt::format(" and {:.4g}", map.periods.back());
    return fmt::format(
        "straightened to {} x {} pixels: what is regular has periods of {} pixels, and {:.3g} of its size", map.width,
        map.height, periods, map.scale);
}

std::string regularity_note(const PngPixels& exemplar, int size)
{
    const std::vector<RegularWave> waves = regular_waves(lightness_map(exemplar));
    const auto fits = [&](int other) {
        return std::ranges::all_of(waves, [other](const RegularWave& wave) { return fits_tiles(wave, other); });
    };
    if (fits(size)) return "";
    std::string periods = fmt::format("{:.1f}", waves.front().period());
    if (waves.size() > 1) periods += fmt::format(" and {:.1f}", waves.back().period());
    const std::string begin =
        fmt::format("the picture repeats every {} pixels, which does not fit tiles of {}", periods, size);
    std::vector<std::string> ways;
    if (can_be_straightened(exemplar, size)) ways.emplace_back("--straighten");
    const int largest = std::min({most_tile_pixels, exemplar.width, exemplar.height});
    for (int away = 2; away <= size / 2 && ways.size() < 2; away += 2)
        for (const int other : {size - away, size + away})
            if (other >= least_tile_pixels && other <= largest && fits(other)) {
                ways.push_back(fmt::format("--size {}", other));
                break;
            }
    return ways.empty() ? begin : fmt::format("{}: joints run through with {}", begin, fmt::join(ways, ", or with "));
}

}
