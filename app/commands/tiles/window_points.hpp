// The points of a window of a tiling, of a whole torus, or of a region, in pieces that any process can make.
#pragma once

#include "base/densities/density.hpp"
#include "base/regions/region_source.hpp"
#include "host/tile_points/tile_points.hpp"
#include "host/tile_points/tiled_region.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace poissonlab {

// The density that a command's points follow over a window of tiles, as it is typed: --density NUMBER|IMAGE|FORMULA.

/// The rectangle that a picture or a formula is laid over, in the units of points.
struct DensityArea
{
    std::array<double, 2> low{};
    std::array<double, 2> size{};
};

class WindowDensity
{
public:
    /// `from` says what of a picture: see density_of_picture(). Throws InputError, a line that starts with the option,
    /// where the text is none of the three, the number is not above 0 and at most 1, or tiles in space are given a
    /// picture or a formula.
    WindowDensity(const std::string& text, const std::string& from, const DensityArea& area, int dimension,
                  bool is_quiet = false);

    bool is_full() const { return !density_ && number_ >= 1; }

    /// Tells whether a point stays: its level is below the density.
    bool keeps(std::span<const double> point, double level) const
    {
        if (!density_) return level < number_;
        const auto weight =
            density_->at((point[0] - area_.low[0]) / area_.size[0], (point[1] - area_.low[1]) / area_.size[1]);
        return level * static_cast<double>(full_weight) < static_cast<double>(weight);
    }

private:
    double number_ = 1;
    std::optional<Density> density_;
    DensityArea area_;
};

/// A tiling, and a block of its tiles.
struct WindowOfTiling
{
    TileBlock block;
    std::uint32_t period = 0; ///< of the torus that the block is; 0: the plane
    std::uint32_t seed = 1;
    std::shared_ptr<const TiledRegion> region{}; ///< only points in it, in its units: the block is its block
    std::shared_ptr<const PlaneMap> map{}; ///< by which its points become longitudes and latitudes; null: they stay
};

/// Points that are made in pieces, in an order that does not depend on the process that makes a piece.
class PiecedPoints
{
public:
    virtual ~PiecedPoints() = default;

    virtual std::uint32_t pieces() const = 0;

    /// True if the number of points follows without making them.
    virtual bool has_known_counts() const = 0;

    /// A lower bound of the number of all points.
    virtual std::uint64_t least_points() const = 0;

    /// The number of a piece's points, which are made where it is not known.
    virtual std::uint64_t count(std::uint32_t piece) = 0;

    /// Makes the points of a piece, instead of what is in `coordinates`; and, where it is asked for, the class of each.
    virtual void make(std::uint32_t piece, std::vector<double>& coordinates,
                      std::vector<std::uint32_t>* classes = nullptr) = 0;

    /// The number of all points.
    std::uint64_t count_all();
};

/// Makes the coordinates, in tiles from the window's lowest corner, or in a region's units. Pieces do not depend on the
/// device: together, one after another, they have the points in their order.
class WindowPoints final : public PiecedPoints
{
public:
    /// `tiles` and `density` must outlive this. Throws InputError for windows that are too large.
    WindowPoints(UnitStream units, const PoissonTileSet& tiles, const WindowOfTiling& window,
                 const WindowDensity& density);

    std::uint32_t pieces() const override { return pieces_; }
    bool has_known_counts() const override
    {
        return (!has_overhang_ || window_.period > 0) && density_.is_full() && !window_.region;
    }

    std::uint64_t least_points() const override;
    std::uint64_t count(std::uint32_t piece) override;
    void make(std::uint32_t piece, std::vector<double>& coordinates,
              std::vector<std::uint32_t>* classes = nullptr) override;

private:
    /// Makes them in the plane that tiles lie in.
    void make_in_plane(std::uint32_t piece, std::vector<double>& coordinates, std::vector<std::uint32_t>* classes);
    std::size_t values_per_tile() const { return tiles_.parameters.points_per_tile * dimension_; }
    void append(std::span<const std::uint32_t> units, std::vector<double>& coordinates) const;
    bool append_if_inside(std::span<const std::uint32_t> units, std::vector<double>& coordinates) const;

    const PoissonTileSet& tiles_;
    WindowOfTiling window_;
    const WindowDensity& density_;
    std::size_t dimension_;
    bool has_overhang_; ///< points lie outside of their tiles' squares
    TileBlock block_;   ///< the tiles whose points are looked at
    std::uint64_t tiles_per_piece_;
    std::uint32_t pieces_;
    UnitStream units_;
    std::vector<std::uint32_t> tile_classes_; ///< of a tile's points; empty: they have none
    std::vector<double> counted_;
};

}
