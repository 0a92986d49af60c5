#include "app/commands/tiles/monotile_work.hpp"

#include "app/commands/output_file.hpp"
#include "base/errors/errors.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/programs/interrupt.hpp"
#include "host/settings/tilings/polygon_tiling_file.hpp"
#include "tiles/monotiles/monotile_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

constexpr std::int64_t farthest_origin = std::int64_t{1} << 40, largest_side = std::int64_t{1} << 20;
constexpr double points_per_strip = 0x1p20;

/// Checks the options of `tiles points`. Returns the window's lowest corner and its size.
std::array<std::int64_t, 4> checked_monotile_window(const TilesPointsOptions& options)
{
    check_region_options(options, 2);
    if (options.torus > 0)
        throw InputError("tiles points: --torus: tilings with one tile that never repeats never close");
    if (!options.region.empty()) throw InputError("tiles points: --region: needs a set of square tiles");
    if (options.window.empty()) throw InputError("tiles points: needs --window X Y W H");
    const std::string option = fmt::format("tiles points: --window {}", fmt::join(options.window, " "));
    if (options.window.size() != 4) throw InputError(option + ": must be X Y W H");
    std::array<std::int64_t, 4> window{};
    std::ranges::copy(options.window, window.begin());
    for (std::size_t axis = 0; axis < 2; ++axis)
        if (window[axis] < -farthest_origin || window[axis] > farthest_origin || window[axis + 2] < 1 ||
            window[axis + 2] > largest_side)
            throw InputError(
                fmt::format("{}: places are from -2^40 to 2^40, and sizes from 1 to {}", option, largest_side));
    return window;
}

std::string comment_of_window(const TilesPointsOptions& options)
{
    std::vector<std::string> words{file_word(options.file.string()), "--window"};
    for (const std::int64_t number : options.window) words.push_back(std::to_string(number));
    if (options.density != "1") words.insert(words.end(), {"--density", options.density});
    if (options.density_from != "light") words.insert(words.end(), {"--density-from", options.density_from});
    return command_comment("tiles points", words, options.seed,
                           "coordinates in edges, from the lowest corner of the window");
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

MonotileWindow::MonotileWindow(const TilesPointsOptions& options)
    : options_(options), file_(read_monotile_points(options.file)),
      window_(checked_monotile_window(options)), size_{static_cast<double>(window_[2]),
                                                       static_cast<double>(window_[3])},
      density_(options.density, options.density_from, {{}, size_}, 2, options.work.is_quiet())
{
    strip_ = std::max(1.0, std::floor(points_per_strip / (size_[0] * file_.density())));
    pieces_ = static_cast<std::uint32_t>(std::ceil(size_[1] / strip_));
    out = checked_output("tiles points", "--out", options.out, point_formats());
    head.dimension = 2;
    head.side = std::max(size_[0], size_[1]);
    head.fills_square = window_[2] == window_[3];
    head.comment = comment_of_window(options);
    check_head(out, head);
}

std::uint64_t MonotileWindow::count(std::uint32_t piece)
{
    make(piece, counted_, nullptr);
    return counted_.size() / 2;
}

void MonotileWindow::make(std::uint32_t piece, std::vector<double>& coordinates,
                          std::vector<std::uint32_t>* /*classes*/)
{
    stop_if_interrupted();
    const std::array<double, 2> low{0, piece * strip_};
    const std::array<double, 2> high{size_[0], std::min(size_[1], (piece + 1) * strip_)};
    const auto find = [&] {
        return pmono_in_window(&file_.set(), options_.seed, window_.data(), low.data(), high.data(), found_.data(),
                               found_.size(), 1);
    };
    std::uint64_t count = find();
    if (count > found_.size()) {
        found_.resize(count);
        count = find();
    }
    coordinates.clear();
    for (std::size_t i = 0; i < count; ++i)
        if (density_.is_full() || density_.keeps(found_[i].position, found_[i].level))
            coordinates.insert(coordinates.end(), {found_[i].position[0], found_[i].position[1]});
}

}
