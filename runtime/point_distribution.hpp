// SPDX-License-Identifier: MIT-0
//
// Points with a density that varies, in the manner of Cortex' IECore::PointDistribution, from a ranked tile set: for
// Gaffer and other programs that scatter by bounds, a density, and an emitter of positions with thresholds.
//
//     const ptiles::PointDistribution distribution("corner-c4-n64-r075.ptiles");
//     distribution(bounds, density, [&](const Imath::V2f& p, float threshold) {
//         if (density_at(p) >= threshold) points.push_back(p);
//     });
//
// Kopf, Cohen-Or, Deussen and Lischinski, Recursive Wang tiles for real-time blue noise, SIGGRAPH 2006, is what Cortex
// has behind this interface. Here are Poisson disk tiles: no two points are nearer than min_distance(density), which is
// proven (but for the rounding of positions to the numbers of `bounds`). C++11, with poisson_tiles.h and nothing else;
// any box that has `min` and `max` with `x` and `y` will do, such as Imath::Box2f.
//
// The density decides how large tiles are, in steps: the whole of a tile is there at some density, half the side has
// four times that. Between two steps points come by rank. More density, or a greater one in another call, then adds
// points and moves none; across a step all points are others. Who needs a range without steps names its largest density
// at construction.
#ifndef POINT_DISTRIBUTION_HPP
#define POINT_DISTRIBUTION_HPP

#include "poisson_tiles.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace ptiles {

/// May be called by several threads at once.
class PointDistribution
{
public:
    /// `tile_set`: a file, ranked and in the plane (tiles build --ranked; runtime/tile_sets has some). `full_density`:
    /// the points per unit area of whole tiles, the best they have; all densities up to it are parts of one set of
    /// points, and greater ones four times, sixteen times, ... as much. 0: tiles of side 1, 2, 4, ... and 1/2, 1/4,
    /// ..., so that every density is between a quarter of whole tiles and all of them. `period`: the tiling closes
    /// after so many tiles along each axis, 0: never. Throws std::runtime_error, a line with the file's name.
    explicit PointDistribution(const std::string& tile_set, double full_density = 0, std::uint32_t seed = 1,
                               std::int32_t period = 0)
        : full_density_(full_density)
    {
        if (!(full_density >= 0 && full_density < 1e300)) fail(tile_set, "the density must be 0 or a positive number");
        if (period < 0) fail(tile_set, "the period must be 0 or a positive number");
        tiling_.seed = seed;
        tiling_.period = period;
        load(tile_set);
    }

    PointDistribution(const PointDistribution&) = delete;
    PointDistribution& operator=(const PointDistribution&) = delete;

    /// Emits the points of the box with min <= p < max, so that boxes side by side share none: `emit(p)`, in the order
    /// of tiles. `density` is in points per unit area where `density_at(p)`, from 0 to 1, is 1.
    template <class Box, class DensityFunction, class PointFunction>
    void operator()(const Box& bounds, float density, DensityFunction&& density_at, PointFunction&& emit) const
    {
        using Position = PositionOf<Box>;
        (*this)(bounds, density, [&](const Position& p, float threshold) {
            if (density_at(p) >= threshold) emit(p);
        });
    }

    /// Makes points before the density is known: calls `emit(p, threshold)`; points with a density below the threshold
    /// are to be left out.
    template <class Box, class PointFunction>
    void operator()(const Box& bounds, float density, PointFunction&& emit) const
    {
        if (!(density > 0) || !(bounds.min.x < bounds.max.x) || !(bounds.min.y < bounds.max.y)) return;
        if (std::isinf(density)) throw std::range_error("the density is infinite");
        const Scale scale(*this, density);
        const Range columns = scale.range(tiling_.set, bounds.min.x, bounds.max.x);
        const Range rows = scale.range(tiling_.set, bounds.min.y, bounds.max.y);
        for (std::int32_t j = rows.first; j <= rows.last; ++j)
            for (std::int32_t i = columns.first; i <= columns.last; ++i) emit_tile(bounds, scale, i, j, emit);
    }

    /// The distribution that all share who need no other: of the file that the environment variable
    /// CORTEX_POINTDISTRIBUTION_TILESET names. Throws std::runtime_error.
    static const PointDistribution& defaultInstance()
    {
        static const PointDistribution shared(file_of_environment());
        return shared;
    }

    /// The density of the whole tiles that points of a density are taken from: the same for densities of which one has
    /// all the points of the other.
    double full_density(double density) const
    {
        const double one = full_density_ > 0 ? full_density_ : tiling_.set.points_per_tile;
        int exponent;
        const double part = std::frexp(density / one, &exponent); // in [1/2, 1): the ratio is part * 2^exponent
        const int doublings = part == 0.5 ? exponent - 1 : exponent;
        const int steps = doublings > 0 ? (doublings + 1) / 2 : -(-doublings / 2);
        return std::ldexp(one, 2 * (full_density_ > 0 && steps < 0 ? 0 : steps));
    }

    /// No two points of this density are nearer; it holds for each threshold as well. 0: the file has no proof.
    double min_distance(double density) const { return proven_distance_ * side_of_tiles(full_density(density)); }

    std::uint32_t points_per_tile() const { return tiling_.set.points_per_tile; }

    /// The side of tiles whose density is `full`.
    double side_of_tiles(double full) const { return std::sqrt(tiling_.set.points_per_tile / full); }

private:
    template <class Box>
    using PositionOf = typename std::decay<decltype(std::declval<Box>().min)>::type;

    /// Points of all tiles, in each by rank, as the file has their coordinates.
    struct StoredPoint
    {
        std::uint16_t x, y;
    };

    /// The tiles that a box can have points of.
    struct Range
    {
        std::int32_t first, last;
    };

    /// The size of tiles, and the part of their points that is asked for.
    struct Scale
    {
        double side, part;

        Scale(const PointDistribution& of, double density)
            : side(of.side_of_tiles(of.full_density(density))), part(density / of.full_density(density))
        {}

        /// Positions are rounded before they are compared with the box: one that is a little outside may end inside.
        template <class Number>
        Range range(const ptiles_set& set, Number low, Number high) const
        {
            const double below = std::nextafter(low, -std::numeric_limits<Number>::infinity());
            const double above = std::nextafter(high, std::numeric_limits<Number>::infinity());
            const double first = std::floor(below / side - set.above / 65536.0);
            const double last = std::floor(above / side + set.below / 65536.0);
            if (!(first > -2147483646.0 && last < 2147483645.0))
                throw std::range_error("bounds reach further than 2^31 tiles from the origin");
            return {static_cast<std::int32_t>(first), static_cast<std::int32_t>(last)};
        }
    };

    [[noreturn]] static void fail(const std::string& file, const std::string& problem)
    {
        throw std::runtime_error(file + ": " + problem);
    }

    static std::string file_of_environment()
    {
        const char* name = "CORTEX_POINTDISTRIBUTION_TILESET";
        const char* file = std::getenv(name);
        if (!file) fail(name, "the environment variable is not set: it names a ranked tile set (.ptiles)");
        return file;
    }

    /// Folders can be opened as files, and throw when they are read.
    static std::vector<char> bytes_of(std::istream& file, const std::string& name)
    {
        try {
            return {std::istreambuf_iterator<char>(file), {}};
        } catch (const std::ios_base::failure&) {
            fail(name, "cannot be read");
        }
    }

    void load(const std::string& name)
    {
        std::ifstream file(name, std::ios::binary);
        if (!file) fail(name, "cannot be opened");
        const std::vector<char> bytes = bytes_of(file, name);
        ptiles_set& set = tiling_.set;
        if (const char* problem = ptiles_open(&set, bytes.data(), bytes.size())) fail(name, problem);
        if (set.dimension != 2) fail(name, "tiles of space: must be a tile set in the plane");
        if (!set.ranks) fail(name, "the set is not ranked: tiles build --ranked makes one that is");
        proven_distance_ = ptiles_min_distance(&set);
        sort_by_rank(name);
        set.points = nullptr; // the bytes go
        set.ranks = nullptr;
        set.class_points = nullptr;
    }

    void sort_by_rank(const std::string& name)
    {
        const ptiles_set& set = tiling_.set;
        const std::uint64_t count = std::uint64_t{set.tiles} * set.points_per_tile;
        points_.resize(count);
        std::vector<bool> is_there(count);
        for (std::uint64_t n = 0; n < count; ++n) {
            const std::uint64_t place = n / set.points_per_tile * set.points_per_tile + set.ranks[n];
            if (set.ranks[n] >= set.points_per_tile || is_there[place])
                fail(name, "ranks that are not each there once");
            is_there[place] = true;
            points_[place] = {set.points[2 * n], set.points[2 * n + 1]};
        }
    }

    /// Points of a tile have the thresholds (rank + shift) / (N part), with a shift in (0, 1] that differs from tile to
    /// tile: so densities between r / N and (r + 1) / N of whole tiles are had as well. Shifts are those of Roberts' R2
    /// sequence over the lattice of tiles, which are even in every window of them.
    template <class Box, class PointFunction>
    void emit_tile(const Box& bounds, const Scale& scale, std::int32_t i, std::int32_t j, PointFunction& emit) const
    {
        const std::uint32_t n = tiling_.set.points_per_tile;
        const std::uint32_t x = ptiles_place(i, tiling_.period), y = ptiles_place(j, tiling_.period);
        // 2^32 / g and 2^32 / g^2, where g^3 = g + 1.
        const double shift = (x * 3242174889u + y * 2447445414u + 1.0) / 4294967296.0;
        const StoredPoint* points = points_.data() + std::uint64_t{ptiles_tile(&tiling_, i, j, 0)} * n;
        const double whole = n * scale.part;
        PositionOf<Box> p;
        for (std::uint32_t rank = 0; rank < n && rank + shift <= whole; ++rank) {
            p.x = static_cast<decltype(p.x)>(scale.side * (i + ptiles_coordinate(&tiling_.set, points[rank].x)));
            p.y = static_cast<decltype(p.y)>(scale.side * (j + ptiles_coordinate(&tiling_.set, points[rank].y)));
            if (p.x >= bounds.min.x && p.x < bounds.max.x && p.y >= bounds.min.y && p.y < bounds.max.y)
                emit(static_cast<const PositionOf<Box>&>(p), static_cast<float>((rank + shift) / whole));
        }
    }

    ptiles_tiling tiling_{};
    double full_density_ = 0;    ///< 0: steps from tiles of side 1
    double proven_distance_ = 0; ///< in tiles
    std::vector<StoredPoint> points_;
};

}

#endif
