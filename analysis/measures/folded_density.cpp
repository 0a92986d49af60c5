#include "analysis/measures/folded_density.hpp"

#include "analysis/measures/seam_density.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace poissonlab {

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

}
