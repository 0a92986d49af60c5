// poissonlab points lloyd: Lloyd relaxation of one set of any size, slab by slab, as a point file.
#include "app/commands/large_sets/relaxed_points.hpp"

namespace poissonlab {
namespace {

constexpr auto points_lloyd_notes =
    R"help(The set is that of the method lloyd with the same seed, its first realization, number for number. The torus is divided
into slabs, and processes that mpirun starts hold some each: their memory falls with their number. Before each iteration
they send each other what is around their slabs; the file has the same bytes for any number of processes and slabs.
One process alone has the points in its memory, and on the device a slab at a time.
Random points to begin with are made by all processes; any other start by the first one, in its memory. A start from a file
(points dart-throwing makes large ones): --start '{ sampler = "file", path = "darts.npy" }', without --points.
With --engine reference the first process makes the whole set by the plain program.
The format follows the extension: .npy, .h5, .csv, .usda, .ply or text; in 3D .hdf5 and .h5part, too.
  poissonlab points lloyd --points 10000000 --iterations 20 --out points.npy
  mpirun -n 4 poissonlab points lloyd --points 1000000000 --iterations 100 --until-relative-radius 0.7 --out points.h5)help";

const RelaxedMethod& lloyd_method()
{
    static const RelaxedMethod method{
        .spec = lloyd_sampler(),
        .left_out = {"repulsion"},
        .request = lloyd_request,
        .in_slabs = [](const Parameters& /*parameters*/, int dimension,
                       std::uint64_t points) { return lloyd_in_slabs(dimension, points); },
        .coarser_levels = [](const Parameters& /*parameters*/) { return std::int64_t{0}; }};
    return method;
}

void points_lloyd_keys(Keys& keys, AskedRelaxation& asked) { relaxation_keys(keys, asked, lloyd_method()); }

}

Command points_lloyd_command()
{
    static const Kind lloyd =
        described_command("points lloyd", "Relax one set of any size by Lloyd's method", points_lloyd_keys);
    return relaxation_command(lloyd, points_lloyd_notes,
                              [](const KindOptions& options) { write_relaxed_points(options, lloyd_method()); });
}

}
