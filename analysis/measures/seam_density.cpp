#include "analysis/measures/seam_density.hpp"

#include "base/geometry/relative_radius.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace poissonlab {
namespace {

constexpr double usual_relative_radius = 0.75;
constexpr std::size_t bins_per_radius = 4;

/// Chance alone makes a deviation of 5 percent of as many points, and well-spread ones less.
constexpr double least_points = 400;

}

FoldedDensity::FoldedDensity(int tiles, std::size_t points)
    : tiles_(tiles), size_(std::max(1, static_cast<int>(std::lround(1 / seam_bin_width(2, tiles, points))))),
      counts_(static_cast<std::size_t>(size_) * static_cast<std::size_t>(size_))
{}

void FoldedDensity::add(const PointSet& points)
{
    const auto bin = [&](double coordinate) {
        const double place = coordinate * tiles_;
        return std::min(static_cast<std::size_t>(size_ - 1),
                        static_cast<std::size_t>((place - std::floor(place)) * size_));
    };
    for (std::size_t i = 0; i < points.coordinates.size(); i += 2)
        ++counts_[bin(points.coordinates[i + 1]) * static_cast<std::size_t>(size_) + bin(points.coordinates[i])];
}

void FoldedDensity::append(const FoldedDensity& other)
{
    for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i] += other.counts_[i];
}

SquareImage FoldedDensity::densities() const
{
    const auto all = std::accumulate(counts_.begin(), counts_.end(), std::uint64_t{0});
    const double mean = static_cast<double>(all) / static_cast<double>(counts_.size());
    SquareImage image{size_, {}};
    for (const std::uint64_t count : counts_) image.pixels.push_back(static_cast<double>(count) / mean);
    return image;
}

double seam_bin_width(int dimension, int tiles, std::size_t points)
{
    return min_distance_for(usual_relative_radius, points, dimension) / 2 / bins_per_radius * tiles;
}

SeamDensity::SeamDensity(int dimension, int tiles, std::size_t points)
    : dimension_(dimension), tiles_(tiles), width_(seam_bin_width(dimension, tiles, points)),
      counts_(static_cast<std::size_t>(std::ceil(0.5 / width_)))
{}

void SeamDensity::add(const PointSet& points)
{
    const auto dimension = static_cast<std::size_t>(dimension_);
    for (std::size_t i = 0; i < points.coordinates.size(); i += dimension) {
        double distance = 0.5;
        for (std::size_t k = 0; k < dimension; ++k) {
            const double place = points.coordinates[i + k] * tiles_;
            distance = std::min(distance, std::abs(place - std::round(place)));
        }
        ++counts_[std::min(counts_.size() - 1, static_cast<std::size_t>(distance / width_))];
    }
}

void SeamDensity::append(const SeamDensity& other)
{
    for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i] += other.counts_[i];
}

/// The part of a tile that is in a bin.
double SeamDensity::volume(std::size_t bin) const
{
    const auto inside = [&](double distance) { return std::pow(std::max(0.0, 1 - 2 * distance), dimension_); };
    return inside(width_ * static_cast<double>(bin)) - inside(width_ * static_cast<double>(bin + 1));
}

std::vector<SeamDensity::Bin> SeamDensity::bins() const
{
    const auto all = static_cast<double>(std::accumulate(counts_.begin(), counts_.end(), std::uint64_t{0}));
    std::vector<Bin> result;
    for (std::size_t i = 0; i < counts_.size(); ++i) {
        const double begin = width_ * static_cast<double>(i);
        result.push_back({begin, std::min(0.5, begin + width_), static_cast<double>(counts_[i]) / (volume(i) * all)});
    }
    return result;
}

std::optional<double> SeamDensity::largest_deviation() const
{
    const auto all = static_cast<double>(std::accumulate(counts_.begin(), counts_.end(), std::uint64_t{0}));
    const std::vector<Bin> densities = bins();
    std::optional<double> largest;
    for (std::size_t i = 0; i < densities.size(); ++i)
        if (volume(i) * all >= least_points)
            largest = std::max(largest.value_or(0), std::abs(densities[i].density - 1));
    return largest;
}

std::optional<double> SeamDensity::border_density() const
{
    const std::size_t end = std::min(bins_per_radius, counts_.size());
    double near = 0, part = 0;
    for (std::size_t i = 0; i < end; ++i) {
        near += static_cast<double>(counts_[i]);
        part += volume(i);
    }
    const double expected =
        part * static_cast<double>(std::accumulate(counts_.begin(), counts_.end(), std::uint64_t{0}));
    return expected < least_points ? std::nullopt : std::optional(near / expected);
}

}
