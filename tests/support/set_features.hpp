// Numbers that describe a point set, and a comparison of two ways to make sets by the means of such numbers.
#pragma once

#include "analysis/spectra/spectrum.hpp"
#include "base/geometry/point_set.hpp"
#include "tests/support/statistics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace poissonlab::test {

using Features = std::function<std::vector<double>(const PointSet&)>;

/// Compares the mean of every feature over the sets of both algorithms.
inline void expect_same_means(const Features& features, const std::vector<PointSet>& ours,
                              const std::vector<PointSet>& theirs)
{
    const auto columns_of = [&](const std::vector<PointSet>& sets) {
        std::vector<std::vector<double>> columns;
        for (const PointSet& set : sets) {
            const auto values = features(set);
            columns.resize(values.size());
            for (std::size_t i = 0; i < values.size(); ++i) columns[i].push_back(values[i]);
        }
        return columns;
    };
    const auto our_columns = columns_of(ours);
    const auto their_columns = columns_of(theirs);
    const double bound = z_bound(our_columns.size());
    for (std::size_t i = 0; i < our_columns.size(); ++i) {
        const Mean a = mean_of(our_columns[i]);
        const Mean b = mean_of(their_columns[i]);
        EXPECT_LT(std::abs(z_score(a, b)), bound) << "feature " << i << ": " << a.value << " and " << b.value;
    }
}

/// The squared toroidal distance of two points.
inline double squared_distance(std::span<const double> a, std::span<const double> b)
{
    double sum = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        const double direct = std::abs(a[k] - b[k]);
        const double shortest = std::min(direct, 1 - direct);
        sum += shortest * shortest;
    }
    return sum;
}

/// The number of pairs by distance, from `begin` to `end`, in classes of equal width.
inline std::vector<double> pairs_by_distance(const PointSet& set, double begin, double end, std::size_t classes)
{
    std::vector<double> counts(classes);
    for (std::size_t i = 0; i < set.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const double squared = squared_distance(set[i], set[j]);
            if (squared >= end * end) continue;
            const double place = (std::sqrt(squared) - begin) / (end - begin) * static_cast<double>(classes);
            if (place < static_cast<double>(classes)) ++counts[static_cast<std::size_t>(std::max(place, 0.0))];
        }
    }
    return counts;
}

/// The number of points in each sixteenth of a cell, over all cells of a grid with so many along each axis. Points that
/// do not know the grid are equally often in each.
inline std::vector<double> points_in_cells(const PointSet& set, double cells)
{
    std::vector<double> counts(16);
    for (std::size_t i = 0; i < set.size(); ++i) {
        const auto part = [&](double x) { return static_cast<std::size_t>(x * cells * 4) % 4; };
        ++counts[4 * part(set[i][1]) + part(set[i][0])];
    }
    return counts;
}

/// The distance of a point from the nearest of its predecessors, averaged over runs of so many points.
inline std::vector<double> distances_to_predecessors(const PointSet& set, std::size_t run)
{
    std::vector<double> means(set.size() / run);
    for (std::size_t i = 1; i < set.size(); ++i) {
        double nearest = 1;
        for (std::size_t j = 0; j < i; ++j) nearest = std::min(nearest, squared_distance(set[i], set[j]));
        means[i / run] += std::sqrt(nearest) / static_cast<double>(run);
    }
    return means;
}

/// The power averaged over rings, one for each whole frequency from 1 to size / 2 - 1 cycles per unit length.
inline std::vector<double> radial_power(const PointSet& set, int size)
{
    const auto power = exact_periodogram(set, size);
    std::vector<double> sums(static_cast<std::size_t>(size / 2));
    std::vector<double> samples(sums.size());
    for (int v = 0; v < size; ++v) {
        for (int u = 0; u < size; ++u) {
            const auto bin = static_cast<std::size_t>(std::lround(std::hypot(u - size / 2, v - size / 2)));
            if (bin == 0 || bin >= sums.size()) continue;
            sums[bin] += power[static_cast<std::size_t>(v * size + u)];
            ++samples[bin];
        }
    }
    for (std::size_t i = 1; i < sums.size(); ++i) sums[i] /= samples[i];
    sums.erase(sums.begin());
    return sums;
}

}
