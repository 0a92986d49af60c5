// poissonlab distribute rank: the points of a ranked, self-similar tile that a picture or a formula asks for.
#include "app/commands/kind_options.hpp"
#include "host/distribution/place_file.hpp"
#include "host/distribution/runs/run_numbers.hpp"
#include "host/distribution/self_similar_tile.hpp"
#include "host/kinds/kinds.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {
namespace {

constexpr auto distribute_rank_notes =
    R"(The tile of the dissertation's section 4.7 has copies of itself in its quarters: 16 points, each with a rank. It is
divided where the density asks for more points than it has, and elsewhere keeps those of low rank. The number of points
is about the one that is asked for; seeds 1 to 16 choose the point of rank 0. Coordinates are in units of the longest
side, y upwards; formulas are over a square. Both engines are the same: no device is opened. Ranks of tile sets are used by `tiles points --density`.
  poissonlab distribute rank --density photo.jpg --density-from ink --points 13000 --out dots.ply
  poissonlab distribute rank --density gauss-and-waves --points 2048 --out blob.npy)";

void rank(const KindOptions& o)
{
    const auto settings = o.read<RankSettings>();
    const Density density = rank_density(settings);
    const auto first = static_cast<std::size_t>((o.seed() + settings.tile.points - 1) % settings.tile.points);
    const auto ranked =
        ranked_points(self_similar_points({settings.tile.x, settings.tile.y}, settings.tile.points), first);
    const PixelPlaces places = places_of(subdivided_points(ranked, density, static_cast<double>(settings.points)));
    for (const std::filesystem::path& out : o.outs.files())
        write_places(
            out, places, static_cast<std::uint32_t>(std::max(density.width, density.height)),
            o.command_comment(fmt::format("{} points in units of the longest side of {} x {} pixels, y upwards",
                                          places.size() / 2, density.width, density.height)));
    if (o.prints_json()) print_numbers(rank_numbers(settings, density, places));
}

}

Command distribute_rank_command()
{
    return kind_command(*find_kind("distribution", "ranks"), {point_formats()}, distribute_rank_notes, rank);
}

}
