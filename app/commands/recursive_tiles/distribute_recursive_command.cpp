// poissonlab distribute recursive: points of recursive Wang tiles in a window anywhere, paintings, and the live page.
#include "app/commands/kind_options.hpp"
#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "base/images/png_file.hpp"
#include "base/points/point_file.hpp"
#include "host/distribution/recursive_tiles/recursive_tile_run.hpp"
#include "host/kinds/kinds.hpp"
#include "reports/engine/recursive_page.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {
namespace {

constexpr auto distribute_recursive_notes =
    R"help(The plane is tiled without end: --x and --y name any of its tiles, from -2^52 to 2^52. Each tile is made of 4 x 4
smaller ones, each of these of 4 x 4, and so on: digits after a colon say which quarter of a side, which quarter of that.
"-5:01" is the second quarter of the first quarter of tile -5. A window of --size tiles of that level is made by itself,
at any depth up to 1000 digits. Windows of one seed fit together: where they overlap, those with the same points in a tile
have the same points, to the last bit, and a digit more with a sixteenth of the points in a tile is the same set, nearer.
More points add some and move none.
With --density points follow a picture or a formula, laid over the window; --points is then about their number. Ranks
decide which points are there.
--out, as often as you like: .csv has columns x, y, stamp, turn (radians) and size; .png is painted on white paper,
--pixels wide, with a dot or one of the --stamps at each point; .html is a page on which one zooms into the tiling for
ever and paints with a brush, which opens from the disk; other files are point files. Coordinates are in tiles, from the
lowest corner of the window.
  poissonlab distribute recursive --x 2147483648:0312 --y -7:3301 --size 8 8 --points 5000 --out points.npy
  poissonlab distribute recursive --points 20000 --density photo.jpg --density-from ink --stamps leaf.png --out leaves.png
  poissonlab distribute recursive --points 1000 --out zoom.html)help";

constexpr std::uint32_t most_painting_pixels = 8192;
constexpr std::int64_t most_painting_values = std::int64_t{1} << 26; // 15 bytes each

/// Writes coordinates in tiles; a square window's file says its domain.
void write_places(const KindOptions& o, const std::filesystem::path& file, const RecursiveTileSettings& settings,
                  const StampedWindow& window)
{
    const auto& size = settings.window.size;
    std::string comment = o.command_comment("coordinates in tiles, from the lowest corner of the window");
    if (size[0] == size[1]) comment = fmt::format("domain 0:{}\n{}", size[0], comment);
    write_points_in_pieces(file, 2, window.points.size(), comment, [&](const PointSink& sink) {
        std::vector<double> coordinates;
        for (const StampedPoint& point : window.points)
            coordinates.insert(coordinates.end(), point.place.begin(), point.place.end());
        sink(coordinates);
    });
}

std::string page_of_window(const KindOptions& o, const RecursiveTileSettings& settings, const StampedWindow& window)
{
    RecursivePage page{
        window.seed,
        fmt::format("x={}&y={}", text_of(settings.window.corner[0]), text_of(settings.window.corner[1])),
        fmt::format("{} --seed {} --points-per-tile {}", o.command(), o.seed(), settings.points_per_tile),
        {},
        settings.stamp_size,
        !settings.is_upright};
    for (const std::filesystem::path& stamp : settings.stamps) page.stamps.push_back(read_whole_file(stamp));
    return render_recursive_page(window.tiles, page);
}

/// Throws InputError for a painting that has no room in memory.
void check_height(const KindOptions& o, const RecursiveWindow& window)
{
    const int high = painting_height(window, static_cast<int>(o.pixels));
    const bool is_painted =
        std::ranges::any_of(o.outs.files(), [](const auto& out) { return out.extension() == ".png"; });
    if (is_painted && std::int64_t{o.pixels} * high > most_painting_values)
        throw InputError(
            fmt::format("{}: --pixels {}: the picture would be {} pixels high: must have at most {} pixels",
                        o.command(), o.pixels, high, most_painting_values));
}

void place_recursive(const KindOptions& o)
{
    const auto settings = o.read<RecursiveTileSettings>();
    check_height(o, settings.window);
    const StampedWindow window = stamped_window(settings, o.seed(), o.place());
    o.say_note(window.note);
    for (const std::filesystem::path& out : o.outs.files()) {
        if (out.extension() == ".png")
            write_png(out, painting(settings, window, static_cast<int>(o.pixels)));
        else if (out.extension() == ".html")
            write_whole_file(out, page_of_window(o, settings, window));
        else if (out.extension() == ".csv")
            write_whole_file(out, stamps_csv(window));
        else
            write_places(o, out, settings, window);
    }
    if (o.prints_json()) return print_numbers(recursive_tile_numbers(settings, window));
    if (!o.is_quiet()) fmt::print("{} points\n", window.points.size());
}

}

Command distribute_recursive_command()
{
    return kind_command(*find_kind("distribution", "recursive-tiles"), {{{".png", ".html", ".csv"}, true}},
                        distribute_recursive_notes, place_recursive, "", {most_painting_pixels, "1024", 1024});
}

}
