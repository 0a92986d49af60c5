#include "reports/claims/comparison/tile_quality.hpp"

#include "reports/claims/claim_words.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

namespace poissonlab {
namespace {

/// Anisotropy between the peaks of the lattice is what few tiles leave, in dB above chance, and the mean peak is what
/// few points leave that tiles do not share. Chosen so that they tell apart what the dissertation calls good and bad.
constexpr double good_anisotropy_db = 2;
constexpr double good_peak = 300;

}

std::optional<ClaimOutcome> shown_spectra(const std::vector<SeriesPointer>& all, bool good,
                                          const std::function<bool(SeriesPointer)>& selected)
{
    int within = 0;
    std::vector<double> anisotropies, peaks, shares;
    for (SeriesPointer series : all) {
        const auto anisotropy = speckle(*series);
        const auto share = lattice_share(*series);
        if (!selected(series) || !anisotropy || !share) continue;
        anisotropies.push_back(*anisotropy);
        peaks.push_back(mean_peak(*series).value);
        shares.push_back(100 * share->value);
        within += anisotropies.back() <= good_anisotropy_db && peaks.back() <= good_peak;
    }
    if (peaks.empty()) return std::nullopt;
    const auto count = static_cast<int>(peaks.size());
    return ClaimOutcome{Agreement::shown,
                        joined_words({range_words(anisotropies, 2) + " dB above chance",
                                      fmt::format("mean peak {}", range_words(peaks, 2)),
                                      range_words(shares, 2) + " % of the power in the peaks",
                                      fmt::format("{} the limits: {} of {} series", good ? "within" : "beyond",
                                                  good ? within : count - within, count)})};
}

std::string calibration_criterion()
{
    return fmt::format("calibration, shown: limits of {} dB of anisotropy above chance between the peaks of the "
                       "lattice, and of a mean peak {} times the power around it, were chosen to tell apart what the "
                       "dissertation calls good and bad",
                       format_exact(good_anisotropy_db), format_exact(good_peak));
}

std::optional<ClaimOutcome> are_better(const std::vector<SeriesPointer>& all,
                                       const std::function<bool(SeriesPointer)>& selected)
{
    Cases cases;
    TileSetFlag flag;
    int mixed = 0;
    for (SeriesPointer good : all)
        for (SeriesPointer bad : all) {
            const auto x = speckle(*good), y = speckle(*bad);
            if (!selected(good) || selected(bad) || set_size(*bad) < 2 || !x || !y) continue;
            const auto share = lattice_share(*good), other = lattice_share(*bad);
            if (!share || !other) continue;
            const Finding peaks = is_below(difference_of(*share, *other), 0);
            const bool agree = peaks != Finding::open && (*x < *y) == (peaks == Finding::holds);
            mixed += !agree;
            cases.add(flag.if_several({good, bad}, agree ? peaks : Finding::open));
        }
    return cases.outcome(fmt::format("pairs of a good and a bad one: {}, of which {} are better in one "
                                     "measure only",
                                     cases.count(), mixed),
                         flag.words());
}

std::string order_criterion()
{
    return std::string("each spectrum that the dissertation calls good against each one that it does not: less "
                       "anisotropy between the peaks of the lattice, and a smaller share of the power on it, by two "
                       "standard errors. Pairs that differ in one of these only are open, as is a claim without a "
                       "quarter of its pairs; one tile alone, which has no power between its peaks, is left out; ") +
           several_sets_criterion;
}

}
