#include "app/commands/tiles/window_points.hpp"

#include "base/densities/density_text.hpp"
#include "base/densities/density_values.hpp"
#include "base/densities/plane_formula.hpp"
#include "base/errors/errors.hpp"
#include "base/files/file_kind.hpp"
#include "base/programs/interrupt.hpp"
#include "host/tile_points/point_levels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace poissonlab {
namespace {

constexpr auto option = "tiles points: --density";

/// Points of a piece, about: 32 MiB of coordinates in 2D. It takes some hundredths of a second.
constexpr std::uint64_t points_per_piece = std::uint64_t{1} << 21;

/// With chains, points lie outside of their tiles' squares: those of a window are looked for one tile farther.
TileBlock searched_block(const WindowOfTiling& window, const PoissonTileParameters& p)
{
    if (p.border == TileBorder::strip || window.period > 0 || window.region) return window.block;
    TileBlock block = window.block;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        constexpr std::uint32_t most = 65'534;
        if (block.size[axis] > most)
            throw InputError(fmt::format("tiles points: --window: {} tiles along an axis: must be at most {} for tiles "
                                         "with chains",
                                         block.size[axis], most));
        --block.lowest[axis];
        block.size[axis] += 2;
    }
    check(block, p.dimension);
    return block;
}

std::uint32_t pieces_of(std::uint64_t tiles, std::uint64_t tiles_per_piece)
{
    constexpr std::uint64_t most = std::uint64_t{1} << 24;
    const std::uint64_t pieces = (tiles + tiles_per_piece - 1) / tiles_per_piece;
    if (pieces > most)
        throw InputError(fmt::format("tiles points: {} tiles: must be at most {} of so many points in one file", tiles,
                                     most * tiles_per_piece));
    return static_cast<std::uint32_t>(pieces);
}

}

WindowDensity::WindowDensity(const std::string& text, const std::string& from, const DensityArea& area, int dimension,
                             bool is_quiet)
    : area_(area)
{
    if (from != "light" && !is_file_name(text))
        throw InputError(fmt::format("tiles points: --density-from {}: is for pictures, and --density {} is none",
                                     printable(from), shortened(text)));
    if (const auto number = is_file_name(text) ? std::nullopt : constant_of(text)) {
        if (!(*number > 0 && *number <= 1))
            throw InputError(fmt::format("{} {}: must be a number greater than 0 and at most 1, a picture or a formula",
                                         option, text));
        number_ = *number;
        return;
    }
    if (dimension != 2)
        throw InputError(fmt::format("{} {}: must be a number for tiles in space", option, shortened(text)));
    try {
        density_ = density_of_text(text, from, area.size[0], area.size[1]);
        if (!density_->note.empty() && !is_quiet) fmt::print(stderr, "poissonlab: note: {}\n", density_->note);
    } catch (const UnknownChannel& error) {
        throw InputError(fmt::format("tiles points: --density-from: {}", error.what()));
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", option, error.what()));
    }
}

WindowPoints::WindowPoints(UnitStream units, const PoissonTileSet& tiles, const WindowOfTiling& window,
                           const WindowDensity& density)
    : tiles_(tiles), window_(window), density_(density),
      dimension_(static_cast<std::size_t>(tiles.parameters.dimension)),
      has_overhang_(tiles.parameters.border == TileBorder::chain), block_(searched_block(window, tiles.parameters)),
      tiles_per_piece_(std::max<std::uint64_t>(1, points_per_piece / tiles.parameters.points_per_tile)),
      pieces_(pieces_of(block_.tiles(), tiles_per_piece_)), units_(std::move(units))
{
    const TileClasses& classes = tiles.parameters.classes;
    for (std::uint32_t of = 0; of < classes.count(); ++of)
        tile_classes_.insert(tile_classes_.end(), classes.points[of], of);
}

std::uint64_t WindowPoints::least_points() const
{
    const TileBlock& b = window_.block;
    if (has_known_counts()) return b.tiles() * tiles_.parameters.points_per_tile;
    if (!density_.is_full() || window_.region || b.size[0] < 3 || b.size[1] < 3) return 0;
    return std::uint64_t{b.size[0] - 2} * (b.size[1] - 2) * tiles_.parameters.points_per_tile; // of tiles well inside
}

std::uint64_t PiecedPoints::count_all()
{
    std::uint64_t all = 0;
    for (std::uint32_t piece = 0; piece < pieces(); ++piece) all += count(piece);
    return all;
}

std::uint64_t WindowPoints::count(std::uint32_t piece)
{
    const std::uint64_t first = piece * tiles_per_piece_;
    if (has_known_counts())
        return std::min(tiles_per_piece_, block_.tiles() - first) * tiles_.parameters.points_per_tile;
    make_in_plane(piece, counted_, nullptr);
    return counted_.size() / dimension_;
}

void WindowPoints::make(std::uint32_t piece, std::vector<double>& coordinates, std::vector<std::uint32_t>* classes)
{
    make_in_plane(piece, coordinates, classes);
    if (window_.map) window_.map->to_file(coordinates);
}

void WindowPoints::make_in_plane(std::uint32_t piece, std::vector<double>& coordinates,
                                 std::vector<std::uint32_t>* classes)
{
    const PoissonTiling tiling{window_.seed, static_cast<std::int32_t>(window_.period)};
    const std::uint64_t first = piece * tiles_per_piece_, end = std::min(first + tiles_per_piece_, block_.tiles());
    PointLevels levels(tiles_, tiling, block_, first);
    coordinates.clear();
    coordinates.reserve((end - first) * values_per_tile());
    if (classes) classes->clear();
    units_(tiling, block_, first, end, [&](std::span<const std::uint32_t> units) {
        stop_if_interrupted();
        const auto add_class = [&](std::size_t point) {
            if (classes) classes->push_back(tile_classes_[point % tile_classes_.size()]);
        };
        if (has_known_counts()) {
            append(units, coordinates);
            for (std::size_t i = 0; i < units.size() / dimension_; ++i) add_class(i);
            return;
        }
        std::span<const double> level;
        if (!density_.is_full()) level = levels.next(units.size() / values_per_tile());
        for (std::size_t i = 0; i < units.size() / dimension_; ++i) {
            const std::size_t before = coordinates.size();
            if (!append_if_inside(units.subspan(i * dimension_, dimension_), coordinates)) continue;
            if (!level.empty() && !density_.keeps(std::span(coordinates).subspan(before), level[i]))
                coordinates.resize(before);
            else
                add_class(i);
        }
    });
}

/// Appends all points: none is outside of the window.
void WindowPoints::append(std::span<const std::uint32_t> units, std::vector<double>& coordinates) const
{
    const std::size_t before = coordinates.size();
    coordinates.resize(before + units.size());
    double* const out = coordinates.data() + before;
    if (has_overhang_)
        for (std::size_t i = 0; i < units.size(); ++i)
            out[i] = static_cast<double>(torus_place(units[i], window_.period)) / units_per_tile;
    else
        for (std::size_t i = 0; i < units.size(); ++i) out[i] = static_cast<double>(units[i]) / units_per_tile;
}

/// Appends a point and says so, unless it is outside of the window or the region.
bool WindowPoints::append_if_inside(std::span<const std::uint32_t> units, std::vector<double>& coordinates) const
{
    if (window_.region) return window_.region->append_if_inside(units, coordinates);
    if (!has_overhang_ || window_.period > 0) {
        append(units, coordinates);
        return true;
    }
    constexpr std::uint32_t margin = units_per_tile; // of the block around the window
    for (std::size_t axis = 0; axis < units.size(); ++axis)
        if (units[axis] < margin || units[axis] - margin >= std::uint64_t{units_per_tile} * window_.block.size[axis])
            return false;
    for (const std::uint32_t unit : units) coordinates.push_back(static_cast<double>(unit - margin) / units_per_tile);
    return true;
}

}
