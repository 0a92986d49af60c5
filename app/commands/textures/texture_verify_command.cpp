// poissonlab texture verify: proves from the files of a texture set that its tiles fit together.
#include "app/commands/command.hpp"
#include "base/errors/errors.hpp"
#include "host/distribution/textures/texture_values.hpp"
#include "host/texture/seam_blending.hpp"
#include "tiles/texture/companion_maps.hpp"
#include "tiles/texture/seam_measures.hpp"
#include "tiles/texture/texture_certificate.hpp"
#include "tiles/texture/tiling_judge.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace poissonlab {
namespace {

constexpr auto texture_verify_notes =
    R"(Compares every pair of tiles that may lie side by side, pixel by pixel, through their places in the exemplar:
each pixel continues its neighbour across the border, or has the joint that the shared colours have everywhere. The pixels of
all rings with the same colours are the same, and all pixels those of their places; so are those of companions (--also) and
of exemplars with more than 8 bits, bit for bit. Seams that were blended are blended again, and tiles
that were levelled are levelled again. Exit status 2 if anything is not so.
Wang tiles have exceptions beside their corners, which are counted.
Seams inside of tiles: mismatch is how much both pictures differ there, excess how much the step from one to the other is
larger than their own; conspicuous steps are larger than 95 % of those of the exemplar. A line runs between two columns
or two rows of a tile.
What recurs with each tile is the share of the power of 32 x 32 tiles at whole multiples of one over a tile's side, less
what chance gives. A tiling with seed 1 is compared with the exemplar by measures that cuts do not optimise. A patch is new if its distance
from all patches of the exemplar is larger than that of 90 % of the patches in one half of the exemplar from the other
half. Fragments are connected pieces of the exemplar that are smaller than its features, where these are at most half as
large as a tile. Sets with marked exemplars are not compared.)";

struct TextureVerifyOptions
{
    std::filesystem::path folder;
    bool json = false;
};

TextureCertificate proof_of(const std::filesystem::path& folder, const TextureSet& set)
{
    try {
        const TextureCertificate proof = certify_texture(set);
        if (set.is_changed()) certify_changes(set);
        return proof;
    } catch (const InputError& error) {
        throw error.moved_to({folder.string()});
    }
}

/// Values of a judgement by their keys in the catalogue of measures, as far as the exemplar is large enough.
nlohmann::ordered_json judgement_json(const TilingJudgement& found)
{
    nlohmann::ordered_json json{{"feature_side", found.feature}};
    if (found.fragments) json["fragments"] = *found.fragments;
    for (std::size_t i = 0; i < judged_keys.size(); ++i)
        if (found.novelty[i]) {
            json[judged_keys[i]] = *found.novelty[i];
            json[std::string(judged_keys[i]) + "_patch"] = found.sides[i];
        }
    if (found.slow) {
        json["slow_power"] = found.slow->tiling;
        json["exemplar_slow_power"] = found.slow->exemplar;
    }
    return json;
}

void print_judgement(const TilingJudgement& found)
{
    for (std::size_t i = 0; i < judged_keys.size(); ++i)
        if (found.novelty[i])
            fmt::print("{:.1f} % of the patches of {} x {} pixels of a tiling are new\n", 100 * *found.novelty[i],
                       found.sides[i], found.sides[i]);
    if (found.fragments)
        fmt::print("{:.1f} fragments a tile are smaller than a feature of {} x {} pixels (fewer are better among sets "
                   "of one exemplar)\n",
                   *found.fragments, found.feature, found.feature);
    if (found.slow)
        fmt::print("{:.1f} % of a tiling's power is light that changes over more than a tile, {:.1f} % of the "
                   "exemplar's\n",
                   100 * found.slow->tiling, 100 * found.slow->exemplar);
}

/// Says what is proven and how visible seams are. Exemplars of one colour have no steps to compare with, and seams that
/// were blended are measured as they were before.
std::string verdict_on(const TextureSet& set, const TextureCertificate& proof, const SeamMeasures& seams)
{
    std::string verdict = "Verdict: proven, all tiles fit wherever they may lie side by side";
    if (proof.exceptions > 0) verdict += fmt::format(", but for {} pairs of pixels beside corners", proof.exceptions);
    if (seams.natural > 0 && !set.is_smoothed && !set.is_blended)
        verdict += fmt::format(". Steps that are large for this exemplar are {:.1f} times as frequent across seams as "
                               "in the exemplar: 1 is as good as the exemplar itself, and seams with more are visible",
                               seams.conspicuous / seams.natural);
    return verdict;
}

void verify_texture(const TextureVerifyOptions& options)
{
    const TextureSet set = read_texture_set(options.folder);
    const TextureCertificate proof = proof_of(options.folder, set);
    std::vector<std::pair<std::string, std::size_t>> companions; // atlases with their numbers of pixels
    for (const CompanionMap& map : set.companions)
        companions.emplace_back(map.atlas_file, certify_companion(options.folder, set, map));
    const SeamMeasures seams = seam_measures(set);
    const std::optional<TilingJudgement> found = judged_tiling(set, 1);
    const std::optional<double> recurs = set_recurrence(set, 1);
    if (options.json) {
        nlohmann::ordered_json json{{"folder", options.folder.string()},
                                    {"kind", texture_kinds[set.kind]},
                                    {"tiles", set.tiles.size()},
                                    {"tile_size", set.size},
                                    {"ring", set.ring},
                                    {"tile_pairs", proof.tile_pairs},
                                    {"pixel_pairs", proof.pixel_pairs},
                                    {"joints", proof.joints},
                                    {"exceptions", proof.exceptions},
                                    {"seam_pairs_a_tile", seams.pairs_a_tile},
                                    {"seam_mismatch", seams.mismatch},
                                    {"seam_excess", seams.excess},
                                    {"conspicuous_seams", seams.conspicuous},
                                    {"conspicuous_exemplar", seams.natural},
                                    {"longest_run", seams.longest_run},
                                    {"mean_seam_line", seams.mean_line},
                                    {"largest_seam_line", seams.largest_line},
                                    {"longest_seam_line", seams.longest_line},
                                    {"coverage", seams.coverage}};
        if (recurs) json["recurrence"] = *recurs;
        if (found) json.update(judgement_json(*found));
        for (const auto& [file, pixels] : companions) json["companions"][file] = pixels;
        fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
        return;
    }
    fmt::print("{}: {} {} tiles of {} x {} pixels, ring of {}\n", printable(options.folder.string()), set.tiles.size(),
               texture_kinds[set.kind], set.size, set.size, set.ring);
    fmt::print("{} pairs of tiles, {} pairs of pixels across their borders: {} are joints that the shared colours "
               "predict, {} beside corners do not fit, all others are contiguous\n",
               proof.tile_pairs, proof.pixel_pairs, proof.joints, proof.exceptions);
    fmt::print(
        "{:.0f} pairs of pixels a tile are seams{}: mismatch {:.2f} and excess {:.2f} of the exemplar's mean step; "
        "{:.1f} % of them conspicuous, {:.1f} % of the exemplar's steps; longest straight run {}; {:.0f} % of the "
        "exemplar is shown\n",
        seams.pairs_a_tile,
        set.is_smoothed  ? " before smoothing"
        : set.is_blended ? " before blending"
                         : "",
        seams.mismatch, seams.excess, 100 * seams.conspicuous, 100 * seams.natural, seams.longest_run,
        100 * seams.coverage);
    fmt::print("On average {:.1f} % of the pairs across a line of a tile are seams, at most {:.1f} %; the longest "
               "straight seam has {} pixels\n",
               100 * seams.mean_line, 100 * seams.largest_line, seams.longest_line);
    if (recurs) fmt::print("{}\n", recurrence_words(set, *recurs));
    if (found) print_judgement(*found);
    for (const auto& [file, pixels] : companions)
        fmt::print("{}: all {} pixels have the bits of their sources\n", printable(file), pixels);
    fmt::print("{}\n", verdict_on(set, proof, seams));
}

}

Command texture_verify_command()
{
    const auto o = std::make_shared<TextureVerifyOptions>();
    return {
        "verify",
        "Prove from its files that the tiles of a texture set fit together",
        {{"DIR", &o->folder, "The folder of a texture set, from texture build"}, {"--json", &o->json, "Print JSON"}},
        texture_verify_notes,
        action_on(o, verify_texture)};
}

}
