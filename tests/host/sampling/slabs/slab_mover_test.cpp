// Steps of methods slab by slab: the bytes of a step of the whole torus, for any slabs and any start, and no answer
// where points that are not at hand matter.
#include "host/sampling/slabs/slab_mover.hpp"

#include "host/sampling/lloyd_relaxation.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/point_patterns.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace poissonlab {
namespace {

enum class SlabStep
{
    lloyd,
    gaussians
};

struct SlabCase
{
    const char* name;
    SlabStep step;
    PointSet points;
    std::uint32_t most_slabs = 7;
};

void PrintTo(const SlabCase& c, std::ostream* out) { *out << c.name; }

GaussianRequest one_gaussian_step(double sigma, int dimension)
{
    return {.iterations = 1, .sigma = sigma, .step = usual_gaussian_step(sigma, dimension)};
}

std::unique_ptr<SlabMethod> method_of(const SlabCase& c)
{
    const int d = c.points.dimension;
    return c.step == SlabStep::lloyd ? lloyd_in_slabs(d, c.points.size())
                                     : gaussians_in_slabs(one_gaussian_step(0.8, d), d, c.points.size());
}

PointSet moved_as_a_whole(const SlabCase& c)
{
    const Device device = Device::open();
    if (c.step == SlabStep::lloyd) return LloydRelaxation(device).relax(c.points, Domain{}, {.iterations = 1}).points;
    return GaussianBlueNoise(device).descend(c.points, one_gaussian_step(0.8, c.points.dimension)).points;
}

/// The points of a set that a slab has, and those in layers around it.
std::array<NumberedPoints, 2> points_at(const PointSet& set, const SlabDivision& division, std::uint32_t slab,
                                        std::uint32_t around)
{
    const auto slabs_around = division.slabs_around_layers(around);
    std::array<NumberedPoints, 2> result;
    for (std::size_t i = 0; i < set.size(); ++i) {
        const double last = set[i].back();
        const auto& others = slabs_around[division.layer_of(last)];
        if (division.slab_of(last) == slab) result[0].add(set[i], static_cast<std::uint32_t>(i));
        if (std::ranges::find(others, slab) != others.end()) result[1].add(set[i], static_cast<std::uint32_t>(i));
    }
    return result;
}

/// One step of all slabs, and the layers that each needed. `near` becomes the least squared distance.
PointSet moved_in_slabs(const SlabCase& c, std::uint32_t slabs, std::vector<std::uint32_t>& layers, double& near)
{
    SlabMover mover(Device::open(), c.points.dimension, method_of(c));
    const SlabDivision division(mover.method().cells_per_axis(), c.points.dimension, slabs);
    const auto axes = static_cast<std::size_t>(c.points.dimension);
    PointSet result = c.points;
    for (std::uint32_t slab = 0; slab < slabs; ++slab) {
        std::uint32_t around = mover.method().layers_around();
        const SlabMover::Moved* moved = nullptr;
        for (;; around *= 2) {
            const auto [own, others] = points_at(c.points, division, slab, around);
            if (own.size() == 0) break;
            moved = mover.move(division.part(slab, around), own, others);
            if (moved) break;
        }
        layers.push_back(around);
        if (!moved) continue;
        near = std::min(near, moved->squared_near);
        for (std::size_t i = 0; i < moved->points.size(); ++i)
            std::copy_n(&moved->points.coordinates[i * axes], axes, &result.coordinates[moved->points.ids[i] * axes]);
    }
    return result;
}

class StepsInSlabs : public testing::TestWithParam<SlabCase>
{
};

TEST_P(StepsInSlabs, HaveTheBytesOfTheWholeTorus)
{
    const SlabCase& c = GetParam();
    const PointSet expected = moved_as_a_whole(c);
    const double least = test::brute_force_min_distance(c.points);
    for (const std::uint32_t slabs : {1u, 2u, 3u, 7u}) {
        if (slabs > c.most_slabs) break;
        std::vector<std::uint32_t> layers;
        double near = 1;
        EXPECT_TRUE(moved_in_slabs(c, slabs, layers, near) == expected) << slabs << " slabs";
        EXPECT_NEAR(std::sqrt(near), least, 1e-6 * least + 1e-9) << slabs << " slabs";
    }
}

PointSet random_slab_points(std::size_t n, int dimension)
{
    std::mt19937_64 random(n);
    return test::random_points(n, dimension, random);
}

PointSet clustered_slab_points(std::size_t n, int dimension)
{
    std::mt19937_64 random(n);
    return test::clustered_points(n, dimension, 3, 0.02, random);
}

INSTANTIATE_TEST_SUITE_P(Cases, StepsInSlabs,
                         testing::Values(SlabCase{"lloyd_2d", SlabStep::lloyd, random_slab_points(5000, 2)},
                                         SlabCase{"lloyd_2d_clusters", SlabStep::lloyd, clustered_slab_points(600, 2)},
                                         SlabCase{"lloyd_2d_few", SlabStep::lloyd, random_slab_points(20, 2)},
                                         SlabCase{"lloyd_3d", SlabStep::lloyd, random_slab_points(3000, 3)},
                                         SlabCase{"lloyd_3d_clusters", SlabStep::lloyd, clustered_slab_points(150, 3)},
                                         SlabCase{"gaussians_2d", SlabStep::gaussians, random_slab_points(5000, 2)},
                                         SlabCase{"gaussians_2d_clusters", SlabStep::gaussians,
                                                  clustered_slab_points(600, 2)},
                                         SlabCase{"gaussians_3d", SlabStep::gaussians, random_slab_points(3000, 3)}),
                         [](const auto& c) { return std::string(c.param.name); });

/// Under Oclgrind, which interprets kernels.
INSTANTIATE_TEST_SUITE_P(Small, StepsInSlabs,
                         testing::Values(SlabCase{"lloyd_2d", SlabStep::lloyd, random_slab_points(120, 2), 2},
                                         SlabCase{"lloyd_2d_clusters", SlabStep::lloyd, clustered_slab_points(20, 2),
                                                  2},
                                         SlabCase{"lloyd_3d", SlabStep::lloyd, random_slab_points(30, 3), 2},
                                         SlabCase{"gaussians_2d", SlabStep::gaussians, random_slab_points(300, 2), 2}),
                         [](const auto& c) { return std::string(c.param.name); });

/// Points in a narrow band leave cells that reach around the torus: two layers are not enough.
TEST(StepsInSlabs, AskForMoreLayersWherePointsFarAwayMatter)
{
    const SlabCase c{"", SlabStep::lloyd, clustered_slab_points(600, 2)};
    std::vector<std::uint32_t> layers;
    double near = 1;
    moved_in_slabs(c, 7, layers, near);
    EXPECT_GT(*std::ranges::max_element(layers), 2u);
}

}
}
