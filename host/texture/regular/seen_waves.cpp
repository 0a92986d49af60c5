#include "host/texture/regular/seen_waves.hpp"

#include "host/texture/regular/wave_comb.hpp"
#include "host/texture/regular/wave_tracking.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace poissonlab {
namespace {

/// Pictures are compared at this size while their angle is looked for.
constexpr int searched_side = 256;

/// Larger ones are halved first: places between pixels would show waves that are not there.
constexpr int most_searched_side = searched_side * 3 / 2;

/// Parts of the middle that are looked at have more pixels, those of the smaller side.
constexpr int least_part_side = 64;

/// The view is looked for up to where one side of the picture is this much nearer than its middle.
constexpr double most_slope = 0.45;

/// A picture that is as straight as this part of the share says keeps its pixels.
constexpr double straight_times = 1.05;

/// A picture whose harmonics stand out together keeps its pixels unless a slope adds this number of deviations. By
/// chance, one of two wrong slopes has up to three more than the other.
constexpr double least_slope_deviations = 3;

/// Waves of a smaller part are taken instead of those of a larger one where they stand out more than this many times as
/// much: threads differ in their light, and what a coarse copy has left of them may be regular by chance.
constexpr double clearer_times = 4;

/// Waves go on to the rim where their share in the whole picture is at least this part of the one in the middle.
constexpr double least_kept = 0.5;

/// Returns the light between the pixels of a map that has at least two rows and columns.
double linear_at(const LightMap& light, double x, double y)
{
    const int column = static_cast<int>(x), row = static_cast<int>(y);
    const double u = x - column, v = y - row;
    const double* const north = &light.values[light.index(column, row)];
    const double* const south = north + light.width;
    return (1 - v) * ((1 - u) * north[0] + u * north[1]) + v * ((1 - u) * south[0] + u * south[1]);
}

/// Returns half the width and height, without what is too fine for that: by weights of 1, 3, 3 and 1 along each axis.
LightMap halved_light(const LightMap& light)
{
    const auto mean = [](double before, double first, double second, double after) {
        return (before + 3 * first + 3 * second + after) / 8;
    };
    LightMap map{light.width / 2, light.height / 2, {}};
    map.values.resize(map.index(0, map.height));
    tbb::parallel_for(0, map.height, [&](int y) {
        std::vector<double> column;
        for (int x = 0; x < light.width; ++x)
            column.push_back(mean(light.at(x, std::max(0, 2 * y - 1)), light.at(x, 2 * y), light.at(x, 2 * y + 1),
                                  light.at(x, std::min(light.height - 1, 2 * y + 2))));
        for (int x = 0; x < map.width; ++x) {
            const auto at = [&](int i) { return column[static_cast<std::size_t>(std::clamp(i, 0, light.width - 1))]; };
            map.values[map.index(x, y)] = mean(at(2 * x - 1), at(2 * x), at(2 * x + 1), at(2 * x + 2));
        }
    });
    return map;
}

/// Returns the picture without what is too fine for a copy of two thirds of its size: by weights of 1, 2 and 1 along
/// each axis.
LightMap smoothed(const LightMap& light)
{
    LightMap map = light;
    const auto mean = [](double before, double at, double after) { return (before + 2 * at + after) / 4; };
    tbb::parallel_for(0, map.height, [&](int y) {
        std::vector<double> column;
        const int above = std::max(0, y - 1), below = std::min(map.height - 1, y + 1);
        for (int x = 0; x < map.width; ++x)
            column.push_back(mean(light.at(x, above), light.at(x, y), light.at(x, below)));
        for (int x = 0; x < map.width; ++x)
            map.values[map.index(x, y)] =
                mean(column[static_cast<std::size_t>(std::max(0, x - 1))], column[static_cast<std::size_t>(x)],
                     column[static_cast<std::size_t>(std::min(map.width - 1, x + 1))]);
    });
    return map;
}

/// The part of the middle of a plane as it is from straight above; slopes are those over this part.
LightMap from_above(const LightMap& light, const Slope& slope, double part)
{
    LightMap map{searched_side, searched_side, {}};
    map.values.reserve(map.index(0, searched_side));
    const double reach = slope.reach(), right = light.width - 1.001, bottom = light.height - 1.001;
    std::array<double, searched_side> place, columns, rows;
    for (int i = 0; i < searched_side; ++i)
        place[static_cast<std::size_t>(i)] = ((i + 0.5) * 2 / searched_side - 1) * reach;
    for (const double y : place) {
        for (std::size_t x = 0; x < place.size(); ++x) { // without branches, for several places at once
            const Place seen = slope.seen({place[x], y});
            columns[x] = std::clamp((part * seen.x + 1) / 2 * light.width - 0.5, 0.0, right);
            rows[x] = std::clamp((part * seen.y + 1) / 2 * light.height - 0.5, 0.0, bottom);
        }
        for (std::size_t x = 0; x < place.size(); ++x) map.values.push_back(linear_at(light, columns[x], rows[x]));
    }
    return map;
}

/// Spectra of a part of the middle as it is from above, for any slopes. They are kept, some 370 KB each, because all
/// searches look at the same slopes until they find a better one.
class SlopedSpectra
{
public:
    SlopedSpectra(const LightMap& light, double part) : light_(light), part_(part) {}

    double part() const { return part_; }

    /// Returns what `value` says of the spectrum at each slope.
    std::vector<double> values(const std::vector<Slope>& slopes,
                               const std::function<double(const WaveSpectrum&)>& value)
    {
        std::vector<std::optional<WaveSpectrum>*> spectra;
        for (const Slope& slope : slopes) spectra.push_back(&spectra_[{slope.east, slope.south}]);
        std::vector<double> values(slopes.size());
        tbb::parallel_for(std::size_t{0}, slopes.size(), [&](std::size_t i) {
            if (!*spectra[i]) spectra[i]->emplace(windowed(from_above(light_, slopes[i], part_)));
            values[i] = value(**spectra[i]);
        });
        return values;
    }

private:
    const LightMap& light_;
    double part_;
    std::map<std::pair<double, double>, std::optional<WaveSpectrum>> spectra_;
};

/// Finds the slope with which a picture has the largest `value`: on a grid, then around the best one in steps that
/// halve. The picture keeps its slope unless another one has more than `least`.
Slope found_slope(SlopedSpectra& spectra, double least, const std::function<double(const WaveSpectrum&)>& value)
{
    Slope best;
    double most = least;
    int reach = 4;
    std::set<std::pair<double, double>> seen; // places of two steps have been looked at before steps halve
    for (double step = 0.1; step > 0.002; step /= 2, reach = 2) {
        std::vector<Slope> slopes;
        for (int i = -reach; i <= reach; ++i)
            for (int j = -reach; j <= reach; ++j) {
                const Slope slope{best.east + i * step, best.south + j * step};
                if (std::abs(slope.east) + std::abs(slope.south) <= most_slope * spectra.part() &&
                    seen.insert({slope.east, slope.south}).second)
                    slopes.push_back(slope);
            }
        const std::vector<double> values = spectra.values(slopes, value);
        const auto largest = std::ranges::max_element(values);
        if (largest == values.end() || !(*largest > most)) continue;
        most = *largest;
        best = slopes[static_cast<std::size_t>(largest - values.begin())];
    }
    return best;
}

double strongest_share(const WaveSpectrum& spectrum) { return spectrum.strongest().share; }

double comb_deviations(const WaveSpectrum& spectrum) { return strongest_comb(spectrum).deviations; }

/// The waves that are regular in a part of the middle, in halves of the whole picture's sides.
struct PartWaves
{
    Slope slope;
    RegularWaves regular; ///< their places are periods over such a half
    double times = 0;     ///< of the strongest wave, if it is regular or not
};

PartWaves waves_of_part(const LightMap& level, double part)
{
    const bool is_fine = std::max(level.width, level.height) * part > searched_side;
    const LightMap light = is_fine ? smoothed(level) : level;
    PartWaves found;
    SlopedSpectra spectra(light, part);
    const WaveSpectrum straight(windowed(from_above(light, {}, part)));
    Slope slope = found_slope(spectra, straight_times * strongest_share(straight), strongest_share);
    const LightMap map = from_above(light, slope, part);
    found.regular = find_regular_waves(map);
    found.times = strongest_wave(map).times;
    if (found.regular.strongest.empty() || found.regular.is_comb) {
        const Slope of_comb = found_slope(spectra, comb_deviations(straight) + least_slope_deviations, comb_deviations);
        RegularWaves regular = find_regular_waves(from_above(light, of_comb, part));
        // Courses of bricks that are seen from the side stand out from there only: they keep the slope of their share.
        if (!regular.strongest.empty()) {
            slope = of_comb;
            found.regular = std::move(regular);
        }
    }
    if (!found.regular.strongest.empty()) found.times = found.regular.strongest[0].times;
    const double pixels = searched_side / (2 * slope.reach() * part);
    for (RegularWave& wave : found.regular.strongest) {
        wave.x *= pixels;
        wave.y *= pixels;
    }
    found.slope = {slope.east / part, slope.south / part};
    return found;
}

/// Follows the strongest wave, and with its slope the other one, to the rim; the other one is left out where it does
/// not go on so far. False if the strongest does not.
bool track(PartWaves& found, const LightMap& light, double part)
{
    std::vector<RegularWave>& waves = found.regular.strongest;
    const SeenWave first{waves[0].x, waves[0].y, found.slope};
    TrackedWave best = tracked(light, part, first, true);
    if (found.slope.east == 0 && found.slope.south == 0)
        if (const TrackedWave straight = tracked(light, part, first, false);
            straight.share * straight_times >= best.share)
            best = straight;
    found.slope = best.wave.slope;
    if (best.kept < least_kept || std::abs(found.slope.east) + std::abs(found.slope.south) > most_slope) return false;
    waves[0].x = best.wave.x;
    waves[0].y = best.wave.y;
    if (waves.size() == 1) return true;
    const TrackedWave other = tracked(light, part, {waves[1].x, waves[1].y, found.slope}, false);
    waves[1].x = other.wave.x;
    waves[1].y = other.wave.y;
    if (other.kept < least_kept) waves.pop_back();
    return true;
}

/// The smallest part of the middle that is looked at.
double least_part(int width, int height)
{
    return std::min(1.0, std::max(static_cast<double>(searched_side) / std::max(width, height),
                                  static_cast<double>(least_part_side) / std::min(width, height)));
}

}

double least_seen_period(const PngPixels& exemplar)
{
    const double part = least_part(exemplar.width, exemplar.height);
    return std::max(2.0, least_wave_period * part * std::max(exemplar.width, exemplar.height) / searched_side);
}

SeenWaves seen_waves(const PngPixels& exemplar)
{
    std::vector<LightMap> levels{lightness_map(exemplar)}; // each has half of the pixels a side of the one before
    const auto is_small = [](const LightMap& light, double part) {
        return std::max(light.width, light.height) * part <= most_searched_side ||
               std::min(light.width, light.height) <= 3;
    };
    while (!is_small(levels.back(), 1)) levels.push_back(halved_light(levels.back()));
    SeenWaves seen;
    const double least = least_part(exemplar.width, exemplar.height);
    PartWaves best, of_whole;
    double best_part = 0;
    const auto level_of = [&](double part) -> const LightMap& {
        return *std::ranges::find_if(levels, [&](const LightMap& its) { return is_small(its, part); });
    };
    for (double part = 1;; part = std::max(least, part / 2)) {
        PartWaves found = waves_of_part(level_of(part), part);
        seen.most_times = std::max(seen.most_times, found.times);
        const bool is_first = best.regular.strongest.empty();
        if (!found.regular.strongest.empty() && (is_first || found.times > clearer_times * best.times)) {
            best = std::move(found);
            best_part = part;
        }
        if (part == 1) of_whole = best;
        if (part == least) break;
    }
    if (!best.regular.strongest.empty()) {
        seen.is_lost = best_part < 1 && !track(best, level_of(best_part), best_part);
        if (seen.is_lost && !of_whole.regular.strongest.empty()) { // which is coarser, but everywhere
            best = std::move(of_whole);
            seen.is_lost = false;
        }
        seen.slope = best.slope;
        if (!seen.is_lost) seen.waves = best.regular.waves();
    }
    for (RegularWave& wave : seen.waves) {
        wave.x *= 2.0 / exemplar.width;
        wave.y *= 2.0 / exemplar.height;
    }
    return seen;
}

}
