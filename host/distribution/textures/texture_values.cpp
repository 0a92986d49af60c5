#include "host/distribution/textures/texture_values.hpp"

#include "host/texture/comparison/light_map.hpp"
#include "host/texture/joint/phase_rule.hpp"
#include "results/texture_measures.hpp"
#include "tiles/texture/seam_measures.hpp"
#include "tiles/texture/texture_certificate.hpp"
#include "tiles/texture/texture_tiling.hpp"
#include "tiles/texture/tiling_judge.hpp"
#include "tiles/texture/tiling_measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {

void add_seam_values(const TextureSet& set, double tiles, TextureValues& values)
{
    const SeamMeasures seams = seam_measures(set);
    values["seam_pairs"] = seams.pairs_a_tile / tiles;
    values["seam_mismatch"] = seams.mismatch;
    values["seam_excess"] = seams.excess;
    values["conspicuous_seams"] = seams.conspicuous;
    values["longest_run"] = seams.longest_run;
    values["mean_seam_line"] = seams.mean_line;
    values["largest_seam_line"] = seams.largest_line;
    values["longest_seam_line"] = seams.longest_line;
    values["coverage"] = seams.coverage;
}

/// Adds measures that cuts do not optimise.
void add_judgement(const TextureSet& set, std::uint64_t seed, TextureValues& values)
{
    const std::optional<TilingJudgement> found = judged_tiling(set, seed);
    if (!found) return;
    for (std::size_t i = 0; i < judged_keys.size(); ++i)
        if (found->novelty[i]) values[judged_keys[i]] = *found->novelty[i];
    values["feature_side"] = found->feature;
    if (found->fragments) values["fragments"] = *found->fragments;
    if (!found->slow) return;
    values["slow_power"] = found->slow->tiling;
    values["exemplar_slow_power"] = found->slow->exemplar;
}

namespace {

/// Counts how often each tile lies at each of period x period places of a window.
std::vector<std::vector<double>> tile_counts(const TextureWindow& window, std::size_t tiles, std::size_t period)
{
    std::vector<std::vector<double>> counts(period * period, std::vector<double>(tiles));
    for (std::size_t i = 0; i < window.tiles.size(); ++i) {
        const std::size_t row = i / window.columns, column = i % window.columns;
        ++counts[row % period * period + column % period][window.tiles[i]];
    }
    return counts;
}

/// Subtracts the exemplar's means at their phase from the pixels of a tile, channel by channel.
std::vector<double> deviations(const TextureSet& set, std::size_t tile, const PhaseMeans& means)
{
    const auto values = set.values_of(tile);
    const auto sources = set.sources_of(tile);
    std::vector<double> all(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto channels = static_cast<std::size_t>(set.exemplar.channels);
        const SourcePixel source = sources[i / channels];
        all[i] = values[i] - means.at(source.x, source.y, static_cast<int>(i % channels));
    }
    return all;
}

}

std::optional<double> set_recurrence(const TextureSet& set, std::uint64_t seed)
{
    const auto period = static_cast<std::size_t>(recurrence_period(set));
    const std::size_t places = period * period, channels = static_cast<std::size_t>(set.exemplar.channels);
    const auto counts =
        tile_counts(texture_window(set, {0, 0, recurrence_tiles, recurrence_tiles}, seed), set.tiles.size(), period);
    const PhaseMeans means(set.exemplar,
                           set.classes == 1 ? fitting_waves(set.exemplar, set.size) : std::vector<RegularWave>{});
    std::vector<std::vector<double>> sums(places, std::vector<double>(set.pixels_a_tile() * channels));
    double all = 0; // sums of squares over pixels and channels, then without their means
    for (std::size_t tile = 0; tile < set.tiles.size(); ++tile) {
        const std::vector<double> its = deviations(set, tile, means);
        for (std::size_t place = 0; place < places; ++place) {
            const double count = counts[place][tile];
            for (std::size_t i = 0; i < its.size() && count > 0; ++i) {
                sums[place][i] += count * its[i];
                all += count * its[i] * its[i];
            }
        }
    }
    constexpr auto tiles = static_cast<double>(recurrence_tiles * recurrence_tiles);
    const double squares = tiles / static_cast<double>(places), pixels = static_cast<double>(set.pixels_a_tile());
    double lattice = 0;
    for (std::size_t c = 0; c < channels; ++c) {
        double sum = 0;
        for (const std::vector<double>& its : sums)
            for (std::size_t i = c; i < its.size(); i += channels) {
                sum += its[i];
                lattice += its[i] * its[i] / squares;
            }
        lattice -= sum * sum / (tiles * pixels);
        all -= sum * sum / (tiles * pixels);
    }
    if (!(all > 0)) return std::nullopt;
    return beyond_chance(lattice / all, squares, pixels * static_cast<double>(places));
}

std::string recurrence_words(const TextureSet& set, double recurrence)
{
    const TextureGate& gate = texture_gate("recurrence");
    return fmt::format(
        "{:.1f} % of a tiling's power recurs every {} pixels, beyond chance: {} the {:.0f} % that an eye "
        "notices",
        100 * recurrence, recurrence_period(set) * set.size, gate.passes(recurrence) ? "less than" : "more than",
        100 * gate.limit);
}

void add_picture_values(const PngPixels& picture, const PngPixels& exemplar, int size, TextureValues& values)
{
    values["lattice_power"] = lattice_power(picture, size, size);
    values["double_lattice_power"] = lattice_power(picture, 2 * size, 2 * size);
    values["color_distance"] = color_distance(picture, exemplar);
}

TextureValues tile_values(const TextureSet& set, std::uint64_t seed)
{
    const TextureCertificate proof = certify_texture(set);
    const auto pairs = static_cast<double>(proof.tile_pairs);
    const PngPixels tiling = texture_window_pixels(
        set, texture_window(set, {0, 0, measured_tiles, measured_tiles}, seed), set.values, set.exemplar.channels);
    const StepMap steps = step_map(tiling, set.exemplar, set.size);
    const std::size_t pixels = set.tiles.size() * set.pixels_a_tile();
    TextureValues values{{"tiles", static_cast<double>(set.tiles.size())},
                         {"atlas_pixels", static_cast<double>(pixels)},
                         {"atlas_bytes", static_cast<double>(pixels * static_cast<std::size_t>(set.exemplar.channels))},
                         {"fetches", 1},
                         {"border_joints", static_cast<double>(proof.joints) / pairs},
                         {"border_exceptions", static_cast<double>(proof.exceptions) / pairs},
                         {"border_step", steps.border},
                         {"largest_step", steps.largest}};
    add_seam_values(set, 1, values);
    add_judgement(set, seed, values);
    add_picture_values(tiling, set.exemplar, set.size, values);
    if (const auto recurs = set_recurrence(set, seed)) values["recurrence"] = *recurs;
    values["recurrence_width"] = recurrence_period(set) * set.size;
    return values;
}

void add_comparison(const PngPixels& exemplar, const TextureSquare& texture, int largest, TextureValues& values)
{
    if (std::min(exemplar.width, exemplar.height) < least_compared_side) return;
    const TextureComparison found = compare_texture(exemplar, texture, largest);
    const auto times = [](double distance, double own) { return own > 0 ? distance / own : 1; };
    values["histogram_spread"] = times(found.distances.colors, found.own.colors);
    values["histogram_largest"] = found.distances.largest;
    values["contrast"] = found.contrast;
    values["contrast_spread"] = times(found.distances.contrast, found.own.contrast);
    values["gradient_spread"] = times(found.distances.gradients, found.own.gradients);
    values["edge_loss"] = found.edges.lost / natural_edge_change(found);
    values["edge_gain"] = found.edges.gained / natural_edge_change(found);
    values["structure_spread"] = structure_times(found);
    values["peak_correlation"] = found.peak;
    values["peak_times"] = times(found.peak, found.chance_peak);
    values["contrast_peak"] = found.contrast_peak;
    values["contrast_peak_times"] = times(found.contrast_peak, found.chance_contrast_peak);
}

TextureSquare square_of_tiles(const TextureSet& set, std::uint64_t seed)
{
    return [&set, seed](int side) {
        const auto tiles = static_cast<std::uint64_t>((side + set.size - 1) / set.size);
        const PngPixels tiling = texture_window_pixels(set, texture_window(set, {0, 0, tiles, tiles}, seed), set.values,
                                                       set.exemplar.channels);
        return picture_part(tiling, 0, tiling.height - side, side, side);
    };
}

std::vector<DistributionNumber> texture_numbers(const std::vector<TextureValues>& sets)
{
    std::vector<DistributionNumber> numbers;
    const auto count = static_cast<double>(sets.size());
    for (const Measure& measure : texture_measures()) {
        if (measure.key == "sets") {
            numbers.push_back(texture_number(measure.key, count, std::nullopt));
            continue;
        }
        if (!sets.front().contains(measure.key)) continue; // of the first set alone
        double sum = 0, squares = 0;
        for (const TextureValues& values : sets) sum += values.at(measure.key);
        const double mean = sum / count;
        for (const TextureValues& values : sets) squares += std::pow(values.at(measure.key) - mean, 2);
        std::optional<double> error;
        if (sets.size() > 1) error = std::sqrt(squares / (count - 1) / count);
        numbers.push_back(texture_number(measure.key, mean, error));
    }
    return numbers;
}

}
