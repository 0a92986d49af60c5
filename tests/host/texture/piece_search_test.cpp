// Searches for the windows that are cut for new pieces, against the article's formula.
#include "host/texture/piece_fitting.hpp"

#include "host/texture/texture_build.hpp"
#include "tests/host/texture/random_picture.hpp"
#include "tests/support/errors.hpp"
#include "tiles/texture/texture_certificate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace poissonlab {
namespace {

/// Ng and others 2005, section 3.2: sums of weights around the circle, and near the middles of sides, by the article's
/// formula. The one window that is cut has the least sum.
TEST(PieceSearches, FindTheLeastWeightsOfTheArticle)
{
    constexpr int side = 8;
    const PngPixels exemplar = test::random_picture(21, 19, 3, 5), canvas = test::random_picture(side, side, 3, 6);
    const auto is_kept = [](int x, int y) { return std::hypot(x - 3.5, y - 3.5) >= 3; };
    std::vector<PixelRole> roles;
    for (int i = 0; i < side * side; ++i)
        roles.push_back(is_kept(i % side, i / side) ? PixelRole::kept : PixelRole::free);
    const auto value = [](const PngPixels& p, int x, int y, int c) {
        return static_cast<int>(p.values[p.at(x, y, c)]);
    };
    for (const PieceSearch search : {PieceSearch::circle, PieceSearch::middles}) {
        const SquareSums sums = cost_sums(exemplar, canvas, roles, search, SeamWeight::gradient);
        ASSERT_EQ(sums.sums.size(), 14u * 12);
        for (int wy = 0; wy < 12; ++wy)
            for (int wx = 0; wx < 14; ++wx) {
                std::uint64_t expected = 0;
                const auto add = [&](int x, int y, int dx, int dy) {
                    const auto is_near = [&](int px, int py) {
                        double least = 100;
                        for (const auto& [mx, my] : {std::pair{3.5, 0.0}, {3.5, 7.0}, {0.0, 3.5}, {7.0, 3.5}})
                            least = std::min(least, std::hypot(px - mx, py - my));
                        return least <= side / 8.0;
                    };
                    const bool first = is_kept(x, y), second = is_kept(x + dx, y + dy);
                    if (search == PieceSearch::circle ? first == second : !is_near(x, y) || (first && second)) return;
                    int difference = 0, gradients = 0;
                    for (const int step : {0, 1})
                        for (int c = 0; c < 3; ++c) {
                            const int px = x + step * dx, py = y + step * dy;
                            difference += std::abs(value(canvas, px, py, c) - value(exemplar, wx + px, wy + py, c));
                        }
                    for (const bool is_canvas : {true, false})
                        for (const int step : {0, 1}) {
                            const int px = x + step * dx, py = y + step * dy;
                            const int ax = std::max(px - dx, 0), ay = std::max(py - dy, 0);
                            const int bx = std::min(px + dx, side - 1), by = std::min(py + dy, side - 1);
                            for (int sum = 0, c = 0; c < 3; ++c) {
                                sum += is_canvas ? std::abs(value(canvas, ax, ay, c) - value(canvas, bx, by, c))
                                                 : std::abs(value(exemplar, wx + ax, wy + ay, c) -
                                                            value(exemplar, wx + bx, wy + by, c));
                                if (c == 2) gradients += sum * 2 / (bx - ax + by - ay);
                            }
                        }
                    expected += static_cast<std::uint64_t>(1 + difference * 512 / (gradients + 8));
                };
                for (int y = 0; y < side; ++y)
                    for (int x = 0; x < side; ++x) {
                        if (x + 1 < side) add(x, y, 1, 0);
                        if (y + 1 < side) add(x, y, 0, 1);
                    }
                ASSERT_EQ(sums.at(wx, wy), expected) << wx << " " << wy;
                ASSERT_GT(expected, 0u);
            }
        TextureRequest request;
        request.search = search, request.candidates = 1, request.weight = SeamWeight::gradient;
        UsedWindows used(1);
        SourceCanvas sources{side, {}};
        for (int i = 0; i < side * side; ++i)
            sources.sources.push_back({static_cast<std::uint16_t>(i % side), static_cast<std::uint16_t>(i / side)});
        const auto piece =
            fit_pieces(exemplar, {sources}, roles, request, used, "", [](const auto&, auto, auto) {}).front().window;
        const SquareSums own =
            cost_sums(exemplar, window_pixels(exemplar, {0, 0, side}), roles, search, request.weight);
        EXPECT_EQ(own.at(piece.x, piece.y), *std::ranges::min_element(own.sums));
    }
    TextureRequest request;
    request.kind = TextureKind::omega, request.colors = {4, 4}, request.size = 32, request.search = PieceSearch::circle;
    EXPECT_THAT(message_of([&] { check(request); }),
                testing::HasSubstr("search = circle: is for corner and omega tiles"));
    request.stages = 1;
    const PngPixels noise = test::random_picture(120, 110, 1, 7);
    EXPECT_EQ(certify_texture(build_texture(request, noise, [](const auto&, auto, auto) {}).set).exceptions, 0u);
}

}
}
