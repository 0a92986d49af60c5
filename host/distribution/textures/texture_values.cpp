#include "host/distribution/textures/texture_values.hpp"

#include "host/texture/comparison/light_map.hpp"
#include "results/texture_measures.hpp"
#include "tiles/texture/seam_measures.hpp"
#include "tiles/texture/texture_certificate.hpp"
#include "tiles/texture/texture_tiling.hpp"
#include "tiles/texture/tiling_judge.hpp"
#include "tiles/texture/tiling_measures.hpp"

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

void add_picture_values(const PngPixels& picture, const PngPixels& exemplar, int size, bool is_of_one,
                        TextureValues& values)
{
    values["lattice_power"] = lattice_power(picture, size);
    values["double_lattice_power"] = lattice_power(picture, 2 * size);
    values["color_distance"] = color_distance(picture, exemplar);
    const auto repeated = repetition(picture, exemplar, size);
    if (!repeated || !is_of_one) return; // two exemplars side by side have no repetition of their own
    values["exemplar_power"] = repeated->exemplar_power;
    values["repetition"] = repeated->times;
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
    add_picture_values(tiling, set.exemplar, set.size, set.classes == 1, values);
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
