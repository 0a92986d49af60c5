// Which annulus (2D) or spherical shell (3D) of radial_statistics() a frequency belongs to.
#pragma once

#include "base/geometry/periodic_box.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// Bins of equal width around f = 0: bin 0 is f = 0 alone (DC), bin k holds 1/2 + (k - 1) w < |f| <= 1/2 + k
/// w. With w = 1 those are, of the unit torus, the frequencies with round(|f|) = k. Bin 1 also holds the frequencies of
/// at most 1/2 that boxes have along sides longer than 2.
class RadialBins
{
public:
    /// Bins that reach beyond M/2 - 1/2 along an axis, and so beyond a spectrum of M frequencies along each axis, are
    /// left out; in a box, that is M/2 - 1/2 over its longest side. `width` w in cycles per unit length, at least 1.
    RadialBins(int size, double width, const PeriodicBox& box = {});

    /// The number of bins, bin 0 among them.
    std::size_t count() const { return ends_.size() - 1; }

    /// The middle of bin k >= 1, in cycles per unit length.
    double centre(std::size_t k) const { return 0.5 + (static_cast<double>(k) - 0.5) * width_; }

    /// The square of the component of `f` cycles along an axis of the torus. It is a whole number, and all sums and
    /// comparisons of such are exact, where the torus is the unit torus.
    double squared(std::size_t axis, std::int64_t f) const { return static_cast<double>(f * f) * squared_steps_[axis]; }

    /// The bins along a row of frequencies u = 0, 1, 2, ... along an axis, asked for in this order; count() beyond the
    /// last one.
    class Walk
    {
    public:
        /// `squared_rest`: the sum of the squares of the other components.
        Walk(const RadialBins& bins, std::size_t axis, double squared_rest)
            : rest_(squared_rest), squared_step_(bins.squared_steps_[axis]),
              end_(std::ranges::lower_bound(bins.ends_, squared_rest)), begin_(bins.ends_.begin())
        {}

        std::size_t of(std::int64_t u)
        {
            while (rest_ + static_cast<double>(u * u) * squared_step_ > *end_) ++end_;
            return static_cast<std::size_t>(end_ - begin_);
        }

    private:
        double rest_, squared_step_;
        std::vector<double>::const_iterator end_, begin_;
    };

private:
    double width_;
    std::array<double, 3> squared_steps_; ///< of frequencies along each axis
    std::vector<double> ends_;            ///< the largest |f|^2 of each bin; then one beyond all
};

}
