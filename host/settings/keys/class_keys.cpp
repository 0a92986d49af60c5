#include "host/settings/keys/class_keys.hpp"

#include "base/geometry/class_distances.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

/// The numbers of a list, whose lists count as their numbers, or of a single number; nothing where there is another
/// value.
std::optional<std::vector<double>> numbers_in(const ConfigNode& node)
{
    if (const auto* whole = node.get_if<std::int64_t>()) return std::vector{static_cast<double>(*whole)};
    if (const auto* real = node.get_if<double>()) return std::vector{*real};
    const auto* items = node.get_if<ConfigList>();
    if (!items) return {};
    std::vector<double> all;
    for (const ConfigNode& item : *items) {
        const auto some = numbers_in(item);
        if (!some) return {};
        all.insert(all.end(), some->begin(), some->end());
    }
    return all;
}

bool is_symmetric(const std::vector<double>& matrix, std::size_t rows)
{
    for (std::size_t i = 0; i < matrix.size(); ++i)
        if (matrix[i] != matrix[i % rows * rows + i / rows]) return false;
    return true;
}

}

Keys::Said class_list(Keys& keys, const std::string& key, std::vector<double>& values, Interval range,
                      const std::string& each, std::string help)
{
    const std::string allowed = fmt::format("{} of each class, at most {} of them", each, most_classes);
    return keys
        .value(key, allowed, std::move(help),
               [&](const ConfigNode& node) {
                   values = numbers_in(node).value_or(std::vector<double>{});
                   const auto is_allowed = [&](double v) { return v >= range.low && v <= range.high; };
                   if (values.empty() || values.size() > most_classes || !std::ranges::all_of(values, is_allowed))
                       throw keys.invalid(key, "must be " + allowed);
               })
        .at_most(most_classes);
}

Keys::Said class_counts(Keys& keys, const std::string& key, std::vector<std::size_t>& counts, std::int64_t most,
                        std::string help)
{
    std::vector<double> numbers;
    const Keys::Said said =
        class_list(keys, key, numbers, {1, static_cast<double>(most)}, "a whole number from 1", std::move(help));
    for (const double number : numbers) {
        if (number != std::floor(number)) throw keys.invalid(key, "must be whole numbers");
        counts.push_back(static_cast<std::size_t>(number));
    }
    return said;
}

Keys::Said class_matrix(Keys& keys, const std::string& key, std::vector<double>& matrix, Interval range)
{
    const std::string allowed = fmt::format(
        "rows of numbers from {:g} to {:g}, as many as classes, the same as columns", range.low, range.high);
    return keys
        .value(key, allowed, "the least distance of points of each pair of classes",
               [&](const ConfigNode& node) {
                   matrix = numbers_in(node).value_or(std::vector<double>{});
                   const auto rows =
                       static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(matrix.size()))));
                   const auto is_in_range = [&](double v) { return v >= range.low && v <= range.high; };
                   if (matrix.empty() || rows * rows != matrix.size() || rows > most_classes ||
                       !std::ranges::all_of(matrix, is_in_range) || !is_symmetric(matrix, rows))
                       throw keys.invalid(key, "must be " + allowed);
               })
        .at_most(most_classes * most_classes);
}

}
