// poissonlab distribute rank: the points of a ranked, self-similar tile that a picture or a formula asks for.
#include "app/commands/distribution/distribute_options.hpp"
#include "host/config/distributions/distribution_config.hpp"
#include "host/distribution/place_file.hpp"
#include "host/distribution/self_similar_tile.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {
namespace {

constexpr auto distribute_rank_notes =
    R"(The tile of the dissertation's section 4.7 has copies of itself in its quarters: 16 points, each with a rank. It is
divided where the density asks for more points than it has, and elsewhere keeps those of low rank. The number of points
is about the one that is asked for; seeds 1 to 16 choose the point of rank 0. Coordinates are in units of the longest side, y upwards; formulas are over a square. Both engines are
the same: no device is opened. Ranks of tile sets are used by `tiles points --density`.
  poissonlab distribute rank --density photo.jpg --density-from ink --points 13000 --out dots.ply
  poissonlab distribute rank --density gauss-and-waves --points 2048 --out blob.npy)";

void rank(const DistributeOptions& o)
{
    check(o);
    const Density density = read_density(o);
    const SelfSimilarChoice tile;
    const auto first = static_cast<std::size_t>((o.seed + tile.points - 1) % tile.points);
    const auto ranked = ranked_points(self_similar_points({tile.x, tile.y}, tile.points), first);
    const PixelPlaces places = places_of(subdivided_points(ranked, density, static_cast<double>(o.points)));
    write_places(o.out, places, static_cast<std::uint32_t>(std::max(density.width, density.height)),
                 fmt::format("poissonlab distribute rank --density {} --points {} --seed {}: {} points in units of the "
                             "longest side of {} x {} pixels, y upwards",
                             printable(o.density), o.points, o.seed, places.size() / 2, density.width, density.height));
}

}

Command distribute_rank_command()
{
    const auto o = std::make_shared<DistributeOptions>();
    o->command = "distribute rank";
    const std::vector<Option> own{points_option(*o, "How many points, about"),
                                  {"--seed", &o->seed, "Which point has rank 0; default: 1", "S"}};
    return {"rank", "Take the points of a self-similar tile whose ranks a density asks for",
            joined({density_options(*o), own, output_options(*o)}), distribute_rank_notes, action_on(o, rank)};
}

}
