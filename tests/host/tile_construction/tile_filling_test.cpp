// Kernels against their plain twin, and both against what is asked of them.
#include "host/tile_construction/filling/tile_filling.hpp"

#include "tiles/poisson/tile_moments.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

PoissonTileParameters parameters(int dimension)
{
    PoissonTileParameters p;
    p.dimension = dimension;
    p.colors = 2;
    p.tiles = dimension == 2 ? 16 : 256;
    p.points_per_tile = dimension == 2 ? 32 : 24;
    p.relative_radius = 0.7;
    p.lloyd_iterations = 6;
    p.repulsion = true;
    return p;
}

/// Some of the stages that there are: nothing held, corners held, an interior among held corners, the inside of a
/// polygon.
struct Case
{
    const char* name;
    int dimension;
    bool is_one_tile;
    int held_corners;
    bool is_interior;
    bool in_polygon = false;
    bool surroundings_move = false;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class TileFilling : public testing::TestWithParam<Case>
{
protected:
    void SetUp() override
    {
        const Case& c = GetParam();
        const PoissonTileParameters p = parameters(c.dimension);
        settings_ = fill_settings(p);
        stage_.regions = regions_of(p);
        stage_.is_one_tile = c.is_one_tile;
        CellSet held = 0;
        for (int base = 0; base < c.held_corners; ++base)
            held |= CellSet{1} << cell_number(0, static_cast<unsigned>(base), c.dimension);
        stage_.active.cells = all_cells(c.dimension) & ~held;
        if (c.is_one_tile) stage_.active.extent = tile_units;
        const CellSet interior = CellSet{1} << cell_number(all_axes(c.dimension), 0, c.dimension);
        if (c.is_interior) {
            stage_.active = {interior, 0, tile_units};
            stage_.surroundings = {all_cells(c.dimension) & ~held & ~interior, 0, torus_units};
            stage_.surroundings_move = c.surroundings_move;
        }
        for (std::uint32_t i = 0; i < 3; ++i) {
            FillProblem problem;
            problem.stream = 100 + i;
            for (int base = 0; base < c.held_corners; ++base) {
                for (std::int32_t offset : {-3000, 0}) {
                    TilePosition position{};
                    for (int k = 0; k < c.dimension; ++k)
                        position[k] = wrapped((base >> k & 1) * tile_units + (k == 0 ? 3 * offset : offset + 11));
                    problem.held.push_back(position);
                }
            }
            const std::uint32_t tiles = c.is_one_tile ? 1 : 1u << c.dimension;
            problem.active = p.points_per_tile * tiles - static_cast<std::uint32_t>(problem.held.size());
            if (c.is_interior) {
                problem.active = p.points_per_tile / 2;
                problem.surroundings = p.points_per_tile * (tiles - 1) - 2;
            }
            if (c.in_polygon) fill_polygon(problem);
            problems_.push_back(problem);
        }
    }

    /// A star around the tile at (0, 0) that reaches beyond it on all sides, across the seam of the torus.
    void fill_polygon(FillProblem& problem)
    {
        stage_.in_polygon = true;
        stage_.active = {0, -tile_units / 2, torus_units};
        problem.held.clear();
        for (int i = 0; i < 16; ++i) {
            const double angle = 2 * std::numbers::pi * i / 16, radius = (i % 2 == 0 ? 0.62 : 0.45) * tile_units;
            problem.held.push_back({wrapped(tile_units / 2 + static_cast<std::int32_t>(radius * std::cos(angle))),
                                    wrapped(tile_units / 2 + static_cast<std::int32_t>(radius * std::sin(angle))), 0});
        }
        problem.active = 14;
    }

    FillSettings settings_;
    FillStage stage_;
    std::vector<FillProblem> problems_;
};

TEST_P(TileFilling, KernelsAndReferenceAgree)
{
    const auto expected = reference::make_tile_filler(settings_)->fill(stage_, problems_, 1);
    for (const std::size_t size : {1, 4, 32}) {
        const auto filled = make_tile_filler(settings_, Device::open(), size)->fill(stage_, problems_, 1);
        for (std::size_t i = 0; i < expected.size(); ++i) {
            SCOPED_TRACE(testing::Message() << "work-group size " << size << ", torus " << i);
            EXPECT_EQ(filled[i].thrown, expected[i].thrown);
            EXPECT_EQ(filled[i].surroundings, expected[i].surroundings);
            EXPECT_EQ(filled[i].active, expected[i].active);
            EXPECT_EQ(filled[i].squared_min_distance, expected[i].squared_min_distance);
            ASSERT_EQ(filled[i].active.size(), problems_[i].active);
        }
    }
}

/// Points that are given are only relaxed and pushed apart.
TEST_P(TileFilling, PointsMayBeGiven)
{
    const auto filler = make_tile_filler(settings_, Device::open());
    const auto first = filler->fill(stage_, problems_, 1);
    for (std::size_t i = 0; i < problems_.size(); ++i) problems_[i].given = first[i].thrown;
    const auto again = filler->fill(stage_, problems_, 2);
    const auto expected = reference::make_tile_filler(settings_)->fill(stage_, problems_, 2);
    for (std::size_t i = 0; i < problems_.size(); ++i) {
        EXPECT_EQ(again[i].thrown, first[i].thrown);
        EXPECT_EQ(again[i], expected[i]);
    }
}

/// The moments of active points of the tile at (0, 0), as they are wanted in problems.
std::vector<std::int64_t> moments_of(const std::vector<TilePosition>& points, std::uint32_t order, int dimension)
{
    std::vector<std::int64_t> sums;
    for (const Monomial& monomial : monomials_up_to(order, dimension)) {
        sums.push_back(0);
        for (const TilePosition& point : points) {
            std::array<std::int64_t, 3> at{};
            for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k)
                at[k] = shortest(point[k] - tile_units / 2);
            sums.back() += value_of(monomial, at);
        }
    }
    return sums;
}

class InsideFilling : public TileFilling
{
};

/// Moments of another filling of the same torus are a distance away that repulsion has to make up for.
TEST_P(InsideFilling, MomentsAreBroughtToWhatIsWanted)
{
    const auto reference = reference::make_tile_filler(settings_);
    const auto first = reference->fill(stage_, problems_, 1), other = reference->fill(stage_, problems_, 2);
    const int dimension = settings_.dimension;
    const std::uint32_t order = dimension == 2 ? 2 : 1;
    stage_.equal_moments = order;
    for (std::size_t i = 0; i < problems_.size(); ++i) {
        problems_[i].given = first[i].active;
        problems_[i].surroundings = 0;
        problems_[i].moments = moments_of(first[i].active, order, dimension);
        const auto others = moments_of(other[i].active, order, dimension);
        for (std::size_t m = 0; m < others.size(); ++m)
            problems_[i].moments[m] += (others[m] - problems_[i].moments[m]) / 4;
    }
    settings_.lloyd_iterations = 0;
    const auto expected = reference::make_tile_filler(settings_)->fill(stage_, problems_, 1);
    std::size_t reached = 0;
    for (const std::size_t size : {1, 4, 32}) {
        const auto filled = make_tile_filler(settings_, Device::open(), size)->fill(stage_, problems_, 1);
        for (std::size_t i = 0; i < expected.size(); ++i) {
            SCOPED_TRACE(testing::Message() << "work-group size " << size << ", torus " << i);
            EXPECT_EQ(filled[i], expected[i]);
            if (filled[i].squared_min_distance < settings_.wanted) continue;
            ++reached;
            const auto found = moments_of(filled[i].active, order, dimension);
            for (std::size_t m = 0; m < found.size(); ++m) {
                const bool is_first = m < static_cast<std::size_t>(dimension);
                const auto points = static_cast<double>(filled[i].active.size());
                // A quarter of a unit each, at most half a tile from the middle; half a unit where there are no others.
                EXPECT_LE(std::abs(static_cast<double>(found[m] - problems_[i].moments[m])),
                          order == 1 ? (points + 2) / 2 : (points + 4) / 4 * (is_first ? 1 : tile_units / 2));
            }
        }
    }
    EXPECT_GT(reached, 0U);
}

INSTANTIATE_TEST_SUITE_P(Insides, InsideFilling,
                         testing::Values(Case{"interior", 2, false, 4, true}, Case{"interior_3d", 3, false, 8, true},
                                         Case{"polygon", 2, false, 0, false, true}),
                         [](const auto& stage) { return std::string(stage.param.name); });

INSTANTIATE_TEST_SUITE_P(Stages, TileFilling,
                         testing::Values(Case{"empty", 2, false, 0, false}, Case{"one_tile", 2, true, 0, false},
                                         Case{"corners", 2, false, 3, false}, Case{"interior", 2, false, 4, true},
                                         Case{"empty_3d", 3, false, 0, false}, Case{"corners_3d", 3, false, 5, false},
                                         Case{"interior_3d", 3, false, 8, true},
                                         Case{"interior_in_moving", 2, false, 4, true, false, true},
                                         Case{"interior_in_moving_3d", 3, false, 8, true, false, true},
                                         Case{"polygon", 2, false, 0, false, true}),
                         [](const auto& stage) { return std::string(stage.param.name); });

}
}
