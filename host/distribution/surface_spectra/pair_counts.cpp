#include "host/distribution/surface_spectra/pair_counts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace poissonlab {
namespace {

/// A ring has an anisotropy from that many pairs on, five for each sector.
constexpr std::uint64_t least_in_ring = 5 * difference_sectors;

double distance_of(std::size_t bin) { return (static_cast<double>(bin) + 0.5) * farthest_pair / pair_bins; }

}

std::vector<PairCorrelationBin> pair_correlation(const PairCounts& counts, double expected, double twice)
{
    std::vector<PairCorrelationBin> bins;
    for (std::size_t k = 0; k < counts[0].size(); ++k) {
        const auto pairs = static_cast<double>(counts[0][k]), random = static_cast<double>(counts[1][k]);
        if (random == 0) continue;
        const double value = pairs / (random * expected), one = twice / (random * expected);
        bins.push_back({distance_of(k), value,
                        std::hypot(one * std::sqrt(std::max(pairs / twice, 1.0)), value / std::sqrt(random)),
                        pairs / twice});
    }
    return bins;
}

std::vector<PairCorrelationBin> localised_correlation(const PairCounts& bins, std::size_t parts)
{
    std::vector<PairCorrelationBin> local;
    for (std::size_t k = 0; k < pair_bins; ++k) {
        std::vector<double> pairs(parts), expected(parts);
        for (std::size_t p = 0; p < parts; ++p) {
            const auto begin = static_cast<std::ptrdiff_t>(p * pair_bins);
            const auto within = [&](std::size_t of) {
                return static_cast<double>(
                    std::accumulate(bins[of].begin() + begin, bins[of].begin() + begin + pair_bins, std::uint64_t{0}));
            };
            pairs[p] = static_cast<double>(bins[0][p * pair_bins + k]);
            if (within(1) > 0) expected[p] = static_cast<double>(bins[1][p * pair_bins + k]) * within(0) / within(1);
        }
        const double all = std::accumulate(pairs.begin(), pairs.end(), 0.0),
                     sum = std::accumulate(expected.begin(), expected.end(), 0.0);
        if (!(sum > 0)) continue;
        double squares = 0;
        for (std::size_t p = 0; p < parts; ++p)
            if (expected[p] > 0) squares += expected[p] * std::pow(pairs[p] / expected[p] - all / sum, 2);
        local.push_back({distance_of(k), all / sum, std::sqrt(squares / sum), all});
    }
    return local;
}

std::vector<std::array<double, 2>> difference_anisotropy(const PairCounts& counts)
{
    std::vector<std::array<double, 2>> found;
    for (std::size_t ring = 0; ring < difference_rings; ++ring) {
        const auto begin = static_cast<std::ptrdiff_t>(ring * difference_sectors);
        std::array<std::uint64_t, 2> all{};
        for (std::size_t of = 0; of < 2; ++of)
            all[of] = std::accumulate(counts[of].begin() + begin, counts[of].begin() + begin + difference_sectors,
                                      std::uint64_t{0});
        if (all[0] < least_in_ring || all[1] == 0) continue;
        const double ratio = static_cast<double>(all[0]) / static_cast<double>(all[1]);
        double sum = 0;
        for (std::size_t s = 0; s < difference_sectors; ++s) {
            const auto pairs = static_cast<double>(counts[0][ring * difference_sectors + s]);
            const double expected = ratio * static_cast<double>(counts[1][ring * difference_sectors + s]);
            if (expected > 0) sum += (pairs - expected) * (pairs - expected) / (expected * (1 + ratio));
        }
        if (sum > 0)
            found.push_back({(static_cast<double>(ring) + 0.5) * farthest_pair / difference_rings,
                             10 * std::log10(sum / (difference_sectors - 1))});
    }
    return found;
}

std::vector<double> blurred_differences(const std::vector<std::uint64_t>& counts)
{
    constexpr std::array<double, 9> weights{1, 8, 28, 56, 70, 56, 28, 8, 1};
    constexpr auto n = static_cast<std::ptrdiff_t>(difference_squares);
    std::vector<double> from(counts.begin(), counts.end()), to(counts.size());
    for (int axis = 0; axis < 2; ++axis) {
        for (std::ptrdiff_t y = 0; y < n; ++y)
            for (std::ptrdiff_t x = 0; x < n; ++x) {
                double sum = 0;
                for (std::ptrdiff_t i = 0; i < 9; ++i)
                    if (const std::ptrdiff_t at = x + i - 4; at >= 0 && at < n) sum += weights[i] * from[y * n + at];
                to[x * n + y] = sum; // rows become columns, so that the second time blurs along the other axis
            }
        from.swap(to);
    }
    return from;
}

std::string mesh_pairs_csv(const MeshPairs& pairs)
{
    std::string text = "distance,along,along_error,in_space,in_space_error,localised,localised_spread\n";
    const auto cells = [](const std::vector<PairCorrelationBin>& bins, double distance) {
        for (const PairCorrelationBin& bin : bins)
            if (bin.distance == distance) return fmt::format(",{},{}", bin.value, bin.standard_error);
        return std::string(",nan,nan");
    };
    for (std::size_t k = 0; k < pair_bins; ++k) {
        const double distance = distance_of(k);
        text += fmt::format("{}{}{}{}\n", distance, cells(pairs.along, distance), cells(pairs.in_space, distance),
                            cells(pairs.localised, distance));
    }
    return text;
}

}
