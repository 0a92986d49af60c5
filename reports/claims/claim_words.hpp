// Measured values in words, and claims of kinds that occur several times.
#pragma once

#include "reports/claims/claim_curves.hpp"
#include "reports/claims/paper_claims.hpp"
#include "reports/layout/report_layout.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace poissonlab {

/// Joins parts that are not empty: "a; b; c".
std::string joined_words(const std::vector<std::string>& parts);

/// Says the range of values: "0.12 to 0.34", or one number where both ends look the same; empty without values.
std::string range_words(const std::vector<double>& values, int digits);

/// Says the range of values and their largest standard error: "0.12 to 0.34 (± 0.02)".
std::string range_words(const std::vector<Estimate>& values, int digits);

/// Writes a share in percent: "0.02 %".
std::string percent_words(double share);

/// Writes an estimate with its error: "0.123 ± 0.004", or the value alone where its error is not known.
std::string with_error(const Estimate& estimate, int decimals);

/// Collects the cases of a claim: whether it holds in each, and what was measured.
class Cases
{
public:
    /// Leaves the claim open where there are fewer cases than `fewest`.
    explicit Cases(int fewest = 1) : fewest_(fewest) {}

    void add(Finding finding, std::string words = "");
    void add(bool holds, std::string words = "") { add(finding_if(holds), std::move(words)); }

    /// Adds words that belong to no case.
    void say(std::string words) { words_.push_back(std::move(words)); }

    int count() const { return tally_.cases(); }

    // These functions say what all cases come to, and return nothing where there is no case.

    /// Joins the words of all cases, and says in how many of them the claim holds.
    std::optional<ClaimOutcome> outcome() const { return outcome(joined_words(words_)); }

    /// Joins the words of all cases without counting them.
    std::optional<ClaimOutcome> uncounted() const;

    /// Says these words instead of those of the cases, then in how many cases the claim holds, then `after`.
    std::optional<ClaimOutcome> outcome(const std::string& words, const std::string& after = "") const;

private:
    Agreement agreement() const { return count() < fewest_ ? Agreement::open : tally_.agreement(); }

    int fewest_;
    Tally tally_;
    std::vector<std::string> words_;
};

// These functions make judges for over(), which compare a value with limits as is_above() and the like do.
inline auto above(double limit)
{
    return [limit](const Estimate& value) { return is_above(value, limit); };
}
inline auto below(double limit)
{
    return [limit](const Estimate& value) { return is_below(value, limit); };
}
inline auto within(double low, double high)
{
    return [low, high](const Estimate& value) { return is_within(value, low, high); };
}

/// Judges a number of each series, an Estimate or nothing where a series has none, and says the range of these numbers
/// before `unit`.
template <class Number, class Judge>
std::optional<ClaimOutcome> over(const std::vector<const ReportSeries*>& all, const Number& number, const Judge& judge,
                                 int digits, const std::string& unit = "")
{
    Cases cases;
    std::vector<Estimate> values;
    for (const ReportSeries* series : all)
        if (const std::optional<Estimate> value = number(*series)) {
            values.push_back(*value);
            cases.add(judge(*value));
        }
    return cases.outcome(range_words(values, digits) + unit);
}

/// Makes the function that finds a measure of a series by its key, for over().
inline auto measured(const char* key)
{
    return [key](const ReportSeries& series) {
        const Estimate* found = estimate_of(series, key);
        return found == nullptr ? std::nullopt : std::optional(*found);
    };
}

/// Judges whether the picture of a series has false plates. It holds where one is stronger than noise makes once in ten
/// thousand pictures, and fails where none is stronger than noise makes once in a hundred. std::nullopt: there is no
/// picture.
std::optional<Finding> finds_false_plates(const ClaimSeries& report, const ReportSeries& series);

/// Judges the strongest false plates of series against those that noise alone makes. `should_alias`: the claim says
/// that the plates are stronger. std::nullopt if no series has a picture.
std::optional<ClaimOutcome> false_plates(const ClaimSeries& report, const std::vector<const ReportSeries*>& series,
                                         bool should_alias);
inline constexpr auto no_false_plates_criterion =
    "no false plate is stronger than noise makes once in 100 pictures; open up to what noise makes once in 10,000";
inline constexpr auto false_plates_criterion = "the strongest false plate is stronger than noise makes once in 10,000 "
                                               "pictures; open down to what noise makes once in 100";

/// Finds the series of a method that have the same density everywhere.
std::vector<const ReportSeries*> of_even_density(const ClaimSeries& report, const std::string& sampler,
                                                 SeriesQuery::Needs needs);

/// Finds the series of plane dart throwing with spectra whose relative radius is at least this one; full sets are among
/// them.
std::vector<const ReportSeries*> darts_as_large(const ClaimSeries& report, double relative_radius);

/// Judges whether the mean anisotropy of series over rings is that of chance.
std::optional<ClaimOutcome> has_low_anisotropy(const std::vector<const ReportSeries*>& series);
inline constexpr auto low_anisotropy_criterion =
    "the mean over rings of at least 100 samples is within 0.5 dB of −10 log10 K, what chance alone gives";

/// Asks for series of the dissertation's relaxation dart throwing, which starts from a radius of 0.15.
SeriesQuery relaxation_darts(double factor, double attempts, SeriesQuery::Needs needs = SeriesQuery::Needs::anything,
                             std::size_t points = usual_points);

/// Judges a radius against that of one set, which the text prints with two digits: it holds within half of the last
/// digit and two standard deviations over sets. It is open beyond half of the digit where the deviation is not known.
Finding is_radius_of_the_text(const Statistic& measured, double printed);
inline constexpr auto radius_of_the_text_criterion =
    "the mean is within half of the text's last digit and two standard deviations of realizations";

/// Judges by root mean square errors whether the first of two pictures of the zone plate, of one set each, is better.
Finding compared_plates(double error, double other_error);

/// Frequencies are in cycles per pixel: low ones are below plate_middle, high ones between it and plate_end, the
/// highest that pixels can show.
inline constexpr double plate_middle = 0.25, plate_end = 0.5;
inline constexpr auto better_plate_criterion = "lower root mean square error where the plate has a quarter to half a "
                                               "cycle per pixel; open within 5 %, as pictures "
                                               "are of one set each, and sets of a method differ by up to 3 %";

/// Shows the errors of pictures below a quarter of a cycle per pixel, beside those of dart throwing and of jittered
/// points.
std::optional<ClaimOutcome> shown_plate_errors(const ClaimSeries& report,
                                               const std::vector<const ReportSeries*>& plates);
inline constexpr auto shown_plate_errors_criterion = "shown, as no error is too large for it: root mean square errors "
                                                     "where the plate has up to a quarter of a cycle per "
                                                     "pixel, beside those of dart throwing and of jittered points";

/// A time of 2006, and the series whose time today stands beside it.
struct TimedSeries
{
    std::string name; ///< "ρ = 0.70"; empty where there is one
    SeriesQuery query;
};

/// Makes a claim that shows times then and now, with device and threads, without judging them. It is left out where no
/// series has a time.
PaperClaim time_claim(const std::string& id, const std::string& section, const std::string& says,
                      const std::vector<TimedSeries>& series);

/// Finds the series of a 2D method with half to twice as many points as the dissertation's sets: full ones have the
/// number that their minimum distance gives.
std::vector<const ReportSeries*> of_usual_size(const ClaimSeries& report, const std::string& sampler);

/// Shows the median times of methods for some 16,384 points, each from its fastest series to its slowest, and the
/// machines. Times depend on the machine, and on how a method is made here.
std::optional<ClaimOutcome> shown_times(const ClaimSeries& report, const std::vector<const char*>& samplers);
inline constexpr auto shown_times_criterion = "shown: medians for some 16,384 points, which depend on the machine";

/// Makes the claim that sets reach a relative radius, and no more. Sets that were asked for this radius, or are full,
/// refute it where they end below.
PaperClaim reach_claim(const std::string& id, const std::string& section, const std::string& says,
                       const SeriesQuery& query, double relative_radius);

/// Makes the claim that tiles reach a relative radius by Lloyd relaxation, as in the paper: where only series with
/// repulsion afterwards reach it, the claim holds in part.
PaperClaim reach_by_lloyd_claim(const std::string& id, const std::string& section, const std::string& says,
                                const SeriesQuery& query, double relative_radius);

/// Says whether a radial curve has the features of blue noise: little power at low frequencies, a peak near the
/// principal frequency, and power about 1 beyond.
struct BlueNoise
{
    Finding finding = Finding::open;
    std::string words;
};
BlueNoise blue_noise(const ReportSeries& series);
inline constexpr auto blue_noise_criterion =
    "mean power below 0.2 up to half the principal frequency of a relative radius of 0.75, by which the dissertation "
    "scales its figures; the highest power within a quarter of it; mean power within 0.1 of 1 from 1.5 times it on";

/// Judges whether all series have the features of blue noise, and says their numbers.
std::optional<ClaimOutcome> all_blue_noise(const std::vector<const ReportSeries*>& series);

/// Finds the median time of a set of a series; nothing where it is not timed.
std::optional<double> median_seconds(const ReportSeries& series);

}
