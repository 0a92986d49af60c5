#include "app/commands/tiles/monotile_work.hpp"

#include "app/commands/output_file.hpp"
#include "base/errors/errors.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/programs/interrupt.hpp"
#include "host/settings/tilings/polygon_tiling_file.hpp"
#include "reports/engine/monotile_page.hpp"
#include "tiles/monotiles/monotile_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

constexpr double points_per_strip = 0x1p20;

/// Returns the window's lowest corner and its size.
std::array<std::int64_t, 4> checked_monotile_window(const TilesPointsOptions& options)
{
    const std::string option = fmt::format("tiles points: --window {}", fmt::join(options.window, " "));
    if (options.window.size() != 4) throw InputError(option + ": must be X Y W H");
    std::array<std::int64_t, 4> window{};
    std::ranges::copy(options.window, window.begin());
    for (std::size_t axis = 0; axis < 2; ++axis)
        if (window[axis] < -farthest_monotile_origin || window[axis] > farthest_monotile_origin ||
            window[axis + 2] < 1 || window[axis + 2] > farthest_monotile_corner)
            throw InputError(fmt::format("{}: places are from -2^40 to 2^40, and sizes from 1 to {}", option,
                                         farthest_monotile_corner));
    return window;
}

}

void verify_monotile(const std::filesystem::path& path, bool as_json)
{
    const MonotilePointsFile file = read_monotile_points(path);
    const MonotileTable table = proven_monotile_table(file, built_in_tiling(file.tiling()));
    std::vector<double> distances;
    for (const SquaredLength& squared : table.distances) distances.push_back(squared.length());
    const double to_radius = std::sqrt(file.density()) / max_min_distance(1, 2);
    if (as_json) {
        const nlohmann::ordered_json json{
            {"file", printable(path.string())},
            {"kind", file.tiling()},
            {"states", file.set().states},
            {"points_per_tile", table.points},
            {"levels", file.levels()},
            {"ranked", true},
            {"relative_radius", distances.back() * to_radius},
            {"min_distance", distances.back()},
            {"squared_min_distance", {table.distances.back().whole, table.distances.back().root}},
            {"min_distances_of_first_points", distances},
            {"proven_exponent", pmono_exponent(&file.set())}};
        fmt::print("{}\n", json.dump(2));
        return;
    }
    const auto line = [](const std::string& name, const std::string& value) { fmt::print("{:<22}{}\n", name, value); };
    line("kind", file.tiling());
    line("states of tiles", fmt::format("{}, by the tiles around and {} ancestors", file.set().states, file.levels()));
    line("points per tile", std::to_string(table.points));
    line("relative radius", fmt::format("{:.6f} proven", distances.back() * to_radius));
    line("minimum distance", fmt::format("{:.6f} edges: the root of ({} + {} sqrt 3) / 2^32", distances.back(),
                                         table.distances.back().whole, table.distances.back().root));
    line("stored guarantee", "what is proven");
    for (std::size_t kept = 1; kept < distances.size(); ++kept)
        line(fmt::format("first {} of each tile", kept), fmt::format("minimum distance {:.6f}", distances[kept - 1]));
}

std::string monotile_page(const std::string& bytes, const std::string& name)
{
    const MonotilePointsFile file(bytes, name);
    std::vector<std::array<std::int64_t, 4>> outline;
    for (const RingPlace& corner : built_in_tiling(file.tiling()).prototiles[0].corners)
        outline.push_back({corner.c[0], corner.c[1], corner.c[2], corner.c[3]});
    return render_monotile_page(bytes, name, outline);
}

MonotileWindow::MonotileWindow(const TilesPointsOptions& options)
    : options_(options), file_(read_monotile_points(options.file))
{
    check_region_options(options, 2);
    if (options.torus > 0)
        throw InputError("tiles points: --torus: tilings with one tile that never repeats never close");
    if (options.window.empty() == options.region.empty())
        throw InputError("tiles points: needs one of --window and --region");
    out = checked_output("tiles points", "--out", options.out, point_formats());
    head.dimension = 2;
    if (options.region.empty())
        set_up_window();
    else
        set_up_region();
    check_head(out, head);
}

void MonotileWindow::set_up_window()
{
    window_ = checked_monotile_window(options_);
    const std::array<double, 2> size{static_cast<double>(window_[2]), static_cast<double>(window_[3])};
    density_.emplace(options_.density, options_.density_from, DensityArea{{}, size}, 2, options_.work.is_quiet());
    strip_ = std::max(1.0, std::floor(points_per_strip / (size[0] * file_.density())));
    pieces_ = static_cast<std::uint32_t>(std::ceil(size[1] / strip_));
    head.side = std::max(size[0], size[1]);
    head.fills_square = window_[2] == window_[3];
    head.comment = comment_of(options_, "coordinates in edges, from the lowest corner of the window");
}

void MonotileWindow::set_up_region()
{
    plane_ = read_points_region(options_);
    const auto region = std::make_shared<const FixedRegion>(plane_);
    const RegionBox& box = region->box();
    density_.emplace(options_.density, options_.density_from, DensityArea{box.low, {box.width(), box.height()}}, 2,
                     options_.work.is_quiet());
    head.side = 0;
    head.unit = file_units(plane_);
    const auto lay_tiles = [&](double edge) {
        laid_.emplace(file_, region, edge);
        pieces_ = laid_->strips();
    };
    try {
        if (options_.points == 0)
            lay_tiles(edge_for(options_.min_distance, file_, box));
        else
            lay_tiles(tile_width_for_points(
                options_.points, std::sqrt(region->area() * file_.density() / static_cast<double>(options_.points)),
                [&](double edge) {
                    lay_tiles(edge);
                    return count_all();
                }));
    } catch (const InputError& error) {
        throw InputError(fmt::format("tiles points: --region: {}", error.what()));
    }
    head.comment = comment_of(options_, fmt::format("in {}; an edge is {} long", head.unit, laid_->edge()));
}

double MonotileWindow::min_distance() const
{
    if (!laid_) return pmono_min_distance(&file_.set());
    return options_.points == 0 ? options_.min_distance : min_distance_with(laid_->edge(), file_, box_of(plane_));
}

std::optional<double> MonotileWindow::edge() const { return laid_ ? std::optional(laid_->edge()) : std::nullopt; }

std::vector<pmono_point> MonotileWindow::points_of(std::uint32_t piece) const
{
    if (laid_) return laid_->points(piece, options_.seed);
    const std::array<double, 2> size{static_cast<double>(window_[2]), static_cast<double>(window_[3])};
    return file_.in_window(options_.seed, {window_[0], window_[1]}, {0, piece * strip_},
                           {size[0], std::min(size[1], (piece + 1) * strip_)});
}

std::vector<double> MonotileWindow::kept_points(std::uint32_t piece) const
{
    stop_if_interrupted();
    std::vector<double> coordinates;
    for (const pmono_point& point : points_of(piece))
        if (density_->is_full() || density_->keeps(point.position, point.level))
            coordinates.insert(coordinates.end(), {point.position[0], point.position[1]});
    return coordinates;
}

std::uint64_t MonotileWindow::count(std::uint32_t piece) { return kept_points(piece).size() / 2; }

void MonotileWindow::make(std::uint32_t piece, std::vector<double>& coordinates,
                          std::vector<std::uint32_t>* /*classes*/)
{
    coordinates = kept_points(piece);
    if (laid_ && is_mapped(plane_)) plane_.source->map->to_file(coordinates);
}

}
