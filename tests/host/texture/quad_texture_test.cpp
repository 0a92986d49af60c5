// Texture tiles for quads are counted, and neighbours must continue each other, pixel by pixel, whichever sides meet.
#include "host/texture/quads/quad_texture.hpp"

#include "tests/host/texture/random_picture.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

QuadTextureSet small_set(QuadLabels labels, std::uint32_t colors)
{
    QuadTextureRequest request{labels, colors, {}};
    request.pieces.size = 16;
    request.pieces.candidates = 1;
    return make_quad_texture(test::random_picture(96, 80, 3, 5), request,
                             [](const std::string&, std::size_t, std::size_t) {});
}

/// Returns a pixel of a tile that lies so far along a side, counterclockwise, and so deep; turned as seen with that
/// side below.
TurnedSource seen_from(const QuadTextureSet& set, std::size_t tile, std::uint32_t side, int along, int depth)
{
    const int last = set.size - 1;
    const std::array<std::array<int, 2>, 4> places{
        {{along, last - depth}, {last - depth, last - along}, {last - along, depth}, {depth, along}}};
    const auto [x, y] = places[side];
    TurnedSource source =
        set.tiles[tile][static_cast<std::size_t>((y + set.gutter) * (set.size + 2 * set.gutter) + x + set.gutter)];
    source.turns = static_cast<std::uint8_t>((source.turns + 4 - side) % 4);
    return source;
}

/// Compares what each tile shows beyond each side with all tiles that may lie there.
void expect_to_fit(const QuadTextureSet& set, QuadLabels labels, std::uint32_t colors)
{
    for (std::size_t a = 0; a < set.tiles.size(); ++a)
        for (std::uint32_t i = 0; i < 4; ++i) {
            int compared = 0;
            for (std::size_t b = 0; b < set.tiles.size(); ++b)
                for (std::uint32_t j = 0; j < 4; ++j) {
                    if (set.labels[b][j] != opposite_label(labels, colors, set.labels[a][i])) continue;
                    for (int t = set.gutter; t < set.size - set.gutter; ++t) {
                        const TurnedSource beyond = seen_from(set, a, i, t, -1),
                                           own = seen_from(set, b, j, set.size - 1 - t, 0);
                        ASSERT_EQ(beyond.pixel, own.pixel);
                        ASSERT_EQ((beyond.turns + 2) % 4, own.turns);
                        ++compared;
                    }
                }
            EXPECT_GT(compared, 0) << "side " << i << " of tile " << a << " has no neighbour";
        }
}

TEST(QuadTextures, OfGeneralisedWangTilesAreCompleteAndFit)
{
    for (const std::uint32_t colors : {1u, 2u}) {
        const QuadTextureSet set = small_set(QuadLabels::wang, colors);
        // Burnside's lemma counts colourings of four sides with n labels, up to turns.
        const std::size_t n = 2 * colors;
        EXPECT_EQ(set.tiles.size(), (n * n * n * n + n * n + 2 * n) / 4);
        expect_to_fit(set, QuadLabels::wang, colors);
    }
}

TEST(QuadTextures, OfCornerTilesAreCompleteAndFit)
{
    for (const std::size_t n : {1u, 3u}) {
        const auto colors = static_cast<std::uint32_t>(n);
        const QuadTextureSet set = small_set(QuadLabels::corner, colors);
        EXPECT_EQ(set.tiles.size(), (n * n * n * n + n * n + 2 * n) / 4);
        expect_to_fit(set, QuadLabels::corner, colors);
    }
}

TEST(QuadTextures, TurnLabelsAndPixelsTogether)
{
    const SideLabels labels{3, 0, 2, 1};
    EXPECT_EQ(least_turn(labels), 1u);
    EXPECT_EQ(turned_labels(labels, 1), (SideLabels{0, 2, 1, 3}));
    for (std::uint32_t label = 0; label < 9; ++label)
        EXPECT_EQ(opposite_label(QuadLabels::corner, 3, opposite_label(QuadLabels::corner, 3, label)), label);
}

}
}
