// The comparison of the measures and curves of two series.
// The comparison of the numbers of two distributions: points and objects, textures, schemes.
#include "reports/diff/run_comparison.hpp"
#include "results/curve_tables.hpp"
#include "results/measures.hpp"
#include "results/periodograms.hpp"
#include "results/texture_measures.hpp"

#include <algorithm>

namespace poissonlab {
namespace {

std::size_t samples_of(const Series& series) { return static_cast<std::size_t>(series.realizations); }

/// Errors of several sets are those between them; one of one set is that by its tapers.
std::size_t spectral_samples_of(const Series& series)
{
    return series.realizations > 1 ? samples_of(series) : static_cast<std::size_t>(periodograms_of(series));
}

std::size_t samples_of(const MeasuredValue& value, const Series& series)
{
    return value.standard_error ? spectral_samples_of(series) : samples_of(series);
}

class SeriesNumbers
{
public:
    explicit SeriesNumbers(const SeriesComparison& pair) : pair_(pair)
    {
        const auto& a = *pair.before;
        const auto& b = *pair.after;
        terms_.same_seed = !pair.run_before->seed.empty() && pair.run_before->seed == pair.run_after->seed &&
                           pair.run_before->engine == pair.run_after->engine && a.parameters == b.parameters;
        terms_.deterministic = a.deterministic && b.deterministic;
        terms_.one_tile_set = a.sampler.ends_with("-tiles");
    }

    /// Everything of the catalogue that both or one of the series have, but for what was asked for.
    void add_measures()
    {
        for (const Measure& measure : measures())
            if (measure.kind != MeasureKind::setting)
                add(measure, measure.get(*pair_.before), measure.get(*pair_.after));
    }

    void add_curves();

    std::vector<NumberComparison> take() { return std::move(numbers_); }

private:
    /// Adds a number if at least one run has it; without a verdict if only one has.
    void add(const Measure& measure, const std::optional<MeasuredValue>& before,
             const std::optional<MeasuredValue>& after)
    {
        if (!before && !after) return;
        NumberComparison number = named(in_dimension(measure.name), in_dimension(measure.unit), measure.better);
        if (before) number.before = mean_of(measure, *before, *pair_.before);
        if (after) number.after = mean_of(measure, *after, *pair_.after);
        if (before && after)
            judge_both(number, measure, *before, *after);
        else
            number.note = before ? "only in the old results" : "only in the new results";
        numbers_.push_back(std::move(number));
    }

    /// A standard error of 0 with several samples: none is known.
    static SampleMean mean_of(const Measure& measure, const MeasuredValue& value, const Series& series)
    {
        const bool is_of_all = measure.kind == MeasureKind::estimate;
        return {value.value, value.standard_error.value_or(0), is_of_all ? samples_of(value, series) : 1};
    }

    void judge_both(NumberComparison& number, const Measure& measure, const MeasuredValue& before,
                    const MeasuredValue& after) const
    {
        if (measure.kind == MeasureKind::size)
            judge_size(number, before, after);
        else if (measure.kind == MeasureKind::time)
            judge_time(number, before, after);
        else if (!before.each.empty() && !after.each.empty())
            judge(number, before.each, after.each, terms_);
        else
            judge(number, terms_);
    }

    /// Sizes are exact, but what they are of may be chance: how many points a saturated set has, or a tile set.
    void judge_size(NumberComparison& number, const MeasuredValue& before, const MeasuredValue& after) const
    {
        if (!before.each.empty() && !after.each.empty())
            judge(number, before.each, after.each, terms_);
        else if (before.value == after.value)
            number.verdict = Verdict::identical;
        else if (terms_.one_tile_set && !terms_.same_seed)
            number.note = tile_set_note;
        else
            number.verdict = Verdict::changed;
    }

    /// Times compare on the same machine with the same device, driver and number of threads, and where there are
    /// several runs.
    void judge_time(NumberComparison& number, const MeasuredValue& before, const MeasuredValue& after) const
    {
        if (!before.each.empty() && !after.each.empty())
            judge_times(number, before.each, after.each);
        else if (before.value == after.value)
            number.verdict = Verdict::identical;
        if (pair_.run_before->machine == pair_.run_after->machine) return;
        number.verdict = Verdict::not_comparable;
        number.note = "other device, driver or threads";
    }

    static NumberComparison named(const std::string& quantity, const std::string& unit, Better better)
    {
        NumberComparison number;
        number.quantity = quantity;
        number.unit = unit;
        number.better = better;
        return number;
    }

    void add_curve(const std::string& quantity, const std::vector<CurvePoint>& before,
                   const std::vector<CurvePoint>& after, const std::string& place)
    {
        NumberComparison number = named(quantity, "", Better::neither);
        judge(number, before, after, place, terms_);
        numbers_.push_back(std::move(number));
    }

    const SeriesComparison& pair_;
    ComparisonTerms terms_;
    std::vector<NumberComparison> numbers_;
};

std::vector<CurvePoint> radial_curve(const Run& run, const Series& series)
{
    std::vector<CurvePoint> curve;
    for (const auto& bin : read_radial_table(run.folder / series.radial_file))
        curve.push_back({bin.frequency, {bin.power, bin.power_error, spectral_samples_of(series)}});
    return curve;
}

std::vector<CurvePoint> pair_curve(const Run& run, const Series& series)
{
    std::vector<CurvePoint> curve;
    for (const auto& bin : read_pair_correlation_table(run.folder / series.pair_correlation_file))
        curve.push_back({bin.distance, {bin.value, bin.standard_error, samples_of(series)}});
    return curve;
}

std::vector<CurvePoint> variance_curve(const Run& run, const Series& series)
{
    std::vector<CurvePoint> curve;
    for (const auto& bin : read_number_variance_table(run.folder / series.number_variance_file))
        curve.push_back({bin.radius, {bin.variance, bin.standard_error, samples_of(series)}});
    return curve;
}

void SeriesNumbers::add_curves()
{
    const auto& a = *pair_.before;
    const auto& b = *pair_.after;
    if (!a.radial_file.empty() && !b.radial_file.empty())
        add_curve("radially averaged power", radial_curve(*pair_.run_before, a), radial_curve(*pair_.run_after, b),
                  "frequency");
    if (!a.pair_correlation_file.empty() && !b.pair_correlation_file.empty())
        add_curve("pair correlation", pair_curve(*pair_.run_before, a), pair_curve(*pair_.run_after, b), "distance");
    if (!a.number_variance_file.empty() && !b.number_variance_file.empty())
        add_curve("number variance", variance_curve(*pair_.run_before, a), variance_curve(*pair_.run_after, b),
                  "radius");
}

}

std::vector<NumberComparison> compare_series(const SeriesComparison& pair)
{
    SeriesNumbers numbers(pair);
    numbers.add_measures();
    numbers.add_curves();
    return numbers.take();
}

namespace {

const DistributionNumber* find_number(const DistributionResult& result, const std::string& key)
{
    const auto found = std::ranges::find(result.numbers, key, &DistributionNumber::key);
    return found == result.numbers.end() ? nullptr : &*found;
}

/// Which way a number is better, by the catalogue of textures.
Better better_of(const DistributionResult& result, const std::string& key)
{
    if (!result.is_texture()) return Better::neither;
    const auto row = std::ranges::find(texture_measures(), key, &Measure::key);
    return row == texture_measures().end() ? Better::neither : row->better;
}

SampleMean mean_of_number(const DistributionResult& result, const DistributionNumber& number)
{
    const DistributionNumber* const sets = find_number(result, "sets");
    const bool has_error = sets && number.standard_error;
    return {number.value, number.standard_error.value_or(0), has_error ? static_cast<std::size_t>(sets->value) : 1};
}

/// The words of a comparison of that number, without values.
NumberComparison comparison_of(const DistributionResult& result, const DistributionNumber& number)
{
    NumberComparison words;
    words.quantity = number.title;
    words.unit = result.is_texture() ? number.meaning : "";
    words.better = better_of(result, number.key);
    return words;
}

}

std::vector<NumberComparison> compare_distributions(const SeriesComparison& pair)
{
    const DistributionResult &before = *pair.distribution_before, &after = *pair.distribution_after;
    ComparisonTerms terms;
    terms.same_seed = !pair.run_before->seed.empty() && pair.run_before->seed == pair.run_after->seed &&
                      pair.run_before->engine == pair.run_after->engine && before.facts == after.facts;
    std::vector<NumberComparison> numbers;
    for (const DistributionNumber& old : before.numbers) {
        NumberComparison& number = numbers.emplace_back(comparison_of(before, old));
        number.before = mean_of_number(before, old);
        const DistributionNumber* const other = find_number(after, old.key);
        if (other) number.after = mean_of_number(after, *other);
        if (!other)
            number.note = "only in the old results";
        else if (old.is_time || other->is_time)
            number.note = "a time of the machine";
        else
            judge(number, terms);
    }
    for (const DistributionNumber& added : after.numbers) {
        if (find_number(before, added.key)) continue;
        NumberComparison& number = numbers.emplace_back(comparison_of(after, added));
        number.after = mean_of_number(after, added);
        number.note = "only in the new results";
    }
    return numbers;
}

}
