// The dissertation's claims about Wang and corner tiles, tiling algorithms and hash functions: sections 2.6 to 3.5.
#include "reports/claims/claim_words.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace poissonlab {
namespace {

using TilingOutcome = std::optional<ClaimOutcome>;

constexpr auto cost_kind = "tiling-costs";
constexpr auto noise_kind = "noise";

/// "100 %"; shares here are far from 0.
std::string share_words(double share) { return format_significant(100 * share, 3) + " %"; }

TilingOutcome any_two_wang_tiles(const ClaimSeries& report)
{
    const auto complete = report.scheme_number("corner-problem", "wang_pairs");
    const auto compact = report.scheme_number("corner-problem", "compact_wang_pairs");
    const auto corner = report.scheme_number("corner-problem", "corner_pairs");
    if (!complete || !compact || !corner) return std::nullopt;
    return ClaimOutcome{
        agreement_if(*complete == 1 && *corner < 1),
        fmt::format("Wang tiles: {} of all ordered pairs of the complete set, {} of a compact one; corner "
                    "tiles: {}",
                    share_words(*complete), share_words(*compact), share_words(*corner))};
}

/// The scanline schemes of this report with compact sets: two choices, and 2 C^2 or 2 C^3 tiles.
TilingOutcome two_choices(const ClaimSeries& report)
{
    Cases cases;
    for (const DistributionResult* scheme : report.distributions("scanline")) {
        double tiles = 0, fewest = 0;
        for (const DistributionNumber& number : scheme->numbers) {
            if (number.key == "tiles") tiles = number.value;
            if (number.key == "fewest_choices") fewest = number.value;
        }
        if (std::ranges::none_of(scheme->facts, [](const std::string& fact) { return fact.ends_with("compact set"); }))
            continue;
        cases.add(fewest == 2, fmt::format("{} tiles: never fewer than {} fit", tiles, fewest));
    }
    return cases.uncounted();
}

TilingOutcome evaluations(const ClaimSeries& report, const std::vector<std::pair<std::string, double>>& expected)
{
    bool holds = true;
    std::string words;
    for (const auto& [key, count] : expected) {
        const auto counted = report.scheme_number(cost_kind, key + "_evaluations");
        if (!counted) return std::nullopt;
        holds = holds && *counted == count;
        words = joined_words({words, fmt::format("{}", *counted)});
    }
    return ClaimOutcome{agreement_if(holds), words};
}

/// A number beside the printed one.
TilingOutcome equals(const ClaimSeries& report, const std::string& kind, const std::string& key, double printed)
{
    const auto number = report.scheme_number(kind, key);
    if (!number) return std::nullopt;
    return ClaimOutcome{agreement_if(*number == printed), format_count(static_cast<std::uint64_t>(*number))};
}

/// The quotient of two times.
std::optional<double> time_ratio(const ClaimSeries& report, const std::string& first, const std::string& second)
{
    const auto a = report.scheme_number(cost_kind, first + "_ns"), b = report.scheme_number(cost_kind, second + "_ns");
    return a && b ? std::optional(*a / *b) : std::nullopt;
}

TilingOutcome direct_against_scanline(const ClaimSeries& report)
{
    const auto wang = time_ratio(report, "edge_hash_streamed", "scanline_wang");
    const auto corner = time_ratio(report, "corner_streamed", "scanline_corner");
    const auto wang_long = time_ratio(report, "edge_hash_long_streamed", "scanline_wang");
    const auto corner_long = time_ratio(report, "corner_long_streamed", "scanline_corner");
    if (!wang || !corner || !wang_long || !corner_long) return std::nullopt;
    return ClaimOutcome{
        Agreement::shown,
        fmt::format("of the time of scanlines: Wang tiles {}, corner tiles {} with a permutation table; "
                    "{} and {} with the long-period hash",
                    format_significant(*wang, 2), format_significant(*corner, 2), format_significant(*wang_long, 2),
                    format_significant(*corner_long, 2))};
}

TilingOutcome corner_is_fastest(const ClaimSeries& report)
{
    std::vector<std::string> words;
    for (const auto& [wang, name] : {std::pair("two_hashes", "two hash functions"),
                                     {"one_hash", "one hash function"},
                                     {"edge_hash", "hashes of edges"}}) {
        std::vector<double> ratios;
        for (const char* const where : {"_streamed", "_anywhere", "_long_streamed", "_long_anywhere"}) {
            const auto ratio = time_ratio(report, std::string("corner") + where, std::string(wang) + where);
            if (!ratio) return std::nullopt;
            ratios.push_back(*ratio);
        }
        words.push_back(fmt::format("{} of the time of {}", range_words(ratios, 2), name));
    }
    return ClaimOutcome{Agreement::shown, joined_words(words)};
}

TilingOutcome cost_of_tables(const ClaimSeries& report)
{
    const auto ratio = time_ratio(report, "corner_long_anywhere", "corner_anywhere");
    const auto tables = report.scheme_number(cost_kind, "tables");
    if (!ratio || !tables) return std::nullopt;
    return ClaimOutcome{Agreement::shown, fmt::format("{} tables: corner tiles anywhere take {} times as long", *tables,
                                                      format_significant(*ratio, 2))};
}

TilingOutcome almost_identical_parts(const ClaimSeries& report)
{
    const auto large = report.scheme_number(noise_kind, "parts_of_large");
    const auto small = report.scheme_number(noise_kind, "parts_of_small");
    if (!large || !small) return std::nullopt;
    return ClaimOutcome{
        agreement_if(*large < 0.1 && *small > 0.5),
        fmt::format("tables of 5 and 251 entries: parts differ by {} of what independent values do with "
                    "range 251, by {} with range 5",
                    share_words(*large), share_words(*small))};
}

TilingOutcome noise_time(const ClaimSeries& report)
{
    const auto hash = report.scheme_number(noise_kind, "hash_time_ratio");
    const auto noise = report.scheme_number(noise_kind, "noise_time_ratio");
    if (!hash || !noise) return std::nullopt;
    return ClaimOutcome{Agreement::shown,
                        fmt::format("{} and {} times", format_significant(*hash, 2), format_significant(*noise, 2))};
}

TilingOutcome same_appearance(const ClaimSeries& report)
{
    const auto plain = report.scheme_number(noise_kind, "plain_deviation");
    const auto combined = report.scheme_number(noise_kind, "long_deviation");
    const auto plain_repeat = report.scheme_number(noise_kind, "plain_repeat");
    const auto repeat = report.scheme_number(noise_kind, "long_repeat");
    if (!plain || !combined || !plain_repeat || !repeat) return std::nullopt;
    return ClaimOutcome{agreement_if(std::abs(*combined / *plain - 1) < 0.1),
                        fmt::format("standard deviations {} and {}; 256 cells away the correlation is {} and {}",
                                    format_significant(*plain, 3), format_significant(*combined, 3),
                                    format_significant(*plain_repeat, 2), format_significant(*repeat, 2))};
}

std::vector<PaperClaim> claims_about_algorithms()
{
    return {
        {"2.6-corner-problem", "2.6",
         "Wang tiles do not constrain their diagonal neighbours: any two can be put diagonally to each other by "
         "adding two suitable tiles; corner tiles do.",
         "all ordered pairs of the complete set of Wang tiles fit, not all of corner tiles", any_two_wang_tiles},
        {"3.2-choices", "3.2",
         "In a compact set there are two tiles for each combination of colours, and so always a random choice.",
         "the fewest tiles that fit at any place of any tiling are two", two_choices},
        {"3.3-corner-evaluations", "3.3", "Corner tiles need four evaluations of the hash function.", "counted: 4",
         [](const ClaimSeries& report) {
             return evaluations(report, {{"corner", 4}});
         }},
        {"3.3-wang-evaluations", "3.3",
         "Wang tiles by two hash functions need eight; by one hash function, or at the edges, four.",
         "counted: 8, 4 and 4",
         [](const ClaimSeries& report) {
             return evaluations(report, {{"two_hashes", 8}, {"one_hash", 4}, {"edge_hash", 4}});
         }},
        {"3.5-direct", "3.5", "Direct algorithms are at least as efficient as scanline algorithms.",
         "shown: times of a tile of a stream over those of a tile by scanlines, compact sets, on the machine of this "
         "report",
         direct_against_scanline},
        {"3.5-corner", "3.5", "Algorithms for corner tiles are usually more efficient than those for Wang tiles.",
         "shown: times of a tile over those by each of the three direct algorithms for Wang tiles, streamed and "
         "anywhere, "
         "with both hash functions, on the machine of this report",
         corner_is_fastest}};
}

}

std::vector<PaperClaim> claims_about_tilings()
{
    auto claims = claims_about_algorithms();
    const std::vector<PaperClaim> hashes{
        {"3.4-parts", "3.4",
         "With a small and a large table, and the size of the large one as range, the period has almost identical "
         "parts; with the small one as range it does not.",
         "below a tenth and above half of what independent values differ by", almost_identical_parts},
        {"3.4-time", "3.4",
         "The time of a combined hash function is roughly proportional to the number of tables; a program is not as "
         "many times slower.",
         "shown", cost_of_tables},
        {"3.4-period", "3.4", "The hash function for tilings has the period 5,930,659,848.", "the exact period is that",
         [](const ClaimSeries& report) { return equals(report, cost_kind, "period", 5'930'659'848.0); }},
        {"3.4-entries", "3.4", "The tables of the hash function for tilings have 180 entries.", "counted",
         [](const ClaimSeries& report) { return equals(report, cost_kind, "entries", 180); }},
        {"3.4-noise-period", "3.4", "The hash function for noise has the period 739,024.", "the exact period is that",
         [](const ClaimSeries& report) { return equals(report, noise_kind, "long_period", 739'024); }},
        {"3.4-noise-entries", "3.4", "The tables of the hash function for noise have 76 entries.", "counted",
         [](const ClaimSeries& report) { return equals(report, noise_kind, "long_entries", 76); }},
        {"3.4-noise-look", "3.4", "Noise with either hash function has the same appearance.",
         "standard deviations of the pictures differ by less than a tenth", same_appearance},
        {"3.4-noise-time", "3.4", "A hash takes about 5 times as long, noise about 2.5 times.", "shown", noise_time}};
    claims.insert(claims.end(), hashes.begin(), hashes.end());
    return claims;
}

}
