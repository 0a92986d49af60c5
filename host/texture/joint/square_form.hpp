// The variance of means over squares of a tiling as a quadratic form of what the quarters of its tiles show, and fields
// of hats that change them: see tile_levels.hpp.
#pragma once

#include "host/texture/joint/set_cover.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace poissonlab {

/// Means over the quarters of tiles, row by row.
using Quarters = std::vector<std::array<double, 4>>;

double product(const Quarters& a, const Quarters& b);
void add_times(Quarters& sums, double times, const Quarters& others);

/// The weight of the hat in the middle of an axis: 0 in the ring, then sin^2 over a quarter of the tile, then 1. Hats
/// at both ends have the rest.
double middle_at(int place, int size, int ring);

class SquareForm
{
public:
    /// The parts must live longer.
    SquareForm(const SetParts& parts, int size, int ring);

    std::size_t hats() const { return sites_.size(); }

    /// The variance of quarters whose mean is 0 is the product of them and of this.
    Quarters applied(const Quarters& quarters) const;

    /// The four hats over the corners of a quarter: a corner, the middles of a vertical and of a horizontal edge, and
    /// of the tile.
    std::array<std::size_t, 4> hats_at(std::size_t tile, std::size_t quarter) const;

    /// The means of a field over quarters, from the heights of its hats.
    Quarters field(const std::vector<double>& heights) const;

    /// The heights with the least sum of the variance of quarters and field together and `weight` times the field's
    /// mean square over all pixels, by the method of conjugate gradients.
    std::vector<double> best_heights(const Quarters& quarters, double weight) const;

private:
    std::array<double, 4> weights() const;
    std::vector<double> gathered(const Quarters& quarters) const;
    void add_field_squares(const std::vector<double>& heights, double weight, std::vector<double>& slopes) const;
    bool shows(const PlacedTile& tile, std::size_t quarter) const;
    void apply_at(const Site& site, const Quarters& quarters, Quarters& result) const;

    const SetParts& parts_;
    int size_;
    /// Along an axis, over half of a tile, of hats at the end and in the middle.
    std::array<double, 2> means_{};
    std::array<std::array<double, 2>, 2> products_{}; ///< means of products
    std::vector<Site> sites_;
    std::array<double, 4> shown_{}; ///< tiles at all sites of a kind
};

}
