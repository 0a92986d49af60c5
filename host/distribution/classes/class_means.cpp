#include "host/distribution/classes/class_means.hpp"

#include "analysis/statistics/jackknife.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>

namespace poissonlab {
namespace {

using Curve = std::vector<double>;

std::optional<std::size_t> place_of(const UsedSpectra& set, std::uint32_t number)
{
    const auto found = std::ranges::lower_bound(set.classes, number);
    if (found == set.classes.end() || *found != number) return {};
    return static_cast<std::size_t>(found - set.classes.begin());
}

const Curve* power_of(const UsedSpectra& set, std::uint32_t number)
{
    const auto place = place_of(set, number);
    return place ? &set.spectra.power[*place] : nullptr;
}

/// Takes numbers in rising order.
const Curve* cross_of(const UsedSpectra& set, std::uint32_t first, std::uint32_t second)
{
    const auto i = place_of(set, first), j = place_of(set, second);
    return i && j ? &set.spectra.cross[*j * (*j - 1) / 2 + *i] : nullptr;
}

std::vector<std::uint32_t> classes_of_any(const std::vector<UsedSpectra>& sets)
{
    std::vector<std::uint32_t> classes;
    for (const UsedSpectra& set : sets) classes.insert(classes.end(), set.classes.begin(), set.classes.end());
    std::ranges::sort(classes);
    classes.erase(std::unique(classes.begin(), classes.end()), classes.end());
    return classes;
}

double mean_of_values(const std::vector<double>& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Appends the mean of the curves of those sets that have one, and its error.
template <typename CurveOf>
void add_mean(const std::vector<UsedSpectra>& sets, const CurveOf& curve_of, std::vector<Curve>& means,
              std::vector<Curve>& errors)
{
    const std::size_t bins = sets.front().spectra.bins();
    Curve mean(bins, std::numeric_limits<double>::quiet_NaN()), error = mean;
    std::vector<double> values;
    for (std::size_t k = 0; k < bins; ++k) {
        values.clear();
        for (const UsedSpectra& set : sets)
            if (const Curve* curve = curve_of(set)) values.push_back((*curve)[k]);
        if (!values.empty()) mean[k] = mean_of_values(values);
        if (values.size() > 1) error[k] = standard_error_of_mean(values);
    }
    means.push_back(std::move(mean));
    errors.push_back(std::move(error));
}

}

ClassSpectra mean_spectra(const std::vector<UsedSpectra>& sets)
{
    if (sets.size() == 1) return {1, sets.front().classes, sets.front().spectra, {}};
    ClassSpectra result{static_cast<std::uint32_t>(sets.size()), classes_of_any(sets), {}, {}};
    const std::vector<std::uint32_t>& classes = result.classes;
    for (const std::uint32_t number : classes)
        add_mean(
            sets, [&](const UsedSpectra& set) { return power_of(set, number); }, result.mean.power, result.error.power);
    add_mean(
        sets, [](const UsedSpectra& set) { return &set.spectra.power.back(); }, result.mean.power, result.error.power);
    for (std::size_t j = 0; j < classes.size(); ++j)
        for (std::size_t i = 0; i < j; ++i)
            add_mean(
                sets, [&](const UsedSpectra& set) { return cross_of(set, classes[i], classes[j]); }, result.mean.cross,
                result.error.cross);
    return result;
}

}
