// Random periodic tilings of a tile set, from the words of docs/tile-set-file.md and nothing else.
#pragma once

#include "base/geometry/point_set.hpp"
#include "tests/tiles/poisson/made_up_tile_sets.hpp"
#include "tiles/poisson/poisson_tile_set.hpp"

#include <array>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace poissonlab {

class MadeUpTiling
{
public:
    MadeUpTiling(const PoissonTileParameters& parameters, int period, unsigned seed)
        : parameters_(parameters), period_(period), dimension_(parameters.dimension)
    {
        std::mt19937 random(seed);
        const std::uint32_t choices = parameters.kind == PoissonTileKind::frame ? parameters.tiles : parameters.colors;
        const int layers = dimension_ == 3 ? period : 2; // 2D: of edges, eastwards and northwards
        colors_.resize(static_cast<std::size_t>(period * period * layers));
        for (std::uint32_t& color : colors_) color = static_cast<std::uint32_t>(random() % choices);
    }

    int period() const { return period_; }

    std::uint32_t tile(int i, int j, int k = 0) const
    {
        if (parameters_.kind == PoissonTileKind::frame) return color(i, j, 0);
        std::vector<std::uint32_t> digits;
        for (int z = dimension_ == 3 ? k + 1 : k; z >= k; --z)
            for (const auto& [x, y] : {std::pair(i + 1, j + 1), {i + 1, j}, {i, j}, {i, j + 1}})
                digits.push_back(color(x, y, z));
        if (parameters_.kind == PoissonTileKind::edge) digits = edge_digits(i, j);
        std::uint32_t number = 0;
        for (const std::uint32_t digit : digits) number = number * parameters_.colors + digit;
        return number;
    }

    /// The points of the tile at a place, relative to the tile at the origin.
    void append(const PoissonTileSet& set, int i, int j, int k, std::vector<TestPosition>& points) const
    {
        const auto tile_points = set.tile(tile(i, j, k));
        const StoredScale scale = stored_scale(set.parameters.border);
        const std::array<int, 3> place{i, j, k};
        for (std::size_t p = 0; p < tile_points.size(); p += static_cast<std::size_t>(dimension_)) {
            TestPosition position{};
            for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis)
                position[axis] = scale.position(tile_points[p + axis]) + place[axis] * tile_units;
            points.push_back(position);
        }
    }

    /// All points, with the period as the side of the unit torus. Exact for powers of two.
    PointSet on_torus(const PoissonTileSet& set) const
    {
        std::vector<TestPosition> points;
        for (int k = 0; k < (dimension_ == 3 ? period_ : 1); ++k)
            for (int j = 0; j < period_; ++j)
                for (int i = 0; i < period_; ++i) append(set, i, j, k, points);
        PointSet result{dimension_, {}};
        for (const TestPosition& p : points)
            for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis)
                result.coordinates.push_back(static_cast<double>(p[axis]) / (tile_units * period_));
        return result;
    }

private:
    std::uint32_t color(int x, int y, int z) const
    {
        const auto wrapped = [this](int v) { return (v % period_ + period_) % period_; };
        return colors_[static_cast<std::size_t>((wrapped(z) * period_ + wrapped(y)) * period_ + wrapped(x))];
    }

    std::vector<std::uint32_t> edge_digits(int i, int j) const
    {
        const auto east_of = [this](int x, int y) { return color(x, y, 0); };
        const auto north_of = [this](int x, int y) { return color(x, y, 1); };
        return {east_of(i, j + 1),     north_of(i + 1, j),     east_of(i, j),         north_of(i, j),
                east_of(i + 1, j + 1), north_of(i + 1, j + 1), east_of(i + 1, j),     north_of(i + 1, j - 1),
                east_of(i - 1, j),     north_of(i, j - 1),     east_of(i - 1, j + 1), north_of(i, j + 1)};
    }

    PoissonTileParameters parameters_;
    int period_;
    int dimension_;
    std::vector<std::uint32_t> colors_;
};

}
