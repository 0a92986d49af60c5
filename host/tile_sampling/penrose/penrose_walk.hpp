// The decisions on the way through a Penrose tiling: which triangles are divided, and which points stay.
#pragma once

#include "host/tile_sampling/penrose/penrose_points.hpp"
#include "tiles/penrose/penrose_tiles.hpp"

#include <optional>

namespace poissonlab {

/// The tile of a kernel's record, and the record of a tile.
PenroseTile tile_of(const contract::penrose::Tile& record);
contract::penrose::Tile record_of(const PenroseTile& tile);

/// A point that stays: its corner of the tiling, and how the table moves it from there.
struct StayingPoint
{
    FixedPlace corner;
    PenroseRow row;
    std::size_t index;     ///< structural
    std::size_t direction; ///< of its frame

    /// The point's place where a vector of the table moves it.
    FixedPlace moved(const PenroseVector& vector, const PenroseScales& scales) const;
};

class PenroseWalk
{
public:
    PenroseWalk(const PenroseTiling& tiling, std::uint64_t importance, const PenroseWindow& window)
        : tiling_(tiling), importance_(importance), window_(window)
    {}

    /// Tells whether a triangle can have points in the window that stay.
    bool needs(const PenroseTile& triangle) const;

    /// A new point, if it stays.
    std::optional<StayingPoint> staying(const PenroseTile& point) const;

    /// Appends a new point if it stays and its place is in the window.
    void keep(const PenroseTile& point, std::vector<PenrosePoint>& points) const;

private:
    std::uint64_t importance_at(std::uint64_t weight) const;

    const PenroseTiling& tiling_;
    std::uint64_t importance_;
    PenroseWindow window_;
};

/// Shows all points that come from a triangle and may stay: those of each triangle before those of its children.
template <class Visit>
void visit_new_points(const PenroseWalk& walk, const PenroseTile& triangle, const Visit& visit)
{
    if (!walk.needs(triangle)) return;
    const PenroseChildren children = divided(triangle);
    for (const PenroseTile& child : children)
        if (is_point(child)) visit(child);
    for (const PenroseTile& child : children)
        if (!is_point(child)) visit_new_points(walk, child, visit);
}

}
