// Claims about texture tiles: chapter 5 of the dissertation; Cohen, Shade, Hiller, Deussen, Wang Tiles for Image and
// Texture Generation, 2003; Ng, Wen, Tan, Zhang, Kim, Generating an omega-Tile Set for Texture Synthesis, 2005.
//
// Placements are compared on one exemplar, with tiles of one size and as many of them, so at equal memory.
#include "reports/claims/claim_words.hpp"
#include "results/texture_measures.hpp"

namespace poissonlab {
namespace {

using Texture = DistributionResult;
using TextureOutcome = std::optional<ClaimOutcome>;

/// Smoothing changes what measures of seams cannot tell, marked corners show a second exemplar, and the papers do not
/// choose all tiles together.
bool is_plain_texture(const Texture& t)
{
    return t.parameter("smooth") == "false" && t.parameter("marked_exemplar").empty() &&
           t.parameter("joint") != "true" && t.parameter("straighten") != "true";
}

bool is_wang_texture(const Texture& t) { return is_plain_texture(t) && t.parameter("kind") == "wang"; }

/// Ng's placement, over complete sets or omega sets.
bool is_ng_texture(const Texture& t)
{
    return is_plain_texture(t) && t.parameter("kind") != "wang" && t.parameter("stages") == "1";
}

bool is_omega_texture(const Texture& t) { return is_ng_texture(t) && t.parameter("kind") == "omega"; }

bool is_cross_texture(const Texture& t)
{
    return is_plain_texture(t) && t.parameter("kind") == "corner" && t.parameter("stages") == "0";
}

using Choice = bool (*)(const Texture&);

/// Pairs of one and another placement at equal memory, on one exemplar.
std::vector<std::pair<const Texture*, const Texture*>> texture_pairs(const ClaimSeries& report, Choice one,
                                                                     Choice other)
{
    std::vector<std::pair<const Texture*, const Texture*>> pairs;
    for (const Texture* a : report.distributions("texture"))
        for (const Texture* b : report.distributions("texture"))
            if (one(*a) && other(*b) && a->parameter("exemplar") == b->parameter("exemplar") &&
                a->parameter("size") == b->parameter("size") && a->parameter("flatten") == b->parameter("flatten") &&
                number_of(*a, "tiles") == number_of(*b, "tiles"))
                pairs.emplace_back(a, b);
    return pairs;
}

/// Says whether a measure is below another one. Both are means over texture sets; of single sets it is not known how
/// much others differ.
Finding is_less(const Estimate& first, const Estimate& second, double sign)
{
    if (!first.standard_error || !second.standard_error) return Finding::open;
    const Estimate difference = difference_of(first, second);
    return is_below({sign * difference.value, difference.standard_error}, 0);
}

/// Judges that a measure of the first ones is below that of the second ones; `sign` -1: above.
TextureOutcome compared(const ClaimSeries& report, Choice one, Choice other, const std::string& key, double sign)
{
    Cases cases;
    std::vector<Estimate> of_one, of_other;
    for (const auto& [a, b] : texture_pairs(report, one, other)) {
        const auto first = estimate_in(*a, key), second = estimate_in(*b, key);
        if (!first || !second) continue;
        of_one.push_back(*first);
        of_other.push_back(*second);
        cases.add(is_less(*first, *second, sign));
    }
    return cases.outcome(range_words(of_one, 3) + " against " + range_words(of_other, 3));
}

TextureOutcome edges_fit(const ClaimSeries& report)
{
    Cases cases;
    std::vector<double> misfits;
    for (const Texture* texture : report.distributions("texture")) {
        const auto misfit = number_of(*texture, "border_exceptions");
        if (!is_wang_texture(*texture) || !misfit) continue;
        misfits.push_back(*misfit);
        cases.add(misfits.back() == 0);
    }
    return cases.outcome(range_words(misfits, 2) + " pairs of pixels a border do not fit");
}

TextureOutcome corners_fit(const ClaimSeries& report)
{
    Cases cases;
    std::vector<double> misfits;
    for (const Texture* texture : report.distributions("texture")) {
        const auto misfit = number_of(*texture, "border_exceptions");
        if (texture->parameter("kind") == "wang" || !misfit) continue;
        misfits.push_back(*misfit);
        cases.add(*misfit == 0);
    }
    return cases.outcome(range_words(misfits, 2) + " pairs of pixels a border do not fit");
}

bool is_marked_wang(const Texture& t)
{
    return t.parameter("kind") == "wang" && !t.parameter("marked_exemplar").empty() && t.parameter("colors") == "2";
}

/// 16 x 8 tiles for maps of marks, half of them for marks at random.
TextureOutcome marked_tile_counts(const ClaimSeries& report)
{
    Cases cases;
    std::vector<double> of_maps, of_random;
    for (const Texture* texture : report.distributions("texture")) {
        if (!is_marked_wang(*texture)) continue;
        const std::optional<double> tiles = number_of(*texture, "tiles");
        if (!tiles) continue;
        if (texture->parameter("tiles") == "compact") {
            of_maps.push_back(*tiles);
            cases.add(tiles == 128);
        }
        if (texture->parameter("tiles") == "random-marks") {
            of_random.push_back(*tiles);
            cases.add(tiles == 64);
        }
    }
    if (!of_maps.empty()) cases.say(range_words(of_maps, 3) + " tiles with all marks");
    if (!of_random.empty()) cases.say(range_words(of_random, 2) + " for marks at random");
    return cases.outcome();
}

bool is_wang_of(const Texture& t, const char* colors)
{
    return is_wang_texture(t) && t.parameter("tiles") == "compact" && t.parameter("colors") == colors;
}

TextureOutcome more_tiles_repeat_less(const ClaimSeries& report)
{
    Cases cases;
    std::vector<Estimate> few, many;
    for (const Texture* a : report.distributions("texture"))
        for (const Texture* b : report.distributions("texture")) {
            if (!is_wang_of(*a, "2") || !is_wang_of(*b, "3") || a->parameter("exemplar") != b->parameter("exemplar") ||
                a->parameter("size") != b->parameter("size"))
                continue;
            const auto of_few = estimate_in(*a, "lattice_power"), of_many = estimate_in(*b, "lattice_power");
            if (!of_few || !of_many) continue;
            few.push_back(*of_few);
            many.push_back(*of_many);
            cases.add(is_less(many.back(), few.back(), 1));
        }
    return cases.outcome(range_words(many, 2) + " of the power at 1/T, with 8 tiles " + range_words(few, 2));
}

TextureOutcome straightness(const ClaimSeries& report)
{
    Cases cases;
    std::vector<Estimate> of_omega, of_wang;
    for (const auto& [a, b] : texture_pairs(report, is_omega_texture, is_wang_texture)) {
        const auto omega = estimate_in(*a, "seam_mismatch"), wang = estimate_in(*b, "seam_mismatch");
        if (!a->parameter("exemplar").starts_with("brick") || !omega || !wang) continue;
        of_omega.push_back(*omega);
        of_wang.push_back(*wang);
        cases.add(is_less(*omega, *wang, -1));
    }
    return cases.outcome("mismatch " + range_words(of_omega, 3) + " against " + range_words(of_wang, 3));
}

TextureOutcome frames_of_mapping(const ClaimSeries& report)
{
    std::vector<double> rates;
    for (const Texture* texture : report.distributions("texture"))
        if (const auto rate = number_of(*texture, "frames")) rates.push_back(*rate);
    if (rates.empty()) return std::nullopt;
    return ClaimOutcome{Agreement::shown, range_words(rates, 3) + " frames a second on the report's device"};
}

}

std::vector<PaperClaim> claims_about_textures()
{
    return {
        {"5.3-corners", "5.3", "Corner tiles have no corner problem (section 2.6).",
         "no pixel at any border of two corner or omega tiles that does not go on or have a joint that the colours "
         "predict",
         corners_fit},
        {"5.3-new-patch", "5.3", "Ng's placement is the only one that adds new texture to each tile.",
         "tiles show more of the exemplar than those of the same scheme without new pieces, at equal memory, by two "
         "standard errors; open with one texture set of each",
         [](const ClaimSeries& report) { return compared(report, is_ng_texture, is_cross_texture, "coverage", -1); }},
        {"5.3-similar", "5.3",
         "Textures of corner tiles are usually more similar to the exemplar than those of Wang tiles.",
         "the distance of their colours from the exemplar's is smaller, at equal memory, by two standard errors; open "
         "with one texture set of each",
         [](const ClaimSeries& report) {
             return compared(report, is_ng_texture, is_wang_texture, "color_distance", 1);
         }},
        {"5.4-frames", "5.4",
         "Texture mapping by corner tiles runs at several hundred frames a second on a GeForce 7800 GTX.",
         "shown, as it depends on the device: frames of 1,024 × 576 pixels a second, between mipmap levels; the size "
         "of "
         "the dissertation's frames is unknown",
         frames_of_mapping},
    };
}

std::vector<Paper> papers_on_textures()
{
    return {
        {"cohen-2003",
         "Cohen, Shade, Hiller and Deussen, <cite>Wang Tiles for Image and Texture Generation</cite> (2003)",
         {{"cohen-2003-fit", "3.2",
           "Because the same sample is used for all tiles that share an edge colour, Wang tiles always fit together.",
           "no pixel at any border of two tiles that does not go on or have a joint that the colours predict",
           edges_fit},
          {"cohen-2003-more-tiles", "3.2", "Artefacts that come from few samples are overcome by more tiles.",
           "18 tiles have less power at multiples of 1/T than 8, by two standard errors; open with one texture set of "
           "each",
           more_tiles_repeat_less},
          {"cohen-2003-marked", "3.4",
           "With marked corners eight Wang tiles become 128, or 64 that still leave a random choice.",
           "as many tiles fit by edges and marks; 64 serve marks at random only, since a map, which gives the fourth "
           "mark as well, leaves one tile",
           marked_tile_counts}}},
        {"ng-2005",
         "Ng, Wen, Tan, Zhang and Kim, <cite>Generating an ω-Tile Set for Texture Synthesis</cite> (2005)",
         {{"ng-2005-large", "3.2", "Omega tiles repeat less visibly than Wang tiles.",
           "less power at multiples of 1/2T, at equal memory, by two standard errors; open with one texture set of "
           "each",
           [](const ClaimSeries& report) {
               return compared(report, is_omega_texture, is_wang_texture, "double_lattice_power", 1);
           }},
          {"ng-2005-junctions", "5", "Omega tiles have less prominent junctions than Wang tiles.",
           "a smaller part of their seams is conspicuous, at equal memory, by two standard errors; open with one "
           "texture "
           "set of each",
           [](const ClaimSeries& report) {
               return compared(report, is_omega_texture, is_wang_texture, "conspicuous_seams", 1);
           }},
          {"ng-2005-straight", "5", "On a regular brick wall omega tiles are inferior to Wang tiles.",
           "the mismatch at seams is larger, at equal memory, by two standard errors; open with one texture set of "
           "each",
           straightness}}},
    };
}

}
