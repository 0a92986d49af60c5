// The kernel move_points moves each point bit for bit as the host's allowed_displacement() says.
#include "host/sampling/cells/domain_buffers.hpp"

#include "tests/support/convex_regions.hpp"
#include "tests/support/point_patterns.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace poissonlab {
namespace {

Domain domain_with_regions(int dimension, bool has_fixed, std::size_t points, std::mt19937_64& random)
{
    const double r = 0.06;
    const double a = r * (1 + std::sqrt(2.0));
    const std::vector<std::array<double, 2>> octagon{{a, -r}, {a, r},   {r, a},   {-r, a},
                                                     {-a, r}, {-a, -r}, {-r, -a}, {r, -a}};
    Domain domain;
    domain.forbidden.push_back(polygon_region({0, 0, 0}, octagon));
    domain.forbidden.push_back(box_region({0, 0, 0}, {0.5, r, 0.5}, dimension));
    domain.forbidden.push_back(box_region({0.5, 0.45, 0.6}, {0.1, 0.2, 0.3}, dimension));
    if (dimension == 3) {
        domain.forbidden.push_back(polygon_region({0.9, 0.5, 0.5}, octagon, 0, 0.2));
        domain.forbidden.push_back(polygon_region({0.4, 0.9, 0.1}, octagon, 1));
    }
    for (std::size_t i = 0; has_fixed && i < points; ++i) domain.is_fixed.push_back(random() % 4 == 0);
    return domain;
}

/// Several movements in a row: points come to lie on boundaries.
void expect_same_movements(int dimension, std::size_t points, bool has_regions, bool has_fixed, bool slides)
{
    std::mt19937_64 random(dimension);
    const auto d = static_cast<std::size_t>(dimension);
    Domain domain = domain_with_regions(dimension, has_fixed, points, random);
    if (!has_regions) domain.forbidden.clear();
    PointSet expected = test::random_points(points, dimension, random);

    const Device device = Device::open();
    PointGrid grid(device, dimension, points, 4, 16);
    PointMover mover(device, domain, dimension, 16);
    grid.load(expected);
    for (int pass = 0; pass < 4; ++pass) {
        grid.sort();
        const std::vector<std::uint32_t> ids = grid.ids().read(0, points);
        std::vector<double> displacements(points * d);
        for (std::size_t i = 0; i < points; ++i) {
            Vector position{};
            Vector displacement{};
            for (std::size_t k = 0; k < d; ++k) {
                position[k] = expected[ids[i]][k];
                displacement[k] = displacements[i * d + k] = 0.4 * (test::uniform(random) - 0.5);
            }
            if (has_fixed && domain.is_fixed[ids[i]]) continue;
            const Vector moved = allowed_displacement(domain, position, displacement, slides);
            for (std::size_t k = 0; k < d; ++k) {
                const double sum = position[k] + moved[k];
                const double wrapped = sum - std::floor(sum);
                expected.coordinates[ids[i] * d + k] = wrapped < 1 ? wrapped : 0;
            }
        }
        Buffer<double> buffer = Device(device).buffer<double>(displacements.size());
        buffer.write(displacements);
        mover.move(grid, buffer, slides);
        ASSERT_EQ(grid.points(), expected) << "pass " << pass;
    }
}

class DomainKernel : public ::testing::TestWithParam<int>
{
};

TEST_P(DomainKernel, MovesPointsAsTheHostDoes)
{
    const int dimension = GetParam();
    for (const bool has_regions : {false, true}) {
        for (const bool has_fixed : {false, true}) {
            for (const bool slides : {false, true})
                expect_same_movements(dimension, 5000, has_regions, has_fixed, slides);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Dimensions, DomainKernel, ::testing::Values(2, 3));

TEST(DomainKernelSmall, MovesPointsAsTheHostDoes)
{
    expect_same_movements(2, 40, true, true, true);
    expect_same_movements(3, 40, true, true, true);
}

}
}
