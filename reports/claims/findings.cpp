#include "reports/claims/findings.hpp"

#include "analysis/statistics/welch.hpp"
#include "base/word_table.hpp"

#include <fmt/format.h>

#include <cmath>

namespace poissonlab {
namespace {

constexpr double errors_that_decide = 2;

double reach_of(const Estimate& value) { return errors_that_decide * value.standard_error.value_or(0); }

/// The error of a sum of independent values; none where neither has one.
std::optional<double> joint_error(const std::optional<double>& first, const std::optional<double>& second)
{
    if (!first && !second) return std::nullopt;
    return std::hypot(first.value_or(0), second.value_or(0));
}

}

const char* name_of(Agreement agreement)
{
    constexpr WordTable<Agreement, 5> words{{{{Agreement::agrees, "agrees"},
                                              {Agreement::partly, "partly"},
                                              {Agreement::disagrees, "disagrees"},
                                              {Agreement::open, "open"},
                                              {Agreement::shown, "shown"}}}};
    return words[agreement];
}

Finding is_above(const Estimate& value, double limit)
{
    if (value.value - reach_of(value) > limit) return Finding::holds;
    return value.value + reach_of(value) <= limit ? Finding::fails : Finding::open;
}

Finding is_below(const Estimate& value, double limit) { return is_above({-value.value, value.standard_error}, -limit); }

Finding is_within(const Estimate& value, double low, double high)
{
    const double reach = reach_of(value);
    if (value.value - reach >= low && value.value + reach <= high) return Finding::holds;
    return value.value + reach < low || value.value - reach > high ? Finding::fails : Finding::open;
}

Finding both(Finding first, Finding second)
{
    if (first == Finding::fails || second == Finding::fails) return Finding::fails;
    return first == Finding::open || second == Finding::open ? Finding::open : Finding::holds;
}

Finding opposite(Finding finding)
{
    return finding == Finding::open ? Finding::open : finding_if(finding == Finding::fails);
}

Estimate difference_of(const Estimate& first, const Estimate& second)
{
    return {first.value - second.value, joint_error(first.standard_error, second.standard_error)};
}

Estimate ratio_of(const Estimate& first, const Estimate& second)
{
    const auto relative = [](const Estimate& value) -> std::optional<double> {
        if (!value.standard_error) return std::nullopt;
        return *value.standard_error / value.value;
    };
    Estimate ratio{first.value / second.value, joint_error(relative(first), relative(second))};
    if (ratio.standard_error) *ratio.standard_error *= ratio.value;
    return ratio;
}

Estimate mean_of_realizations(const Statistic& statistic)
{
    if (statistic.each.size() < 2) return {statistic.mean, {}};
    const SampleMean mean = sample_mean(statistic.each);
    return {mean.value, mean.standard_error};
}

void Tally::add(Finding finding)
{
    ++(finding == Finding::holds ? held_ : finding == Finding::fails ? failed_ : open_);
}

Agreement Tally::agreement() const
{
    const int decided = held_ + failed_;
    if (decided == 0 || 4 * decided < cases()) return Agreement::open;
    if (failed_ == 0) return Agreement::agrees;
    return 2 * held_ >= decided ? Agreement::partly : Agreement::disagrees;
}

std::string Tally::words() const
{
    const int decided = held_ + failed_;
    if (cases() < 2 && open_ == 0) return "";
    if (decided == 0) return open_ == 1 ? "not decided" : fmt::format("none of {} cases is decided", open_);
    const std::string held = fmt::format("holds in {} of {} cases", held_, decided);
    return open_ == 0 ? held : fmt::format("{}, {} more {} open", held, open_, open_ == 1 ? "is" : "are");
}

}
