// The comparison of the numbers of two distributions: points and objects, textures, schemes.
#include "reports/diff/run_comparison.hpp"
#include "results/texture_measures.hpp"

#include <algorithm>

namespace poissonlab {

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
