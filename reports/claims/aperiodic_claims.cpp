// The dissertation's claims about aperiodic sets and their tilings: sections 3.1 and 8.3.
#include "reports/claims/claim_words.hpp"

#include <fmt/format.h>

namespace poissonlab {
namespace {

constexpr auto tables_kind = "aperiodic-tables";

std::optional<ClaimOutcome> set_is_aperiodic(const ClaimSeries& report)
{
    const auto tiles = report.scheme_number(tables_kind, "claimed_tiles");
    const auto width = report.scheme_number(tables_kind, "claimed_period_width");
    const auto height = report.scheme_number(tables_kind, "claimed_period_height");
    const auto smallest = report.scheme_number(tables_kind, "smallest_tiles");
    if (!tiles || !width || !height) return std::nullopt;
    const std::string others =
        smallest ? fmt::format("the smallest set of that time without a period that was found has {} tiles", *smallest)
                 : "";
    if (*width == 0) return ClaimOutcome{Agreement::open, joined_words({"no period was found", others})};
    return ClaimOutcome{
        Agreement::disagrees,
        joined_words({fmt::format("its {} tiles tile a torus of {} x {} tiles, and so repeat", *tiles, *width, *height),
                      others})};
}

std::optional<ClaimOutcome> tables_are_the_same(const ClaimSeries& report)
{
    const auto numbers = report.scheme_number(tables_kind, "numbers");
    const auto same = report.scheme_number(tables_kind, "same");
    const auto unavailable = report.scheme_number(tables_kind, "unavailable");
    if (!numbers || !same || !unavailable) return std::nullopt;
    const Agreement agreement = *same == *numbers       ? Agreement::agrees
                                : 2 * *same >= *numbers ? Agreement::partly
                                                        : Agreement::disagrees;
    return ClaimOutcome{
        agreement, fmt::format("{} of {} numbers; {} of sets that are not available", *same, *numbers, *unavailable)};
}

std::optional<ClaimOutcome> aperiodic_is_structured(const ClaimSeries& report)
{
    constexpr double by_chance = 0.0079; // of the strongest 0.1 % of frequencies
    int sets = 0, structured = 0;
    std::string words;
    for (const char* const name : {"ammann", "kari", "culik"})
        if (const auto share = report.scheme_number("diffraction", std::string("strongest_") + name)) {
            ++sets;
            structured += *share > 5 * by_chance;
            words = joined_words({words, fmt::format("{} {}", name, percent_words(*share))});
        }
    const auto stochastic = report.scheme_number("diffraction", "strongest_scanline-compact");
    if (sets == 0 || !stochastic) return std::nullopt;
    return ClaimOutcome{agreement_if(structured > 0),
                        joined_words({words, "stochastic " + percent_words(*stochastic),
                                      fmt::format("in {} of {} sets", structured, sets)})};
}

}

std::vector<PaperClaim> claims_about_aperiodic_sets()
{
    return {{"3.1-structured", "3.1", "Aperiodic tilings are sometimes very structured.",
             "in some tiling the strongest 0.1 % of the frequencies of one colour's power spectrum have more than five "
             "times "
             "the power that they have by chance, 0.79 %",
             aperiodic_is_structured},
            {"8.3-tables", "8.3", "Tables 8.1 to 8.7: numbers of tiles and colours of what five constructions make.",
             "all numbers that can be computed are the same", tables_are_the_same},
            {"8.3-smallest", "8.3",
             "44 corner tiles over 6 colours (figure 8.6) are the smallest aperiodic corner tile set currently known.",
             "refuted by a torus of these tiles; that none is found would not prove it, and leaves it open",
             set_is_aperiodic}};
}

}
