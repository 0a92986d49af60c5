// The types of isohedral tilings: how many there are, what is printed of them, and which shapes can tell.
#include "tiles/isohedral/isohedral_types.hpp"

#include "tests/support/errors.hpp"
#include "tiles/isohedral/isohedral_tile.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace poissonlab {
namespace {

using testing::ElementsAre;

const IsohedralType& ih(int number) { return isohedral_types().at(static_cast<std::size_t>(number - 1)); }

TEST(IsohedralTypes, Are93InTheSplitOfGruenbaumAndShephard)
{
    std::map<std::string, int> counts;
    for (const IsohedralType& type : isohedral_types()) ++counts[type.topology];
    EXPECT_EQ(counts, (std::map<std::string, int>{{"3^6", 20},
                                                  {"3^4.6", 1},
                                                  {"3^3.4^2", 5},
                                                  {"3^2.4.3.4", 3},
                                                  {"3.4.6.4", 3},
                                                  {"3.6.3.6", 5},
                                                  {"3.12^2", 3},
                                                  {"4^4", 36},
                                                  {"4.6.12", 1},
                                                  {"4.8^2", 5},
                                                  {"6^3", 11}}));
    for (std::size_t i = 0; i < 93; ++i) EXPECT_EQ(isohedral_types()[i].number, static_cast<int>(i) + 1);
}

TEST(IsohedralTypes, TwelveNeedMarkings)
{
    std::vector<int> marked;
    for (const IsohedralType& type : isohedral_types())
        if (type.is_marked) marked.push_back(type.number);
    EXPECT_THAT(marked, ElementsAre(19, 35, 48, 60, 63, 65, 70, 75, 80, 87, 89, 92));
}

TEST(IsohedralTypes, HaveTheNumbersOfTheClassNotes)
{
    // N. II, figure 19 and section 7.4; figure 20: IH21 has six aspects.
    EXPECT_EQ(ih(16).symbol, "a+b+c+c-b-a-;a-c+b+");
    EXPECT_EQ(ih(16).topology, "3^6");
    EXPECT_EQ(ih(16).shape.aspects.size(), 3U);
    EXPECT_EQ(ih(16).shape.parameters(), 1U);
    EXPECT_THAT(ih(16).shape.curve_shapes, ElementsAre(EdgeShape::straight, EdgeShape::free));
    EXPECT_EQ(ih(21).shape.aspects.size(), 6U);
    // Section 7.3.2: nine types have squares and no parameters, seven have parallelograms and two.
    int squares = 0, parallelograms = 0;
    for (const IsohedralType& type : isohedral_types()) {
        if (type.topology != "4^4") continue;
        if (type.shape.parameters() == 0) ++squares;
        if (type.shape.parameters() != 2) continue;
        const IsohedralTile tile(type, {{0.1, 0.23}, {}});
        const auto& c = tile.corners();
        const double x = c[0][0] - c[1][0] + c[2][0] - c[3][0], y = c[0][1] - c[1][1] + c[2][1] - c[3][1];
        if (std::hypot(x, y) < 1e-9) ++parallelograms;
    }
    EXPECT_EQ(squares, 9);
    EXPECT_EQ(parallelograms, 7);
}

TEST(IsohedralTypes, HaveTheParametersOfTheirGroups)
{
    // Counted by hand. IH1, p1: two corners that move freely, a free lattice, less where the tiling lies: 2 * 2 + 2
    // - 2. IH4, p2: the same without the last, as half-turns fix the place. IH7, p3: two corners, one of them in the
    // middle of a rotation, and no lattice. IH20: nothing.
    EXPECT_EQ(ih(1).shape.parameters(), 4U);
    EXPECT_EQ(ih(4).shape.parameters(), 6U);
    EXPECT_EQ(ih(7).shape.parameters(), 2U);
    EXPECT_EQ(ih(20).shape.parameters(), 0U);
    EXPECT_EQ(ih(41).shape.parameters(), 2U); // parallelograms
    EXPECT_EQ(ih(72).shape.parameters(), 1U); // rectangles
    EXPECT_EQ(ih(84).shape.parameters(), 2U); // triangles
    EXPECT_EQ(ih(46).shape.parameters(), 4U); // quadrangles
}

TEST(IsohedralTypes, SymbolsCanBeReadFromAnyEdge)
{
    for (const IsohedralType& type : isohedral_types()) {
        EXPECT_EQ(type.shape.symbol.incidence(0, false), type.symbol);
        for (const std::string& incidence : type.shape.symbol.incidences()) {
            const TileSymbol other = read_from(type.shape.symbol, incidence);
            EXPECT_EQ(other.incidence(0, false), incidence);
            EXPECT_EQ(other.incidences(), type.shape.symbol.incidences());
            EXPECT_EQ(isohedral_template(other).aspects.size(), type.shape.aspects.size());
        }
    }
    EXPECT_EQ(message_of<std::logic_error>([] { read_from(ih(1).shape.symbol, "a;a"); }),
              "a tile has no incidence symbol a;a");
}

/// The motions that map an outline to itself, corner to corner.
std::vector<PlaneMotion> symmetries_of(const IsohedralTile& tile)
{
    std::vector<PlaneMotion> symmetries;
    const auto& corners = tile.corners();
    const std::size_t k = corners.size();
    const auto has = [&](const PlanePoint& p) {
        for (const PlanePoint& q : tile.outline())
            if (std::hypot(p[0] - q[0], p[1] - q[1]) < 1e-7) return true;
        return false;
    };
    for (std::size_t to = 0; to < k; ++to)
        for (const bool is_mirror : {false, true}) {
            // Corner 0 goes to corner `to`; corners are around (0, 0), which stays.
            const PlanePoint &a = corners[0], &b = corners[to];
            const double s = a[0] * a[0] + a[1] * a[1];
            const double c = (is_mirror ? b[0] * a[0] - b[1] * a[1] : b[0] * a[0] + b[1] * a[1]) / s;
            const double d = (is_mirror ? b[1] * a[0] + b[0] * a[1] : b[1] * a[0] - b[0] * a[1]) / s;
            const PlaneMotion motion = is_mirror ? PlaneMotion{c, d, d, -c} : PlaneMotion{c, -d, d, c};
            if (std::abs(c * c + d * d - 1) > 1e-7) continue;
            if (std::ranges::all_of(tile.outline(), [&](const PlanePoint& p) { return has(motion(p)); }))
                symmetries.push_back(motion);
        }
    return symmetries;
}

/// The number of symmetries of the tile that map all tiles around it to tiles, as far as outlines show.
std::size_t symmetries_in_tiling(const IsohedralTile& tile)
{
    const double reach = 6 * std::sqrt(area_of(tile.outline()));
    std::vector<PlaneMotion> motions;
    for (const TilePlace& place : tile.tiles_near({-reach, -reach}, {reach, reach}))
        motions.push_back(tile.motion(place));
    const std::vector<PlaneMotion> own = symmetries_of(tile);
    const auto is_tile = [&](const PlaneMotion& motion) {
        for (const PlaneMotion& other : motions) {
            if (std::hypot(other.x - motion.x, other.y - motion.y) > 1e-6) continue;
            for (const PlaneMotion& symmetry : own)
                if (same_linear_part(other * symmetry, motion)) return true;
        }
        return false;
    };
    std::size_t count = 0;
    for (const PlaneMotion& symmetry : own)
        count += std::ranges::all_of(tile.hops(), [&](const PlaneMotion& hop) { return is_tile(symmetry * hop); });
    return count;
}

TEST(IsohedralTypes, RandomShapesHaveNoOtherSymmetriesExceptWhereMarkingsAreNeeded)
{
    for (const IsohedralType& type : isohedral_types()) {
        const std::size_t seen = symmetries_in_tiling(random_tile(type, 3, 0.2, 0.1));
        EXPECT_EQ(seen > type.shape.symmetries.size(), type.is_marked) << "IH" << type.number;
        EXPECT_GE(seen, type.shape.symmetries.size()) << "IH" << type.number;
    }
}

}
}
