// Endless textures against their papers: hexagons.py writes these down with numpy, and papers_numbers.hpp has what it
// prints.
#include "host/texture/endless/endless_texture.hpp"
#include "tests/host/texture/endless/papers_numbers.hpp"

#include <gmock/gmock.h>

namespace poissonlab {
namespace {

PngPixels papers_exemplar(int channels)
{
    PngPixels picture{97, 83, channels, {}};
    for (int y = 0; y < 83; ++y)
        for (int x = 0; x < 97; ++x)
            for (int c = 0; c < channels; ++c)
                picture.values.push_back(
                    static_cast<std::uint8_t>((x * x * 7 + y * y * 3 + x * y * 5 + c * 91) % 251 * (x % 13 + 12) / 25));
    return picture;
}

EndlessTexture papers_texture(EndlessMethod method, int channels, double turn = 0)
{
    EndlessRequest request;
    request.turn = turn;
    request.method = method;
    request.cell = 24;
    request.seed = 5;
    return endless_texture(request, papers_exemplar(channels));
}

constexpr PixelWindow papers_window{-40, -9, 100, 39};

/// Every third row and seventh column, as hexagons.py goes through them.
template <class Visit>
void visit_papers_pixels(const Visit& visit)
{
    std::size_t number = 0;
    for (int y = 0; y < papers_window.height; y += 3)
        for (int x = 0; x < papers_window.width; x += 7) visit(x, y, number++);
}

/// Rounding to bytes is half a level; lightness by 256ths moves weights by at most 0.6 x 0.0036 / 0.4 of themselves,
/// and a blend of two colours by a quarter of that of 255 levels; the numbers are printed with four digits.
TEST(EndlessPapers, HexagonsAreMikkelsens)
{
    const PngPixels window = reference_endless_window(papers_texture(EndlessMethod::hexagons, 3), papers_window);
    visit_papers_pixels([&](int x, int y, std::size_t number) {
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(window.values[window.at(x, y, c)], hexagon_colors[3 * number + static_cast<std::size_t>(c)],
                        0.95)
                << x << " " << y;
    });
}

/// Places of turned texels are rounded to 256ths, which moves a colour between two of 255 levels by half of one along
/// each axis, and pieces to bytes, by another half.
TEST(EndlessPapers, HexagonsTurnAsMikkelsens)
{
    const PngPixels window = reference_endless_window(papers_texture(EndlessMethod::hexagons, 3, 1), papers_window);
    visit_papers_pixels([&](int x, int y, std::size_t number) {
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(window.values[window.at(x, y, c)], turned_colors[3 * number + static_cast<std::size_t>(c)],
                        0.95 + 1.5)
                << x << " " << y;
    });
}

/// Tables back have 128 entries a standard deviation: values are quantiles of numbers within one of them.
TEST(EndlessPapers, NoiseIsThatOfHeitzAndNeyret)
{
    const PngPixels window = reference_endless_window(papers_texture(EndlessMethod::blended, 1), papers_window);
    visit_papers_pixels([&](int x, int y, std::size_t number) {
        EXPECT_GE(window.values[window.at(x, y, 0)], lower_noise[number]) << x << " " << y;
        EXPECT_LE(window.values[window.at(x, y, 0)], upper_noise[number]) << x << " " << y;
    });
}

}
}
