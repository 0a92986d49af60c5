#include "reports/pages/ranking_order.hpp"

#include "reports/pages/verdicts.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace poissonlab {

namespace {

constexpr std::array choice_columns{
    ChoiceColumn{"relative_radius", "Mean relative radius ρ", "a lattice: 1"},
    ChoiceColumn{"mean_nearest_distance", "Mean nearest distance", "a lattice: 1"},
    ChoiceColumn{"low_frequency_mean", "Power at low frequencies", "random: 1"},
    ChoiceColumn{"effective_nyquist", "Effective Nyquist frequency", "{√N|∛N} / 2"},
    ChoiceColumn{"anisotropy_above_chance", "Anisotropy above chance", "dB"},
    ChoiceColumn{"zone_plate_error", "Zone plate error", "RMS"},
    ChoiceColumn{"sample_time", "Time to generate", "a set"},
};

/// Two values that are closer than this number of standard errors of their difference are as good.
constexpr double errors_apart = 2;

/// The low frequencies, up to root N / 4, whose mean power is a measure of its own, end at 0.5. Levels decide below:
/// jittered points have 0.25 and best candidate, whose power levels out at 0.13, just above the limit of 0.1, has 0.
constexpr double least_wide_range = 0.5;

struct Wish
{
    const char* what;
    const char* key;
    const char* before; ///< the value
    const char* after;
    double least = -1; ///< the value below which not even the best one is good
};

constexpr std::array wishes{
    Wish{"points far apart", "relative_radius", "mean ρ = ", ""},
    Wish{"little noise at low frequencies", "low_frequency_mean", "power ", ""},
    Wish{"the widest range almost without noise", "effective_nyquist", "Nyquist ", "", least_wide_range},
    Wish{"integrals across edges", "integration_disk", "squared error ", " of that of random points"},
    Wish{"speed", "sample_time", "", " a set"},
};

/// The ranked series of a dimension.
std::vector<const ReportSeries*> ranked_of(const std::vector<const ReportSeries*>& all, int dimension)
{
    std::vector<const ReportSeries*> ranked;
    std::ranges::copy_if(all, std::back_inserter(ranked), [&](const ReportSeries* series) {
        return series->run->dimension == dimension && is_ranked(*series);
    });
    return ranked;
}

/// True where the values of a measure say something about each other.
bool compare(const Measure& measure, const std::vector<const ReportSeries*>& series)
{
    if (measure.better == Better::neither) return false;
    return measure.kind != MeasureKind::time || std::ranges::all_of(series, [&](const ReportSeries* entry) {
               return entry->stored->points == series.front()->stored->points &&
                      entry->run->machine.text("device") == series.front()->run->machine.text("device");
           });
}

const ReportSeries* best_of(const Measure& measure, const std::vector<const ReportSeries*>& series)
{
    const ReportSeries* best = nullptr;
    double best_value = 0;
    for (const ReportSeries* entry : series) {
        const auto value = measure.get(*entry->stored);
        if (!value) continue;
        const bool is_better = measure.better == Better::higher ? value->value > best_value : value->value < best_value;
        if (best && !is_better) continue;
        best = entry;
        best_value = value->value;
    }
    return best;
}

}

const ChoiceColumn* choice_column(const std::string& key)
{
    const auto found =
        std::ranges::find_if(choice_columns, [&](const ChoiceColumn& column) { return column.key == key; });
    return found == choice_columns.end() ? nullptr : &*found;
}

bool is_ranked(const ReportSeries& series) { return !follows_density(series) && !is_not_periodic(series); }

std::vector<const ReportSeries*> ranking_order(std::vector<const ReportSeries*> series)
{
    const auto radius_of = [](const ReportSeries* entry) {
        return entry->stored->relative_radius ? entry->stored->relative_radius->mean : -1;
    };
    std::ranges::stable_sort(series, [&](const ReportSeries* a, const ReportSeries* b) {
        if (is_ranked(*a) != is_ranked(*b)) return is_ranked(*a);
        return radius_of(a) > radius_of(b);
    });
    return series;
}

bool is_as_good(const Measure& measure, const ReportSeries& series, const ReportSeries& best)
{
    const auto value = measure.get(*series.stored), best_value = measure.get(*best.stored);
    return value && best_value && is_as_good(measure, *value, *best_value);
}

bool is_as_good(const Measure& measure, const MeasuredValue& value, const MeasuredValue& best)
{
    const double error =
        std::hypot(standard_error_of(measure, value).value_or(0), standard_error_of(measure, best).value_or(0));
    return std::abs(value.value - best.value) <= errors_apart * error ||
           words_of(measure, value).shown == words_of(measure, best).shown;
}

const ReportSeries* best_to_mark(const Measure& measure, const std::vector<const ReportSeries*>& all, int dimension)
{
    const auto ranked = ranked_of(all, dimension);
    if (!compare(measure, ranked)) return nullptr;
    const ReportSeries* best = best_of(measure, ranked);
    const bool differs = best && std::ranges::any_of(ranked, [&](const ReportSeries* entry) {
                             return measure.get(*entry->stored) && !is_as_good(measure, *entry, *best);
                         });
    return differs ? best : nullptr;
}

std::vector<BestFor> best_series(const std::vector<const ReportSeries*>& all, int dimension)
{
    const auto ranked = ranked_of(all, dimension);
    if (ranked.size() < 2) return {};
    auto even = ranked;
    std::erase_if(even, [](const ReportSeries* series) { return has_directions(*series); });
    std::vector<BestFor> best;
    for (const Wish& wish : wishes) {
        const Measure& wanted = measure(wish.key);
        if (!compare(wanted, ranked)) continue;
        const ReportSeries* series = best_of(wanted, even.empty() ? ranked : even);
        if (series && wanted.get(*series->stored)->value < wish.least) continue;
        const auto is_best = [&](const ReportSeries* other) {
            return !wanted.get(*other->stored) || is_as_good(wanted, *other, *series);
        };
        if (!series || std::ranges::all_of(ranked, is_best)) continue; // none is better than another
        const MeasureWords words = words_of(wanted, *wanted.get(*series->stored));
        best.push_back({wish.what, series, wish.before + words.shown + wish.after});
    }
    return best;
}

std::string blue_noise_words(const std::vector<const ReportSeries*>& all, int dimension)
{
    constexpr std::size_t most_named = 6;
    std::vector<std::string> parts;
    for (const char* answer : {"Yes", "Weakly", "No"}) {
        std::vector<std::string> names;
        for (const ReportSeries* series : ranked_of(all, dimension))
            if (series->stored->blue_noise && series->stored->blue_noise->answer.substr(1) == answer + 1)
                names.push_back(series->full_label);
        if (names.size() > most_named) names = {format_count(names.size()) + " series"};
        if (!names.empty()) parts.push_back(fmt::format("{}: {}.", answer, fmt::join(names, "; ")));
    }
    return parts.empty() ? "" : fmt::format("Blue noise? {}", fmt::join(parts, " "));
}

std::string directions_words(const std::vector<const ReportSeries*>& all, int dimension)
{
    constexpr std::size_t most_named = 6;
    std::vector<std::string> directed;
    bool is_known = false;
    for (const ReportSeries* series : ranked_of(all, dimension)) {
        is_known = is_known || anisotropy_above_chance(*series).has_value();
        if (has_directions(*series)) directed.push_back(series->full_label);
    }
    if (!is_known) return {};
    if (directed.empty()) return "None of them has preferred directions.";
    if (directed.size() > most_named)
        return fmt::format("{} of them have preferred directions, and are left out here.",
                           format_count(directed.size()));
    return fmt::format("Left out here for their preferred directions: {}.", fmt::join(directed, "; "));
}

std::string hidden_best_words(const std::vector<const ReportSeries*>& all, int dimension)
{
    const auto ranked = ranked_of(all, dimension);
    auto even = ranked;
    std::erase_if(even, [](const ReportSeries* series) { return has_directions(*series); });
    std::vector<std::string> parts;
    for (const Wish& wish : wishes) {
        const Measure& wanted = measure(wish.key);
        const ReportSeries* best = compare(wanted, ranked) ? best_of(wanted, ranked) : nullptr;
        if (!best || !has_directions(*best)) continue;
        const ReportSeries* shown = best_of(wanted, even);
        if (shown && !is_as_good(wanted, *shown, *best))
            parts.push_back(fmt::format("{} for {}", best->full_label, wish.what));
    }
    return parts.empty() ? "" : fmt::format("Of all series, the best would be {}.", fmt::join(parts, "; "));
}

}
