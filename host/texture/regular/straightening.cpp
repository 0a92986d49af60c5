#include "host/texture/regular/straightening.hpp"

#include "base/errors/errors.hpp"
#include "tiles/texture/texture_set.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstring>
#include <type_traits>
#include <utility>

namespace poissonlab {
namespace {

/// Pictures are compared at this size while their angle is looked for.
constexpr int searched_side = 256;

/// Larger ones are halved first: places between pixels would show waves that are not there.
constexpr int most_searched_side = searched_side * 3 / 2;

/// Places that move by less than this stay where they are, in pixels.
constexpr double least_movement = 0.25;

/// The view is looked for up to where one side of the picture is this much nearer than its middle.
constexpr double most_slope = 0.45;

/// The longest period that is fitted to a tile, in tiles.
constexpr double most_period_in_tiles = 1.5;

struct Place
{
    double x = 0;
    double y = 0;
};

/// How a plane was seen: the place (x, y) of it, from the middle, in halves of the picture's sides, is at
/// (x, y) / (1 + east x + south y) of the picture.
struct Slope
{
    double east = 0;
    double south = 0;

    /// Half of the side of the square around the middle that lies within the picture.
    double reach() const { return 1 - std::abs(east) - std::abs(south); }
    Place seen(const Place& place) const
    {
        const double nearness = 1 + east * place.x + south * place.y;
        return {place.x / nearness, place.y / nearness};
    }
};

double linear_at(const LightMap& light, double x, double y)
{
    x = std::clamp(x, 0.0, light.width - 1.001);
    y = std::clamp(y, 0.0, light.height - 1.001);
    const int column = static_cast<int>(x), row = static_cast<int>(y);
    const double u = x - column, v = y - row;
    return (1 - v) * ((1 - u) * light.at(column, row) + u * light.at(column + 1, row)) +
           v * ((1 - u) * light.at(column, row + 1) + u * light.at(column + 1, row + 1));
}

/// Returns half the width and height, without what is too fine for that: by weights of 1, 3, 3 and 1 along each axis.
LightMap halved(const LightMap& light)
{
    constexpr std::array<double, 4> weights{1.0 / 8, 3.0 / 8, 3.0 / 8, 1.0 / 8};
    LightMap map{light.width / 2, light.height / 2, {}};
    const auto at = [&](int x, int y) {
        return light.at(std::clamp(x, 0, light.width - 1), std::clamp(y, 0, light.height - 1));
    };
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x) {
            double sum = 0;
            for (int j = 0; j < 4; ++j)
                for (int i = 0; i < 4; ++i)
                    sum += weights[static_cast<std::size_t>(i)] * weights[static_cast<std::size_t>(j)] *
                           at(2 * x - 1 + i, 2 * y - 1 + j);
            map.values.push_back(sum);
        }
    return map;
}

LightMap searched_map(const PngPixels& exemplar)
{
    LightMap light = lightness_map(exemplar);
    while (std::max(light.width, light.height) > most_searched_side && std::min(light.width, light.height) > 3)
        light = halved(light);
    return light;
}

/// The shortest period that is found, in pixels of the exemplar.
double least_found_period(const PngPixels& exemplar)
{
    return std::max(2.0,
                    least_wave_period * static_cast<double>(std::max(exemplar.width, exemplar.height)) / searched_side);
}

/// The plane as it is from straight above.
LightMap from_above(const LightMap& light, const Slope& slope)
{
    LightMap map{searched_side, searched_side, {}};
    const auto part = [&](int i) { return ((i + 0.5) * 2 / searched_side - 1) * slope.reach(); };
    for (int y = 0; y < searched_side; ++y)
        for (int x = 0; x < searched_side; ++x) {
            const Place seen = slope.seen({part(x), part(y)});
            map.values.push_back(
                linear_at(light, (seen.x + 1) / 2 * light.width - 0.5, (seen.y + 1) / 2 * light.height - 0.5));
        }
    return map;
}

/// The slope with which a wave has the largest share: on a grid, then around the best one in steps that halve.
Slope found_slope(const LightMap& light)
{
    Slope best;
    // A picture that is straight keeps its pixels.
    double share = 1.05 * strongest_wave(from_above(light, best)).share;
    int reach = 4;
    for (double step = 0.1; step > 0.002; step /= 2, reach = 2) {
        std::vector<Slope> slopes;
        for (int i = -reach; i <= reach; ++i)
            for (int j = -reach; j <= reach; ++j) {
                const Slope slope{best.east + i * step, best.south + j * step};
                if (std::abs(slope.east) + std::abs(slope.south) <= most_slope) slopes.push_back(slope);
            }
        std::vector<double> shares(slopes.size());
        tbb::parallel_for(std::size_t{0}, slopes.size(),
                          [&](std::size_t i) { shares[i] = strongest_wave(from_above(light, slopes[i])).share; });
        const auto largest = std::ranges::max_element(shares);
        if (!(*largest > share)) continue;
        share = *largest;
        best = slopes[static_cast<std::size_t>(largest - shares.begin())];
    }
    return best;
}

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

/// As many whole pixels, of which a source of that many has the same number left and right.
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

/// Weights of the pixels one before to two after a place between two pixels: Catmull and Rom.
std::array<double, 4> cubic_weights(double t)
{
    return {((2 - t) * t - 1) * t / 2, ((3 * t - 5) * t * t + 2) / 2, ((4 - 3 * t) * t + 1) * t / 2,
            (t - 1) * t * t / 2};
}

/// A picture's number at a place; `at` says it of a pixel. Numbers stay in the range of those around.
template <class At>
double cubic_at(double x, double y, int width, int height, const At& at)
{
    const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
    const std::array<double, 4> along = cubic_weights(x - column), down = cubic_weights(y - row);
    double sum = 0, lowest = 0, highest = 0;
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) {
            const double value = at(std::clamp(column + i - 1, 0, width - 1), std::clamp(row + j - 1, 0, height - 1));
            lowest = i + j == 0 ? value : std::min(lowest, value);
            highest = i + j == 0 ? value : std::max(highest, value);
            sum += along[static_cast<std::size_t>(i)] * down[static_cast<std::size_t>(j)] * value;
        }
    return std::clamp(sum, lowest, highest);
}

/// Calls `put` with the places in the source of all pixels, row by row.
template <class Put>
void for_all_places(const Straightening& map, const Put& put)
{
    const std::array<double, 9>& m = map.to_source;
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x) {
            const double w = m[6] * x + m[7] * y + m[8];
            put((m[0] * x + m[1] * y + m[2]) / w, (m[3] * x + m[4] * y + m[5]) / w);
        }
}

template <class Sample>
void straighten_samples(const RawPicture& picture, const Straightening& map, RawPicture& made)
{
    for_all_places(map, [&](double x, double y) {
        for (std::size_t c = 0; c < picture.channels.size(); ++c) {
            double value = cubic_at(x, y, picture.width, picture.height, [&](int column, int row) {
                Sample sample{};
                std::memcpy(&sample, &picture.bytes[picture.at(column, row) + c * sizeof(Sample)], sizeof(Sample));
                return static_cast<double>(sample);
            });
            if constexpr (std::is_integral_v<Sample>) value = std::round(value);
            const auto sample = static_cast<Sample>(value);
            std::array<std::uint8_t, sizeof(Sample)> bytes;
            std::memcpy(bytes.data(), &sample, sizeof(Sample));
            made.bytes.insert(made.bytes.end(), bytes.begin(), bytes.end());
        }
    });
}

}

Straightening straightening_for(const PngPixels& exemplar, int size)
{
    if (std::min(exemplar.width, exemplar.height) < size)
        throw InputError(fmt::format("size = {}: must be at most the exemplar's, {} x {} pixels", size, exemplar.width,
                                     exemplar.height));
    const LightMap light = searched_map(exemplar);
    const Slope slope = found_slope(light);
    std::vector<RegularWave> waves = regular_waves(from_above(light, slope));
    if (waves.empty())
        throw InputError(
            fmt::format("straighten = true: nothing in the picture is regular: its strongest wave of {:.0f} pixels and "
                        "more has {:.1f} times the power around it, of the {} that it needs",
                        std::ceil(least_found_period(exemplar)), strongest_wave(from_above(light, slope)).times,
                        least_regular_times));
    for (RegularWave& wave : waves) { // periods a pixel of the picture's middle
        wave.x *= searched_side / (slope.reach() * exemplar.width);
        wave.y *= searched_side / (slope.reach() * exemplar.height);
        if (wave.period() > most_period_in_tiles * size)
            throw InputError(fmt::format("size = {}: the picture repeats every {:.1f} pixels: must be at least {:.0f}",
                                         size, wave.period(), std::ceil(wave.period() / most_period_in_tiles)));
    }
    waves = waves_that_fit(std::move(waves), size);
    const Linear plane = plane_of_tiles(waves, size);
    const Place half = InnerRectangle(plane, slope, exemplar.width, exemplar.height).half();
    Straightening map{whole_pixels(2 * half.x, exemplar.width), whole_pixels(2 * half.y, exemplar.height), {}, {}, 1};
    if (std::min(map.width, map.height) < size)
        throw InputError(fmt::format("size = {}: must be at most the straightened exemplar's, {} x {} pixels", size,
                                     map.width, map.height));
    map.to_source = source_map(plane, slope, exemplar, map.width, map.height);
    keep_pixels_that_stay(map);
    map.scale = 1 / std::sqrt(std::abs(plane.determinant()));
    for (const RegularWave& wave : waves) {
        const Place whole = whole_periods(wave, size);
        map.periods.push_back(size / std::hypot(whole.x, whole.y));
    }
    return map;
}

PngPixels straightened(const PngPixels& picture, const Straightening& map)
{
    PngPixels made{map.width, map.height, picture.channels, {}};
    for_all_places(map, [&](double x, double y) {
        for (int c = 0; c < picture.channels; ++c) {
            const double value = cubic_at(x, y, picture.width, picture.height, [&](int column, int row) {
                return static_cast<double>(picture.values[picture.at(column, row, c)]);
            });
            made.values.push_back(static_cast<std::uint8_t>(std::lround(value)));
        }
    });
    return made;
}

RawPicture straightened(const RawPicture& picture, const Straightening& map)
{
    RawPicture made{map.width, map.height, picture.type, picture.channels, {}};
    switch (picture.type) {
    case SampleType::byte:
        straighten_samples<std::uint8_t>(picture, map, made);
        break;
    case SampleType::word:
        straighten_samples<std::uint16_t>(picture, map, made);
        break;
    case SampleType::real:
        straighten_samples<float>(picture, map, made);
        break;
    }
    return made;
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
    if (waves.front().period() <= most_period_in_tiles * size && waves.front().period() >= least_found_period(exemplar))
        ways.emplace_back("--straighten");
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
