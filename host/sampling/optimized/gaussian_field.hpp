// The density that Gaussian blue noise follows, as its points meet it: how wide Gaussians are at each place, and how
// far the density moves a point that is there.
//
// Ahmed, Ren, Wonka, Gaussian blue noise, 2022: points repel each other by their Gaussians, and the density attracts
// them by the same Gaussians; sigma is larger where points are few. A place's Gaussian is as wide as it must be for the
// density to have as many points under it as one of sigma mean distances has where the density is the same everywhere.
// It is narrower where it would have as many if the density around were that of the place: on the dense side of a
// border, where wide ones hardly resist that points lie on top of each other. The forces of points and of density are
// in balance where both, blurred by that Gaussian, are alike, so that no place has too many points or too few. As in
// the authors' program, no point moves to where the density is 0.
//
// Departures: widths follow from the density alone, between steps of a factor of 2^(1/4), not from the points again at
// every step; and a point's own width counts for all of its pairs, not one between the widths of both. Forces are thus
// not those of one energy, and the energy of records may rise.
#pragma once

#include "base/densities/density.hpp"
#include "host/sampling/cells/cell_rows.hpp"
#include "kernels/common/optimized/gaussian_blue_noise.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// Pairs farther apart than so many sigma are left out.
inline constexpr double gaussian_cut_off = contract::gaussian_blue_noise::CUT_OFF;

/// The exponent for which 2^(exponent * squared distance) is the Gaussian of distances in units of 2^-32;
/// `squared_sigma` is of the torus' side.
float gaussian_exponent(double squared_sigma);

/// The cells of the grid in which the neighbours of a point are looked for, along each axis: a third as wide as the
/// cut-off or wider. `sigma` is in mean distances.
std::uint32_t gaussian_grid(double sigma, std::size_t points, int dimension);

/// The sizes of a field, which follow from how far the density's largest value is above its mean.
struct GaussianFieldShape
{
    std::uint32_t size = 0;      ///< cells along each axis, a power of two
    std::uint32_t grid_size = 0; ///< of gaussian_grid() for the narrowest Gaussian
    int narrowest = 0;           ///< widths are between sigma 2^(i / 4) of this number
    int widest = 0;              ///< and this one, which reaches to the other side of the torus
    /// the cells of that grid that are listed, FIELD_CELLS times as wide as those of the field; 0: all are there
    std::uint32_t listed = 0;

    std::size_t cells() const;
};

/// `points` has at least least_gaussian_points().
GaussianFieldShape gaussian_field_shape(const Density& density, double sigma, std::size_t points);

struct GaussianField
{
    using Cell = contract::gaussian_blue_noise::DensityCell;

    GaussianFieldShape shape;
    std::vector<Cell> cells; ///< row by row from the bottom; where cells of the grid are listed, in each of these
    CellRows listed{};       ///< the density is 0 elsewhere

    const Cell& cell(int column, int row) const;
};

/// The numbers of a Gaussian at a place.
struct GaussianNumbers
{
    double squared = 1;              ///< of the width, over sigma
    double under = 1;                ///< points under it, over those where the density is the same everywhere
    double slope_x = 0, slope_y = 0; ///< of the density under it, over the mean; a unit is the torus' side
};

/// The numbers between two of them.
GaussianNumbers between(const GaussianNumbers& low, const GaussianNumbers& high, double part);

/// A cell whose density is not 0 in the field of sets that have so many points where the density is 1 everywhere.
GaussianField::Cell field_cell(const GaussianNumbers& numbers, double sigma, double step, double points);

/// The field of a square density for a number of points. `sigma` and `step` are those of GaussianRequest. Changes
/// within a cell of the field, at most a quarter of the narrowest Gaussian where that is within 2,048 cells, are not
/// followed.
GaussianField gaussian_field(const Density& density, double sigma, double step, std::size_t points);

}
