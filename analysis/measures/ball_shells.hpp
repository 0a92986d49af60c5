// Balls about one centre: which of them a point lies in.
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// The smallest balls of a list, whose points are looked at one by one: larger ones hold so many that it takes less
/// time to look at the cells on their surface.
class BallShells
{
public:
    /// `radii` ascend; the balls lie among `points` points in the unit square (cube).
    BallShells(const std::vector<double>& radii, std::size_t points, int dimension)
    {
        const double most_points = dimension == 2 ? 300 : 8000; // both ways take as long where boxes hold so many
        for (const double radius : radii) {
            if (static_cast<double>(points) * std::pow(2 * radius, dimension) > most_points) break;
            outer_radius_ = radius;
            squared_radii_.push_back(radius * radius);
        }
        if (squared_radii_.empty()) return;
        lowest_ = head_of(squared_radii_.front());
        first_.push_back(0);
        for (std::uint64_t head = lowest_ + 1; least_with(head) < squared_radii_.back(); ++head) {
            std::size_t shell = first_.back();
            while (squared_radii_[shell] <= least_with(head)) ++shell;
            first_.push_back(shell);
        }
    }

    std::size_t count() const { return squared_radii_.size(); }
    double outer_radius() const { return outer_radius_; } ///< of the largest of these balls; 0 where there are none

    /// The number of the smallest ball that holds a point inside of the largest.
    std::size_t shell_of(double squared_distance) const
    {
        const std::uint64_t head = head_of(squared_distance);
        std::size_t shell = head <= lowest_ ? 0 : first_[head - lowest_];
        while (squared_distance >= squared_radii_[shell]) ++shell;
        return shell;
    }

private:
    static constexpr int tail_bits = 48; ///< the exponent and four more bits are left: steps of at most a sixteenth

    /// The leading bits of a positive number, in whose order numbers are.
    static std::uint64_t head_of(double number) { return std::bit_cast<std::uint64_t>(number) >> tail_bits; }

    static double least_with(std::uint64_t head) { return std::bit_cast<double>(head << tail_bits); }

    double outer_radius_ = 0;
    std::vector<double> squared_radii_;
    std::uint64_t lowest_ = 0;       ///< leading bits of the least squared radius
    std::vector<std::size_t> first_; ///< of each leading bits from there on, the smallest ball that may hold the point
};

}
