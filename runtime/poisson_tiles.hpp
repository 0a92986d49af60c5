// SPDX-License-Identifier: MIT-0
//
// This wraps poisson_tiles.h for C++11: a tile set owns its bytes, and points of its tilings come as ranges.
//
//     const ptiles::TileSet set("corner-c4-n64-r075.ptiles");
//     const ptiles::Tiling tiling(set, 7);
//     for (const ptiles_point& point : tiling.window({0, 0}, {16, 9}, 0.5)) draw(point.position, point.id);
//     for (const ptiles_point& point : tiling.window({0, 0}, {16, 9}) | std::views::filter(is_tree)) plant(point); //
//     C++20
#ifndef POISSON_TILES_HPP
#define POISSON_TILES_HPP

#include "poisson_tiles.h"

#include <array>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace ptiles {

using Position = std::array<double, 3>; // in tiles; the third number counts in 3D only

// Reads the tiles of a file. Throws std::runtime_error, which says what is wrong.
class TileSet
{
public:
    explicit TileSet(const std::string& file) : TileSet(content_of(file), file) {}
    explicit TileSet(std::vector<char> bytes, const std::string& name = "tile set") : bytes_(std::move(bytes))
    {
        const char* problem = ptiles_open(&set_, bytes_.data(), bytes_.size());
        if (problem) throw std::runtime_error(name + ": " + problem);
    }
    TileSet(const TileSet&) = delete; // it points into its own bytes
    TileSet& operator=(const TileSet&) = delete;

    const ptiles_set& get() const { return set_; }
    double min_distance() const { return ptiles_min_distance(&set_); }
    unsigned exponent() const { return ptiles_exponent(&set_); }
    bool is_ranked() const { return ptiles_is_ranked(&set_) != 0; }
    unsigned class_of(const ptiles_point& point) const { return ptiles_class(&set_, point.index); }

private:
    static std::vector<char> content_of(const std::string& file)
    {
        std::ifstream stream(file, std::ios::binary);
        if (!stream) throw std::runtime_error(file + ": cannot be opened");
        return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    }

    std::vector<char> bytes_;
    ptiles_set set_{};
};

// Says which tile is where, by the seed. The set must live as long as this.
class Tiling
{
public:
    // The tiling closes after `period` tiles along each axis, 0: never.
    explicit Tiling(const TileSet& set, uint32_t seed = 1, int32_t period = 0) : tiling_{set.get(), seed, period} {}

    // Returns the points p with low <= p < high along each axis and a level below the density: see ptiles_in_window.
    std::vector<ptiles_point> window(const Position& low, const Position& high, double density = 1) const
    {
        const uint64_t count = ptiles_in_window(&tiling_, low.data(), high.data(), nullptr, 0, density);
        std::vector<ptiles_point> points(count);
        ptiles_in_window(&tiling_, low.data(), high.data(), points.data(), count, density);
        return points;
    }

    // Returns the point that is nearest to a position, and the squared distance.
    std::pair<ptiles_point, double> nearest(const Position& position) const
    {
        ptiles_point point;
        const double squared = ptiles_nearest(&tiling_, position.data(), &point);
        return {point, squared};
    }

    const ptiles_tiling& get() const { return tiling_; }

private:
    ptiles_tiling tiling_;
};

}
#endif
