// Smoothing in the gradient domain against a direct solver, and what harmonic functions must be.
#include "host/texture/gradient_domain.hpp"

#include "host/device/device.hpp"
#include "tests/host/texture/random_picture.hpp"

#include <Eigen/SparseCholesky>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace poissonlab {
namespace {

constexpr int size = 24;

/// A disk with a rough rim.
FittedPiece rough_disk(unsigned seed, ExemplarWindow window)
{
    FittedPiece piece{window, {}};
    std::mt19937 random(seed);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const double distance = std::hypot(x + 0.5 - size / 2.0, y + 0.5 - size / 2.0);
            piece.cut.taken.push_back(distance < 6 + static_cast<int>(random() % 5));
        }
    return piece;
}

/// Two tiles with a rough disk each out of other pictures.
struct Problem
{
    explicit Problem(int channels)
        : exemplar(test::random_picture(80, 70, channels, 1)), tiles{test::random_picture(size, size, channels, 2),
                                                                     test::random_picture(size, size, channels, 3)},
          pieces{rough_disk(4, {10, 20, size}), rough_disk(5, {40, 3, size})},
          domain(gradient_domain(exemplar, tiles, pieces))
    {}

    PngPixels exemplar;
    std::vector<PngPixels> tiles;
    std::vector<FittedPiece> pieces;
    GradientDomain domain;
};

/// The harmonic function of a channel of a tile by Cholesky's method.
std::vector<double> direct_solution(const GradientDomain& domain, std::size_t tile, std::size_t channel)
{
    const auto pixels = static_cast<std::size_t>(size * size);
    const std::uint8_t* const inside = &domain.inside[tile * pixels];
    const double* const known = &domain.values[(tile * static_cast<std::size_t>(domain.channels) + channel) * pixels];
    std::vector<int> unknown(pixels, -1);
    int count = 0;
    for (std::size_t i = 0; i < pixels; ++i)
        if (inside[i]) unknown[i] = count++;
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd right = Eigen::VectorXd::Zero(count);
    for (int i = 0; i < size * size; ++i) {
        if (!inside[i]) continue;
        entries.emplace_back(unknown[static_cast<std::size_t>(i)], unknown[static_cast<std::size_t>(i)], 4);
        for (const int other : {i - 1, i + 1, i - size, i + size}) {
            if (inside[other])
                entries.emplace_back(unknown[static_cast<std::size_t>(i)], unknown[static_cast<std::size_t>(other)],
                                     -1);
            else
                right[unknown[static_cast<std::size_t>(i)]] += known[other];
        }
    }
    Eigen::SparseMatrix<double> matrix(count, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::VectorXd solution = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(right);
    std::vector<double> values(known, known + pixels);
    for (std::size_t i = 0; i < pixels; ++i)
        if (inside[i]) values[i] = solution[unknown[i]];
    return values;
}

TEST(GradientDomain, IsWhatADirectSolverSays)
{
    for (const int channels : {1, 3}) {
        Problem problem(channels);
        const GradientDomain before = problem.domain;
        relax_reference(problem.domain);
        for (std::size_t tile = 0; tile < 2; ++tile)
            for (std::size_t c = 0; c < static_cast<std::size_t>(channels); ++c) {
                const std::vector<double> expected = direct_solution(before, tile, c);
                const double* const values =
                    &problem.domain.values[(tile * static_cast<std::size_t>(channels) + c) * size * size];
                for (std::size_t i = 0; i < expected.size(); ++i) ASSERT_NEAR(values[i], expected[i], 1e-9);
            }
    }
}

TEST(GradientDomain, HasTheSameBitsOnADevice)
{
    Problem problem(3);
    GradientDomain expected = problem.domain;
    relax_reference(expected);
    Device device = Device::open();
    for (const std::size_t group : {1u, 7u, 64u}) {
        GradientDomain domain = problem.domain;
        relax_on(device, domain, group);
        EXPECT_EQ(domain.values, expected.values) << group;
    }
}

/// No value inside is beyond those around it: the maximum principle.
TEST(GradientDomain, StaysBetweenWhatIsAround)
{
    Problem problem(1);
    relax_reference(problem.domain);
    for (std::size_t tile = 0; tile < 2; ++tile) {
        double lowest = 0, highest = 0, lowest_inside = 0, highest_inside = 0;
        for (std::size_t i = tile * size * size; i < (tile + 1) * size * size; ++i) {
            const double value = problem.domain.values[i];
            const bool is_inside = problem.domain.inside[i];
            (is_inside ? lowest_inside : lowest) = std::min(is_inside ? lowest_inside : lowest, value);
            (is_inside ? highest_inside : highest) = std::max(is_inside ? highest_inside : highest, value);
        }
        EXPECT_GE(lowest_inside, lowest);
        EXPECT_LE(highest_inside, highest);
    }
}

/// A piece that is the surroundings but for a constant becomes the surroundings; the very same piece is left alone.
TEST(GradientDomain, UndoesAConstant)
{
    for (const int constant : {0, 40}) {
        const PngPixels exemplar = test::random_picture(60, 60, 3, 8, 200);
        PngPixels tile = window_pixels(exemplar, {12, 9, size});
        for (std::uint8_t& value : tile.values) value = static_cast<std::uint8_t>(value + constant);
        const PngPixels expected = tile;
        const std::vector<FittedPiece> pieces{rough_disk(6, {12, 9, size})};
        std::vector<PngPixels> tiles{tile};
        for (std::size_t i = 0; i < pieces[0].cut.taken.size(); ++i)
            if (pieces[0].cut.taken[i])
                for (std::size_t c = 0; c < 3; ++c)
                    tiles[0].values[3 * i + c] = static_cast<std::uint8_t>(tiles[0].values[3 * i + c] - constant);
        GradientDomain domain = gradient_domain(exemplar, tiles, pieces);
        relax_reference(domain);
        add_to_tiles(domain, tiles);
        EXPECT_EQ(tiles[0].values, expected.values);
    }
}

}
}
