// Which annulus (2D) or spherical shell (3D) of radial_statistics() a frequency belongs to.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// Bins of equal width around f = 0: bin 0 is f = 0 alone (DC), bin k holds 1/2 + (k - 1) w < |f| <= 1/2 + k
/// w. With w = 1 those are the frequencies with round(|f|) = k.
class RadialBins
{
public:
    /// Bins that reach beyond M/2 - 1/2, and so beyond a spectrum of M frequencies along each axis, are left
    /// out. `width` w in frequency samples, at least 1.
    RadialBins(int size, double width);

    /// The number of bins, bin 0 among them.
    std::size_t count() const { return ends_.size() - 1; }

    /// The middle of bin k >= 1, in cycles per unit length.
    double centre(std::size_t k) const { return 0.5 + (static_cast<double>(k) - 0.5) * width_; }

    /// The bins along a row of frequencies u = 0, 1, 2, ... asked for in this order; count() beyond the last
    /// one.
    class Walk
    {
    public:
        /// `squared_rest`: the sum of the squares of the other components.
        Walk(const RadialBins& bins, std::int64_t squared_rest)
            : rest_(squared_rest), end_(std::ranges::lower_bound(bins.ends_, squared_rest)), begin_(bins.ends_.begin())
        {}

        std::size_t of(std::int64_t u)
        {
            while (rest_ + u * u > *end_) ++end_;
            return static_cast<std::size_t>(end_ - begin_);
        }

    private:
        std::int64_t rest_;
        std::vector<std::int64_t>::const_iterator end_, begin_;
    };

private:
    double width_;
    std::vector<std::int64_t> ends_; ///< the largest |f|^2 of each bin, in integers; then one beyond all
};

}
