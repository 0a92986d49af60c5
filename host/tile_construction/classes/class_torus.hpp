// A torus of two tiles a side whose points have classes, and how points that are too near are pushed apart.
//
// The plain twin of push_class_tiles in kernels/class_tiles.cl, which also brings the moments of the points of each
// class to what they should be, as moments/moment_step.hpp does for points without classes.
#pragma once

#include "host/tile_construction/classes/class_filling.hpp"
#include "tiles/poisson/tile_moments.hpp"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace poissonlab {

/// The moments that the points of each class that move are to have, in units from the middle of the tile at (0, 0).
struct ClassMoments
{
    std::vector<Monomial> monomials;
    std::span<const std::int64_t> wanted; ///< by class and monomial
};

class ClassTorus
{
public:
    /// The third coordinate of a point is its class. `held`: points that do not move. `zone`: where others may be.
    /// `is_one_tile`: the torus has one tile a side, and any image of a point stands for it.
    ClassTorus(const ClassFillSettings& settings, const Zone& zone, std::vector<TilePosition> held,
               bool is_one_tile = false)
        : settings_(settings), zone_(zone), is_one_tile_(is_one_tile), points_(std::move(held)),
          active_begin_(points_.size())
    {}

    /// Adds a point that moves.
    void add(const TilePosition& point) { points_.push_back(point); }

    /// The points that move.
    std::span<const TilePosition> active() const { return std::span(points_).subspan(active_begin_); }

    const Zone& zone() const { return zone_; }

    /// The part of the squared distances that a position keeps from all points but the one numbered `self`.
    std::uint32_t part_kept(const TilePosition& position, std::size_t self) const;

    /// The part that a new point would keep.
    std::uint32_t part_kept(const TilePosition& position) const { return part_kept(position, points_.size()); }

    /// Pushes points apart until they keep all distances and have the moments, if any are wanted; otherwise takes the
    /// best of all passes. Returns the part of the squared distances kept; 0: without the moments.
    std::uint32_t push(const ClassMoments* moments = nullptr);

private:
    static std::size_t class_of(const TilePosition& point) { return static_cast<std::size_t>(point[2]); }
    std::size_t pair(const TilePosition& a, const TilePosition& b) const
    {
        return class_of(a) * settings_.classes() + class_of(b);
    }

    std::int32_t difference(std::int32_t a, std::int32_t b) const;
    std::uint32_t squared_between(const TilePosition& a, const TilePosition& b) const;
    void find_neighbours();
    bool are_neighbours_stale() const;
    std::span<const std::uint32_t> neighbours(std::size_t active) const;
    std::uint32_t part_among_neighbours() const;
    TilePosition movement(std::size_t i) const;
    void move(const std::vector<TilePosition>& movements);

    const ClassFillSettings& settings_;
    Zone zone_;
    bool is_one_tile_;
    std::vector<TilePosition> points_; ///< held ones first
    std::size_t active_begin_;

    // For each active point, those that can come too near to it until one has moved by more than the slack.
    std::vector<std::uint32_t> neighbours_;
    std::vector<std::size_t> first_neighbour_;
    std::vector<TilePosition> listed_at_; ///< all points when neighbours were found
    double slack_ = 0;
};

}
