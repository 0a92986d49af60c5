// Kernel dart throwing is unbiased: its statistics are those of the textbook algorithm, which shares no code
// with it.
#include "analysis/spectrum.hpp"
#include "geometry/relative_radius.hpp"
#include "sampling/cell_hierarchy.hpp"
#include "sampling/dart_throwing.hpp"
#include "support/statistics.hpp"
#include "support/textbook_dart_throwing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace poissonlab {
namespace {

constexpr std::size_t point_count = 1024;
constexpr std::size_t set_count = 200;

double min_distance() { return min_distance_for(0.72, point_count, 2); }

/// `set_count` sets by the kernels.
const std::vector<PointSet>& kernel_sets()
{
    static const std::vector<PointSet> sets = [] {
        std::vector<PointSet> result;
        DartThrower thrower(Device::open());
        for (std::uint32_t k = 0; k < set_count; ++k) {
            DartThrowingRequest request;
            request.min_distance = min_distance();
            request.points = point_count;
            request.stream = stream_key(77, Purpose::dart_throwing, k);
            result.push_back(thrower.throw_darts(request));
        }
        return result;
    }();
    return sets;
}

/// As many by the textbook.
const std::vector<PointSet>& textbook_sets()
{
    static const std::vector<PointSet> sets = [] {
        std::vector<PointSet> result;
        for (std::size_t k = 0; k < set_count; ++k) {
            result.push_back(test::textbook_dart_throwing(point_count, min_distance(), 1000 + k));
        }
        return result;
    }();
    return sets;
}

double squared_distance(std::span<const double> a, std::span<const double> b)
{
    double sum = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        const double direct = std::abs(a[k] - b[k]);
        const double shortest = std::min(direct, 1 - direct);
        sum += shortest * shortest;
    }
    return sum;
}

using Features = std::function<std::vector<double>(const PointSet&)>;

/// Compares the mean of every feature over the sets of both algorithms.
void expect_same_means(const Features& features)
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
    const auto ours = columns_of(kernel_sets());
    const auto theirs = columns_of(textbook_sets());
    const double bound = test::z_bound(ours.size());
    for (std::size_t i = 0; i < ours.size(); ++i) {
        const test::Mean a = test::mean_of(ours[i]);
        const test::Mean b = test::mean_of(theirs[i]);
        EXPECT_LT(std::abs(test::z_score(a, b)), bound)
            << "feature " << i << ": " << a.value << " and " << b.value;
    }
}

/// Pairs by distance, from contact to twice the minimum distance, in 20 classes.
std::vector<double> pairs_by_distance(const PointSet& set)
{
    std::vector<double> counts(20);
    for (std::size_t i = 0; i < set.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const double squared = squared_distance(set[i], set[j]);
            if (squared >= 4 * min_distance() * min_distance()) continue;
            const double place =
                (std::sqrt(squared) / min_distance() - 1) * static_cast<double>(counts.size());
            if (place < static_cast<double>(counts.size()))
                ++counts[static_cast<std::size_t>(std::max(place, 0.0))];
        }
    }
    return counts;
}

TEST(DartThrowingStatistics, PairCorrelationNearContactIsTheTextbooks)
{
    expect_same_means(pairs_by_distance);
}

TEST(DartThrowingStatistics, RadialPowerIsTheTextbooks)
{
    expect_same_means([](const PointSet& set) {
        constexpr int size = 128;
        const auto power = exact_periodogram(set, size);
        std::vector<double> sums(size / 2);
        std::vector<double> samples(size / 2);
        for (int v = 0; v < size; ++v) {
            for (int u = 0; u < size; ++u) {
                const auto bin =
                    static_cast<std::size_t>(std::lround(std::hypot(u - size / 2, v - size / 2)));
                if (bin == 0 || bin >= sums.size()) continue;
                sums[bin] += power[static_cast<std::size_t>(v * size + u)];
                ++samples[bin];
            }
        }
        for (std::size_t i = 1; i < sums.size(); ++i) sums[i] /= samples[i];
        sums.erase(sums.begin());
        return sums;
    });
}

TEST(DartThrowingStatistics, PointsDoNotKnowTheCellsTheyWereThrownIn)
{
    // Where points lie within cells of level 0: uniform, for single axes and for quarters and sixteenths of a
    // cell. The textbook's points do not know that grid at all, so a preference shows as a difference.
    const std::uint32_t cells = cell_hierarchy(min_distance(), 2).size;
    expect_same_means([&](const PointSet& set) {
        std::vector<double> counts(16);
        for (std::size_t i = 0; i < set.size(); ++i) {
            const auto part = [&](double x) { return static_cast<std::size_t>(x * cells * 4) % 4; };
            ++counts[4 * part(set[i][1]) + part(set[i][0])];
        }
        return counts;
    });
}

TEST(DartThrowingStatistics, EarlyAndLatePointsAreTheTextbooks)
{
    // The order of darts: distance from point n to its nearest predecessor, averaged over runs of 64 points.
    expect_same_means([](const PointSet& set) {
        std::vector<double> means(point_count / 64);
        for (std::size_t i = 1; i < set.size(); ++i) {
            double nearest = 1;
            for (std::size_t j = 0; j < i; ++j) {
                nearest = std::min(nearest, squared_distance(set[i], set[j]));
            }
            means[i / 64] += std::sqrt(nearest) / 64;
        }
        return means;
    });
}

}
}
