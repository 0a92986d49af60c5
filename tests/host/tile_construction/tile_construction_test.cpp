// Whole tile sets: what was asked for, proven and, on random tilings, seen by CGAL; the same from kernels and
// from their plain twin.
#include "host/tile_construction/tile_construction.hpp"

#include "base/errors/errors.hpp"
#include "tests/support/cgal_distance.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/small_tile_sets.hpp"
#include "tests/tiles/poisson/made_up_tilings.hpp"
#include "tiles/poisson/proof/tile_certificate.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <set>

namespace poissonlab {
namespace {

using testing::AllOf;
using testing::HasSubstr;

PoissonTileSet built(const PoissonTileParameters& parameters, std::size_t work_group_size = 0)
{
    const auto filler = make_tile_filler(fill_settings(parameters), Device::open(), work_group_size);
    return construct_tile_set(parameters, *filler).set;
}

PoissonTileSet built_by_reference(const PoissonTileParameters& parameters)
{
    const auto filler = reference::make_tile_filler(fill_settings(parameters));
    return construct_tile_set(parameters, *filler).set;
}

class TileConstruction : public testing::TestWithParam<SmallSet>
{
protected:
    const PoissonTileParameters& p_ = GetParam().parameters;
};

TEST_P(TileConstruction, EveryTilingKeepsTheDistance)
{
    const PoissonTileSet set = built(p_);
    ASSERT_EQ(set.points.size(), std::size_t{p_.tiles} * p_.points_per_tile * static_cast<unsigned>(p_.dimension));
    const TileCertificate proof = certify(set);
    EXPECT_GE(proof.squared_min_distance, asked_squared_distance(p_));

    if (p_.dimension == 3) return;
    const MadeUpTiling tiling(p_, 100, 5);
    std::vector<TestPosition> points;
    for (int j = 0; j < 100; ++j) {
        for (int i = 0; i < 100; ++i) tiling.append(set, i, j, 0, points);
    }
    EXPECT_GE(squared_distance_by_cgal(points), static_cast<double>(proof.squared_min_distance));
}

TEST_P(TileConstruction, AnyWorkGroupSizeAndNumberOfThreadsMakeTheSameTiles)
{
    const PoissonTileSet expected = built(p_, 1);
    EXPECT_EQ(built(p_, 7), expected);
    EXPECT_EQ(built(p_, 64), expected);
    const auto one_thread = make_tile_filler(fill_settings(p_), Device::open({}, 1));
    EXPECT_EQ(construct_tile_set(p_, *one_thread).set, expected) << "on one thread";
}

constexpr auto corner = PoissonTileKind::corner;
constexpr auto edge = PoissonTileKind::edge;
constexpr auto frame = PoissonTileKind::frame;

PoissonTileParameters by_darts()
{
    PoissonTileParameters p = tile_set_parameters(corner, 2, 2, 32, 0.65);
    set_dart_throwing(p);
    p.lloyd_iterations = 0;
    return p;
}

INSTANTIATE_TEST_SUITE_P(
    Sets, TileConstruction,
    testing::Values(SmallSet{"corner", tile_set_parameters(corner, 2, 3, 32, 0.75)},
                    SmallSet{"corner_085", with_repulsion(tile_set_parameters(corner, 2, 2, 64, 0.85))},
                    SmallSet{"corner_few", tile_set_parameters(corner, 2, 2, 4, 0.5)},
                    SmallSet{"corner_one_color", tile_set_parameters(corner, 2, 1, 100, 0.75)},
                    SmallSet{"corner_darts", by_darts()},
                    SmallSet{"edge", with_repulsion(tile_set_parameters(edge, 2, 1, 48, 0.85))},
                    SmallSet{"edge_two", with_lloyd(tile_set_parameters(edge, 2, 2, 8, 0.6), 2)},
                    SmallSet{"template", with_repulsion(tile_set_parameters(frame, 2, 12, 32, 0.85))},
                    SmallSet{"template_one", tile_set_parameters(frame, 2, 1, 16, 0.75)},
                    SmallSet{"template_few", tile_set_parameters(frame, 2, 7, 4, 0.75)},
                    SmallSet{"sphere", with_repulsion(with_lloyd(tile_set_parameters(corner, 3, 2, 32, 0.55), 2))}),
    [](const auto& set) { return std::string(set.param.name); });

class TileConstructionTwins : public TileConstruction
{
};

TEST_P(TileConstructionTwins, KernelsAndReferenceMakeTheSameTiles) { EXPECT_EQ(built(p_), built_by_reference(p_)); }

INSTANTIATE_TEST_SUITE_P(
    Sets, TileConstructionTwins,
    testing::Values(SmallSet{"corner", with_repulsion(with_lloyd(tile_set_parameters(corner, 2, 2, 16, 0.8), 4))},
                    SmallSet{"edge", with_lloyd(tile_set_parameters(edge, 2, 1, 16, 0.6), 3)},
                    SmallSet{"template", with_repulsion(with_lloyd(tile_set_parameters(frame, 2, 4, 24, 0.85), 4))},
                    SmallSet{"darts", by_darts()},
                    SmallSet{"sphere", with_repulsion(with_lloyd(tile_set_parameters(corner, 3, 1, 32, 0.55), 1))}),
    [](const auto& set) { return std::string(set.param.name); });

TEST(TileConstructionSeeds, MakeOtherTiles)
{
    PoissonTileParameters p = tile_set_parameters(corner, 2, 2, 16, 0.7);
    const PoissonTileSet one = built(p);
    p.seed = 2;
    EXPECT_NE(built(p).points, one.points);
}

TEST(TileConstructionErrors, NameThePieceAndWhatItReached)
{
    PoissonTileParameters p = with_lloyd(tile_set_parameters(corner, 2, 2, 32, 0.85), 1);
    EXPECT_THAT(message_of([&] { built(p); }),
                AllOf(HasSubstr("a relative radius of 0.85"), HasSubstr("one of the corners"), HasSubstr("reached 0."),
                      HasSubstr("repulsion")));
    p = with_lloyd(tile_set_parameters(frame, 2, 3, 32, 0.9), 1);
    EXPECT_THROW(built(p), InputError);
}

/// Lets one tile fail so many times.
class StubbornFiller final : public TileFiller
{
public:
    StubbornFiller(const PoissonTileParameters& parameters, std::uint32_t tile, int failures)
        : filler_(make_tile_filler(fill_settings(parameters), Device::open())), tile_(tile), failures_(failures)
    {}

    std::vector<FilledTorus> fill(const FillStage& stage, std::span<const FillProblem> problems,
                                  std::uint32_t attempt) override
    {
        std::vector<FilledTorus> filled = filler_->fill(stage, problems, attempt);
        const bool is_of_tiles = stage.active.extent < tile_units;
        for (std::size_t i = 0; i < problems.size() && is_of_tiles; ++i) {
            if (problems[i].stream == tile_ && failures_-- > 0) filled[i].squared_min_distance = 5000 * 5000;
        }
        return filled;
    }

private:
    std::unique_ptr<TileFiller> filler_;
    std::uint32_t tile_;
    int failures_;
};

TEST(TileConstructionErrors, NameTheTileAndWhatItReached)
{
    const PoissonTileParameters p = tile_set_parameters(corner, 2, 2, 16, 0.7);
    StubbornFiller filler(p, 5, 1'000'000);
    const std::string reached = std::to_string(relative_radius_of(5000 * 5000, p)).substr(0, 4);
    EXPECT_THAT(message_of([&] { construct_tile_set(p, filler); }),
                AllOf(HasSubstr("tile 5 "), HasSubstr("reached " + reached)));
}

TEST(TileConstructionErrors, TilesThatCannotBeFilledGetNewPieces)
{
    for (const PoissonTileParameters& p :
         {tile_set_parameters(corner, 2, 2, 16, 0.7), tile_set_parameters(edge, 2, 1, 16, 0.6),
          tile_set_parameters(frame, 2, 8, 16, 0.7)}) {
        StubbornFiller filler(p, p.tiles > 5 ? 5 : 0, 20); // two rounds of eight, and a few more
        const ConstructedTileSet built_set = construct_tile_set(p, filler);
        EXPECT_EQ(built_set.report.remade, 2u) << kind_name(p);
        EXPECT_GE(certify(built_set.set).squared_min_distance, asked_squared_distance(p));
    }
}

TEST(TileConstructionErrors, RefuseWhatDoesNotFitIntoTiles)
{
    EXPECT_THROW(built(tile_set_parameters(corner, 2, 2, 4, 0.75)), InputError); // corners meet
    EXPECT_THROW(built(tile_set_parameters(corner, 3, 2, 16, 0.75)), InputError);
    EXPECT_THROW(built(tile_set_parameters(corner, 2, 300, 16, 0.75)), InputError); // more than 2^32 tiles
    EXPECT_THROW(built(tile_set_parameters(corner, 2, 2, 3, 0.3)), InputError);
}

TEST(TileConstructionRecords, TellOfEveryPieceAndTile)
{
    const PoissonTileParameters p = tile_set_parameters(corner, 2, 2, 16, 0.7);
    const auto filler = make_tile_filler(fill_settings(p), Device::open());
    std::map<int, std::set<std::uint32_t>> told;
    ConstructionOptions options;
    options.record = [&](const ConstructionRecord& record) {
        told[record.axes].insert(record.variant);
        EXPECT_EQ(record.filled->active.size(), record.problem->active);
        EXPECT_EQ(record.filled->thrown.size(), record.problem->active);
    };
    construct_tile_set(p, *filler, options);
    EXPECT_EQ(told[0].size(), 2u);
    EXPECT_EQ(told[1].size(), 4u);
    EXPECT_EQ(told[2].size(), 4u);
    EXPECT_EQ(told[3].size(), 16u);
}

}
}
