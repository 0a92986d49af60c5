#include "analysis/regions/region_pairs.hpp"

#include "analysis/regions/plane_neighbours.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

constexpr double least_share = 0.01; ///< Ripley's weights are at most one over it
constexpr std::size_t chunks = 64;   ///< fixed, so that sums are the same with any number of threads

/// Sums over pairs of points.
struct PairSums
{
    explicit PairSums(std::size_t count) : pairs(count), translation(count), isotropic(count), smooth(count) {}

    void add(const PairSums& other)
    {
        const auto add_to = [](std::vector<double>& sum, const std::vector<double>& part) {
            for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += part[k];
        };
        add_to(pairs, other.pairs);
        add_to(translation, other.translation);
        add_to(isotropic, other.isotropic);
        add_to(smooth, other.smooth);
    }

    std::vector<double> pairs, translation, isotropic, smooth;
};

class PairCollector
{
public:
    PairCollector(const PlaneNeighbours& points, const FramedRegion& region, const SetCovariance& covariance,
                  const PairDistances& distances, std::vector<double> inverse_intensity, bool is_isotropic)
        : points_(points), region_(region), covariance_(covariance), distances_(distances),
          inverse_(std::move(inverse_intensity)), is_isotropic_(is_isotropic)
    {}

    PairSums collect(std::size_t first, std::size_t end) const
    {
        PairSums sums(distances_.count);
        for (std::size_t i = first; i < end; ++i) add_pairs_of(i, sums);
        return sums;
    }

private:
    /// Each pair is met from both of its points: those of the translation correction count from the first.
    void add_pairs_of(std::size_t i, PairSums& sums) const
    {
        const auto place = points_.place(i);
        const double reach = distances_.reach();
        double boundary = 0;
        std::vector<RegionEdge> edges;
        if (is_isotropic_) {
            boundary = region_.boundary().distance(place, reach);
            if (boundary < reach) edges = region_.boundary().edges_near(place, reach);
        }
        points_.for_each_near(place, reach + distances_.half_width, [&](std::size_t j, double squared) {
            if (i == j) return;
            const double distance = std::sqrt(squared), weight = inverse_[i] * inverse_[j];
            if (is_isotropic_ && distance <= reach) {
                const double share = distance <= boundary ? 1 : share_of_circle(place, distance, edges);
                sums.isotropic[bin_of(distance)] += weight / std::max(share, least_share);
            }
            if (j < i) add_translation(place, points_.place(j), distance, weight, sums);
        });
    }

    void add_translation(const std::array<double, 2>& a, const std::array<double, 2>& b, double distance, double weight,
                         PairSums& sums) const
    {
        const double w = 2 * weight / covariance_.at(a[0] - b[0], a[1] - b[1]);
        if (distance <= distances_.reach()) {
            sums.translation[bin_of(distance)] += w;
            ++sums.pairs[bin_of(distance)];
        }
        if (distance == 0) return;
        const double step = distances_.step, half = distances_.half_width;
        const auto first = static_cast<std::size_t>(std::max(1.0, std::ceil((distance - half) / step)));
        const auto last = static_cast<std::size_t>((distance + half) / step);
        for (std::size_t k = first; k <= std::min(last, distances_.count); ++k) {
            const double t = (static_cast<double>(k) * step - distance) / half;
            sums.smooth[k - 1] += w * std::max(0.0, 1 - t * t) / distance;
        }
    }

    /// The bin whose end is the first of at least that distance.
    std::size_t bin_of(double distance) const
    {
        const auto bin = static_cast<std::size_t>(std::max(1.0, std::ceil(distance / distances_.step)));
        return std::min(bin, distances_.count) - 1;
    }

    const PlaneNeighbours& points_;
    const FramedRegion& region_;
    const SetCovariance& covariance_;
    PairDistances distances_;
    std::vector<double> inverse_;
    bool is_isotropic_;
};

/// One over the intensity, in the order of the neighbours' grid.
std::vector<double> inverse_intensities(const PlaneNeighbours& sorted, const PointSet& points, double area,
                                        std::span<const double> intensity)
{
    const auto n = static_cast<double>(points.size());
    if (intensity.empty()) return std::vector<double>(points.size(), area / n);
    std::vector<double> inverse(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) inverse[sorted.number_of(i)] = 1 / intensity[i];
    return inverse;
}

}

PairCurves region_pairs(const PointSet& points, const FramedRegion& region, const SetCovariance& covariance,
                        const PairDistances& distances, std::span<const double> intensity, bool is_isotropic)
{
    const PlaneNeighbours sorted(points, region.area());
    const PairCollector collector(sorted, region, covariance, distances,
                                  inverse_intensities(sorted, points, region.area(), intensity), is_isotropic);
    const std::size_t n = points.size();
    std::vector<PairSums> parts(chunks, PairSums(distances.count));
    tbb::parallel_for(std::size_t{0}, chunks,
                      [&](std::size_t c) { parts[c] = collector.collect(n * c / chunks, n * (c + 1) / chunks); });
    PairSums sums(distances.count);
    for (const PairSums& part : parts) sums.add(part);

    PairCurves curves;
    curves.pairs = sums.pairs;
    const double all = static_cast<double>(n) / (static_cast<double>(n) - 1);
    double translation = 0, isotropic = 0;
    for (std::size_t k = 0; k < distances.count; ++k) {
        translation += all * sums.translation[k];
        isotropic += all * sums.isotropic[k] / region.area();
        curves.k_translation.push_back(translation);
        if (is_isotropic) curves.k_isotropic.push_back(isotropic);
        const double ring = std::numbers::pi * distances.step * distances.step * (2 * static_cast<double>(k) + 1);
        curves.g_of_bin.push_back(all * sums.translation[k] / ring);
        curves.g_smooth.push_back(all * sums.smooth[k] * 0.75 / distances.half_width / (2 * std::numbers::pi));
    }
    return curves;
}

}
