// poissonlab points gaussian-blue-noise: Gaussian blue noise of one set of any size, slab by slab, as a point file.
#include "app/commands/large_sets/relaxed_points.hpp"

namespace poissonlab {
namespace {

constexpr auto points_gaussian_notes =
    R"help(The set is that of the method gaussian-blue-noise with the same seed, its first realization, number for number; sets
that follow a density are the method's alone. The torus is divided into slabs, which processes that mpirun starts share, as
points lloyd does: the help of that says how, and what a start may be.
Large sets get even at all distances sooner from coarse to fine: --levels.
  poissonlab points gaussian-blue-noise --points 10000000 --levels 5 --iterations 100 --out points.npy
  mpirun -n 4 poissonlab points gaussian-blue-noise --points 100000000 --levels 6 --iterations 100 --out points.h5)help";

const RelaxedMethod& gaussian_method()
{
    static const RelaxedMethod method{
        .spec = gaussian_blue_noise_sampler(),
        .left_out = {"density", "density_from"},
        .request =
            [](const Parameters& parameters) {
                return LloydRequest{.iterations = static_cast<std::size_t>(parameters.integer("iterations"))};
            },
        .in_slabs =
            [](const Parameters& parameters, int dimension, std::uint64_t points) {
                return gaussians_in_slabs(gaussian_request(parameters, dimension), dimension, points);
            },
        .coarser_levels = [](const Parameters& parameters) { return parameters.integer("levels"); }};
    return method;
}

void points_gaussian_keys(Keys& keys, AskedRelaxation& asked) { relaxation_keys(keys, asked, gaussian_method()); }

}

Command points_gaussian_blue_noise_command()
{
    static const Kind gaussian =
        described_command("points gaussian-blue-noise", "Make Gaussian blue noise of any size", points_gaussian_keys);
    return relaxation_command(gaussian, points_gaussian_notes,
                              [](const KindOptions& options) { write_relaxed_points(options, gaussian_method()); });
}

}
