// Marks that tell two sets apart, but not a set and the same one shifted on the torus: the spectra of these are the
// same, and so is every other measure that knows no place, so that they count as one set.
//
// A set that is shifted keeps the distances between its points and the modulus of each sum over points
// exp(-2 pi i f.x). Sets of which all of these numbers agree to eight digits are taken to be the same: by chance, sets
// of several points agree in one of them once in some 10^7 times.
#pragma once

#include "base/geometry/point_set.hpp"

#include <array>
#include <cstddef>

namespace poissonlab {

struct SetMark
{
    std::size_t points = 0;
    double min_distance = 0; ///< unit lengths; infinite for one point
    double mean_nearest = 0; ///< mean distance to the nearest other point, in any unit; infinite for one point
    std::array<double, 6> amplitudes{}; ///< of low frequencies, over the root of the number of points

    template <class Archive>
    void serialize(Archive& archive)
    {
        archive(points, min_distance, mean_nearest, amplitudes);
    }
};

/// The sums of a mark, over points that come in pieces, in their order.
class SetMarkSums
{
public:
    void add(const PointSet& points);

    /// The mark of the points that were added, at least one, whose distances are known.
    SetMark mark(double min_distance, double mean_nearest) const;

private:
    std::size_t points_ = 0;
    std::array<double, 6> real_{}, imaginary_{};
};

/// True for marks of one set, wherever on the torus.
bool are_same_set(const SetMark& a, const SetMark& b);

}
