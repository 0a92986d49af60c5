// The sequence on a dodecagonal tiling: its vertices are those of the shield tiling, which is made by another rule and
// has been tested by its angles and areas; its polygons share them out; each prefix is well spread.
#include "host/distribution/discrepancy.hpp"
#include "host/settings/sampler_registry.hpp"
#include "host/settings/tilings/polygon_tiling_file.hpp"
#include "tests/support/errors.hpp"
#include "tiles/dodecagonal/dodecagonal_sequence.hpp"
#include "tiles/prototiles/substitution.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <set>

namespace poissonlab {
namespace {

using Complex = std::complex<double>;

/// The place where z is exp(2 pi i power / 12).
Complex value_of(const RingPlace& place, int power)
{
    Complex sum;
    for (std::size_t k = 0; k < 4; ++k)
        sum += static_cast<double>(place.c[k]) * std::polar(1.0, std::numbers::pi / 6 * power * static_cast<double>(k));
    return sum;
}

/// The size of the dodecagon around 0 that has a place's conjugate on its border; 1 is that with corners at the roots.
double dodecagon_size(const RingPlace& place)
{
    double size = 0;
    for (int k = 0; k < 12; ++k)
        size = std::max(size, (value_of(place, 5) * std::polar(1.0, std::numbers::pi / 12 * (2 * k + 1))).real());
    return size / std::cos(std::numbers::pi / 12);
}

/// All numbers of the ring in a disk around one of them, or around the origin, whose conjugate has at most this size.
std::set<RingPlace> numbers_in_disk(const RingPlace& middle, double radius, double size)
{
    const Complex in_plane = value_of(middle, 1), other = value_of(middle, 5);
    std::set<RingPlace> found;
    // b sqrt(3) and c sqrt(3) are differences of parts of the place and of its conjugate; a and d follow within 1.
    const auto most = static_cast<std::int64_t>((radius + size + std::abs(other)) / std::numbers::sqrt3 + 2);
    for (std::int64_t b = -most; b <= most; ++b)
        for (std::int64_t c = -most; c <= most; ++c) {
            const double root = std::numbers::sqrt3 / 2;
            const double a = -other.real() + static_cast<double>(b) * root - static_cast<double>(c) / 2;
            const double d = -other.imag() + static_cast<double>(c) * root - static_cast<double>(b) / 2;
            for (auto i = static_cast<std::int64_t>(std::ceil(a - size)); static_cast<double>(i) <= a + size; ++i)
                for (auto j = static_cast<std::int64_t>(std::ceil(d - size)); static_cast<double>(j) <= d + size; ++j) {
                    const RingPlace place = middle + RingPlace{{i, b, c, j}};
                    if (std::abs(value_of(place, 1) - in_plane) <= radius && dodecagon_size(place) <= size)
                        found.insert(place);
                }
        }
    return found;
}

/// A place whose conjugate is generic.
RingPlace some_place(std::uint32_t seed)
{
    std::mt19937 random(seed);
    const auto number = [&] { return static_cast<std::int64_t>(random() % 20'001) - 10'000; };
    const std::int64_t b = number();
    return place_with_vertices(b, number());
}

std::vector<DodecagonalVertex> vertices_in_disk(const RingPlace& middle, double radius)
{
    std::vector<DodecagonalVertex> vertices;
    for (const RingPlace& place : numbers_in_disk(middle, radius, 1)) vertices.push_back({place});
    return vertices;
}

DodecagonalSequence some_sequence(std::uint32_t seed,
                                  std::span<const DodecagonalTurns> turns = best_dodecagonal_turns())
{
    std::mt19937 random(seed);
    const auto part = [&] { return static_cast<double>(random()) * 0x1p-32; };
    return DodecagonalSequence({some_place(seed), {part(), part()}}, turns);
}

std::vector<std::array<double, 2>> places_of(const std::vector<DodecagonalPoint>& points)
{
    std::vector<std::array<double, 2>> places;
    for (const DodecagonalPoint& point : points) places.push_back(point.place);
    return places;
}

PointSet set_of(const std::vector<DodecagonalPoint>& points)
{
    PointSet set;
    for (const DodecagonalPoint& point : points)
        set.coordinates.insert(set.coordinates.end(), point.place.begin(), point.place.end());
    return set;
}

TEST(DodecagonalTiling, HasTheVerticesOfTheShieldTiling)
{
    // The first tile is no part of the tiling around the origin but of a shifted one. Each division shrinks the shift's
    // conjugate, which is at most 2 at first, by 2 cos 75 degrees.
    constexpr int depth = 6;
    constexpr double radius = 30;
    const double off = 2 * std::pow(2 * std::cos(5 * std::numbers::pi / 12), depth) / std::cos(std::numbers::pi / 12);
    const PolygonTiling& tiling = built_in_tiling("shield");
    std::set<RingPlace> vertices;
    Complex mean;
    for (const AddressedTile& tile : Substitution(tiling, 3).tiles(depth, 100'000))
        for (const RingPlace& corner : corners_of(tiling, tile.tile))
            if (vertices.insert(corner).second) mean += value_of(corner, 1);
    mean /= static_cast<double>(vertices.size());
    for (const RingPlace& vertex : vertices) ASSERT_LT(dodecagon_size(vertex), 1 + off);
    const RingPlace middle =
        *std::ranges::min_element(vertices, {}, [&](const RingPlace& v) { return std::abs(value_of(v, 1) - mean); });
    const std::set<RingPlace> inner = numbers_in_disk(middle, radius, 1 - off);
    EXPECT_GT(inner.size(), 2400U); // of pi 30^2 vertices
    for (const RingPlace& place : inner) ASSERT_TRUE(vertices.contains(place));
}

TEST(DodecagonalTiling, VerticesAreNumbersWhoseConjugateIsInTheDodecagon)
{
    std::mt19937 random(1);
    int inside = 0;
    for (int i = 0; i < 20'000; ++i) {
        const std::int64_t b = static_cast<std::int64_t>(random() % 200'001) - 100'000;
        RingPlace place = place_with_vertices(b, static_cast<std::int64_t>(random() % 200'001) - 100'000);
        place.c[0] += static_cast<std::int64_t>(random() % 3) - 1;
        const double size = dodecagon_size(place);
        if (std::abs(size - 1) < 1e-8) continue;
        ASSERT_EQ(is_dodecagonal_vertex(place), size < 1) << size;
        inside += size < 1 ? 1 : 0;
    }
    EXPECT_GT(inside, 5000);
}

TEST(DodecagonalTiling, HasOneOfTwoOppositeBorders)
{
    // The conjugate of z^5 is z, so that of 1 + (z^5 - 1) (-sqrt(3) - 1) lies on the edge from 1 to z.
    const RootRing ring;
    const RingPlace sqrt3 = ring.unit(1) + ring.unit(-1); // its conjugate is -sqrt(3)
    const RingPlace part = -sqrt3 - RingPlace{{1, 0, 0, 0}};
    const RingPlace on_edge = ring.unit(0) + ring.times(ring.unit(5) - ring.unit(0), part);
    int borders = 0;
    for (int k = 0; k < 12; ++k) {
        const RingPlace place = ring.times(ring.unit(k), on_edge);
        ASSERT_NEAR(dodecagon_size(place), 1, 1e-12);
        EXPECT_NE(is_dodecagonal_vertex(place), is_dodecagonal_vertex(-place));
        borders += is_dodecagonal_vertex(place) ? 1 : 0;
    }
    EXPECT_EQ(borders, 6);
}

TEST(DodecagonalTiling, IsDividedWithoutGapsAndOverlaps)
{
    constexpr double radius = 25;
    for (const std::uint32_t seed : {1U, 2U, 3U}) {
        const RingPlace middle = some_place(seed);
        const std::vector<DodecagonalVertex> vertices = vertices_in_disk(middle, radius);
        // One vertex a unit area: the area of the dodecagon over that of the lattice's cell, 3 / 3.
        EXPECT_NEAR(static_cast<double>(vertices.size()), std::numbers::pi * radius * radius,
                    2 * std::numbers::pi * radius);
        std::set<RingPlace> parts;
        std::size_t largest = 0;
        for (const DodecagonalVertex& vertex : vertices) {
            const std::vector<DodecagonalVertex> own = divided_vertex(vertex);
            EXPECT_EQ(own.front().place, enlarged_place(vertex.place));
            EXPECT_EQ(reduced_place(own.front().place), vertex.place);
            largest = std::max(largest, own.size());
            for (const DodecagonalVertex& part : own) {
                EXPECT_NEAR(std::abs(value_of(part.place - own.front().place, 1)),
                            part.place == own.front().place ? 0 : 1, 1e-9);
                EXPECT_TRUE(is_dodecagonal_vertex(part.place));
                EXPECT_TRUE(parts.insert(part.place).second) << "two polygons have one vertex";
            }
        }
        EXPECT_LE(largest, 5U);
        const double factor = 2 * std::cos(std::numbers::pi / 12);
        const std::set<RingPlace> wanted = numbers_in_disk(enlarged_place(middle), factor * radius - 1, 1);
        for (const RingPlace& place : wanted) ASSERT_TRUE(parts.contains(place));
        // In the limit, parts are 2 + sqrt(3) times as many; those at the border are parts of polygons outside.
        EXPECT_NEAR(static_cast<double>(parts.size()) / static_cast<double>(vertices.size()), 2 + std::numbers::sqrt3,
                    4 / radius);
    }
}

TEST(DodecagonalTiling, HasVerticesAtLeastAnEdgeApart)
{
    const std::vector<DodecagonalVertex> vertices = vertices_in_disk(some_place(4), 15);
    double least = 10;
    for (std::size_t i = 0; i < vertices.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            least = std::min(least, std::abs(value_of(vertices[i].place - vertices[j].place, 1)));
    EXPECT_NEAR(least, 1, 1e-9);
}

TEST(DodecagonalTurns, ArePermutations)
{
    for (const DodecagonalTurns& turns : best_dodecagonal_turns()) {
        const auto count = static_cast<std::size_t>(std::popcount(turns.directions));
        ASSERT_LE(count, turns.turns.size());
        std::set<std::uint8_t> all(turns.turns.begin(), turns.turns.begin() + static_cast<std::ptrdiff_t>(count));
        EXPECT_EQ(all.size(), count);
        EXPECT_EQ(*all.rbegin() + 1U, count);
    }
}

TEST(DodecagonalSequences, HavePrefixes)
{
    const DodecagonalSequence sequence = some_sequence(1);
    const auto all = places_of(sequence.points(5000));
    EXPECT_EQ(std::set(all.begin(), all.end()).size(), all.size());
    for (const std::size_t count : {0, 1, 2, 3, 10, 99, 1000, 4999}) {
        const auto some = places_of(sequence.points(count));
        ASSERT_EQ(some.size(), count);
        EXPECT_TRUE(std::ranges::equal(some, std::span(all).first(count)));
    }
    for (const auto& place : all)
        for (const double x : place) EXPECT_TRUE(x >= 0 && x < 1);
}

TEST(DodecagonalSequences, HaveRanksThatCountPoints)
{
    // Points of squares vary in number as those of a border do that is some points wide.
    for (const std::size_t count : {100, 1000, 10'000}) {
        double sum = 0;
        const double border = 4 * std::sqrt(static_cast<double>(count));
        for (std::uint32_t seed = 0; seed < 16; ++seed) {
            const double rank = some_sequence(seed).points(count).back().rank;
            EXPECT_NEAR(rank, static_cast<double>(count), border);
            sum += rank / 16;
        }
        EXPECT_NEAR(sum, static_cast<double>(count), border / 4);
    }
}

/// The vertices in the square, by rank: all of the tiling of a level come before others.
TEST(DodecagonalSequences, HaveAllVerticesOfATilingBeforeThoseOfTheNext)
{
    const auto points = some_sequence(7).points(3000);
    for (double density = 1 / std::pow(2 + std::numbers::sqrt3, 2); density < 3000;
         density *= 2 + std::numbers::sqrt3) {
        const auto count = static_cast<std::size_t>(
            std::ranges::count_if(points, [&](const DodecagonalPoint& point) { return point.rank <= density; }));
        double least = 10;
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t j = 0; j < i; ++j)
                least = std::min(least, std::hypot(points[i].place[0] - points[j].place[0],
                                                   points[i].place[1] - points[j].place[1]));
        if (count < 200) continue;
        EXPECT_NEAR(least * std::sqrt(density), 1, 1e-6) << density; // edges of length 1
    }
}

TEST(DodecagonalSequences, FollowADensity)
{
    const auto half = full_weight / 2;
    const DensityBounds density({2, 2, {0, half / 2, half, full_weight}});
    const DodecagonalSequence sequence = some_sequence(5);
    const auto points = sequence.points(2000, density);
    std::array<int, 4> counts{};
    for (const DodecagonalPoint& point : points)
        ++counts[(point.place[0] >= 0.5 ? 1U : 0U) + (point.place[1] >= 0.5 ? 2U : 0U)];
    EXPECT_EQ(counts[0], 0);
    EXPECT_NEAR(counts[1], 2000.0 / 7, 60);
    EXPECT_NEAR(counts[2], 4000.0 / 7, 80);
    // The even sequence, filtered by its ranks, has the same points.
    std::vector<DodecagonalPoint> even = sequence.points(6000);
    const double parts[] = {0, 0.25, 0.5, 1};
    std::erase_if(even, [](const DodecagonalPoint& point) { return point.place[0] < 0.5 && point.place[1] < 0.5; });
    for (DodecagonalPoint& point : even)
        point.rank /= parts[(point.place[0] >= 0.5 ? 1U : 0U) + (point.place[1] >= 0.5 ? 2U : 0U)];
    std::ranges::stable_sort(even, {}, &DodecagonalPoint::rank);
    even.resize(points.size());
    EXPECT_EQ(places_of(points), places_of(even));
    const auto places = places_of(points);
    for (const std::size_t count : {0, 1, 2, 3, 500})
        EXPECT_TRUE(std::ranges::equal(places_of(sequence.points(count, density)), std::span(places).first(count)));
}

TEST(DodecagonalSequences, RefuseDensitiesThatAreTooPeaked)
{
    std::vector<std::uint64_t> weights(1 << 16, 0);
    weights.front() = full_weight;
    const DensityBounds density({256, 256, weights});
    EXPECT_NO_THROW(check_dodecagonal_density(std::size_t{1} << 24, density));
    EXPECT_THROW(check_dodecagonal_density((std::size_t{1} << 24) + 1, density), InputError);
}

TEST(DodecagonalSequences, HaveALowDiscrepancyThatTurnsMakeLower)
{
    std::vector<std::size_t> counts;
    for (std::size_t count = 60; count <= 1100; count += count / 5) counts.push_back(count);
    const auto mean = [&](std::span<const DodecagonalTurns> turns) {
        double sum = 0;
        for (std::uint32_t seed = 1000; seed < 1048; ++seed) {
            const std::vector<double> found =
                l2_star_discrepancies(set_of(some_sequence(seed, turns).points(1100)), counts);
            for (std::size_t i = 0; i < counts.size(); ++i)
                sum += found[i] * found[i] * std::pow(static_cast<double>(counts[i]), 1.5);
        }
        return sum / 48 / static_cast<double>(counts.size());
    };
    const double best = mean(best_dodecagonal_turns()), by_direction = mean({});
    EXPECT_LT(best, by_direction);
    // A random set has a mean square of 5 / (36 N).
    EXPECT_LT(best, 5.0 / 36 * std::sqrt(60.0) / 4);
}

TEST(DodecagonalSamplers, MakeASetForEachRealizationAndSeed)
{
    const SamplerSpec& spec = *find_sampler("dodecagonal");
    const auto sample = [&](std::uint64_t seed, std::uint32_t realization, std::size_t points) {
        return spec.create(Parameters(spec.parameters), {.points = points, .seed = seed}, Engine::reference, {})
            ->sample(realization)
            .coordinates;
    };
    EXPECT_EQ(sample(1, 0, 100), sample(1, 0, 100));
    EXPECT_NE(sample(1, 0, 100), sample(1, 1, 100));
    EXPECT_NE(sample(1, 0, 100), sample(2, 0, 100));
    for (const std::size_t points : {1, 2, 3}) EXPECT_EQ(sample(1, 5, points).size(), 2 * points);
}

}
}
