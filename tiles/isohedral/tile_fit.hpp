// The tile of an isohedral type that is nearest to a goal, where its corners lie on the goal's outline.
//
// An outline cut into steps is a tile of a type if its steps obey linear equations: a step on an edge is the image of
// the step of the neighbour that lies on it, symmetries of the tile map steps to steps, and the outline closes. Koizumi
// and Sugihara, Maximum eigenvalue problem for Escherization, 2011, find the nearest tile by an eigenvalue problem.
// Nagata and Imahori, Escherization with generalized distance functions focusing on local structural similarity, 2021,
// compare steps instead of places, which keeps details. Here this makes the nearest tile a mean over equal steps, less
// the part that does not close; the best rotation of the goal, which counts for types with mirrors, is the larger
// eigenvalue of a matrix of two rows.
#pragma once

#include "tiles/isohedral/isohedral_tile.hpp"

#include <complex>
#include <span>
#include <vector>

namespace poissonlab {

using PlaneStep = std::complex<double>;

/// The steps of a goal, edge by edge from edge 0 on.
struct GoalSteps
{
    std::vector<std::size_t> pieces; ///< of each curve of the type: its edges have so many steps
    std::vector<double> weights;     ///< of each edge: those of squared differences of its steps
    const PlaneStep* steps = nullptr;
};

class TileFit
{
public:
    explicit TileFit(const IsohedralType& type);

    const IsohedralType& type() const { return *type_; }

    /// The number of edges that have each curve.
    const std::vector<std::size_t>& edges_of_curves() const { return edges_; }

    /// The largest weighted sum of squares that steps of a tile near a rotated goal have: that of the goal, less the
    /// weighted sum of squared differences.
    double likeness(const GoalSteps& goal) const;

    /// The parameters of the nearest tile, and the places of its outline that its steps join, as IsohedralTile has
    /// them.
    struct Nearest
    {
        double likeness = 0;
        double angle = 0; ///< by which the goal was rotated
        std::vector<PlanePoint> outline;
        IsohedralParameters parameters;
    };
    Nearest nearest(const GoalSteps& goal) const;

private:
    /// A way in which steps of an edge are those of its curve: x becomes u x, or u times the conjugate of x.
    struct Use
    {
        std::size_t edge;
        bool is_reversed;
        bool is_mirrored;
        PlaneStep u;
    };

    struct Sums;
    struct Rotation;

    void find_uses();
    Sums sums_of(const GoalSteps& goal, bool keeps_means) const;
    void add_curve(Sums& sums, const GoalSteps& goal, std::size_t curve, bool keeps_means) const;
    std::vector<PlaneStep> steps_of(const Sums& sums, const Rotation& rotation,
                                    const std::vector<std::size_t>& pieces) const;
    void set_parameters(Nearest& tile, const std::vector<std::size_t>& pieces) const;

    const IsohedralType* type_;
    std::vector<std::vector<Use>> uses_; ///< of each curve, all ways
    std::vector<std::size_t> edges_;     ///< of each curve
    /// Each curve's step x moves the outline's end by [0] x + [1] conj(x).
    std::vector<std::array<PlaneStep, 2>> closing_;
    bool has_mirrors_ = false;
};

}
