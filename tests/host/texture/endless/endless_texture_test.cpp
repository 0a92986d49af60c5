// Endless textures: the kernel against its plain twin, windows against each other, and tiles against their own tilings.
#include "host/texture/endless/endless_texture.hpp"

#include "host/device/device.hpp"
#include "tests/host/texture/mapped_noise.hpp"
#include "tests/host/texture/random_picture.hpp"
#include "tests/support/errors.hpp"
#include "tiles/texture/texture_tiling.hpp"

#include <gmock/gmock.h>

namespace poissonlab {
namespace {

/// Requests in which every branch of the kernel is taken.
std::vector<EndlessRequest> all_endless_requests()
{
    std::vector<EndlessRequest> requests;
    for (const auto& [method, word] : endless_methods.entries) {
        if (method == EndlessMethod::quilted) continue;
        EndlessRequest request;
        request.method = method;
        request.seed = 7;
        requests.push_back(request);
        request.tileable = true;
        requests.push_back(request);
    }
    EndlessRequest hexagons;
    hexagons.gain = 3;
    hexagons.exponent = 2;
    requests.push_back(hexagons);
    hexagons.restored = true;
    requests.push_back(hexagons);
    hexagons.turn = 0.5;
    requests.push_back(hexagons);
    hexagons.tileable = true;
    requests.push_back(hexagons);
    EndlessRequest offsets;
    offsets.method = EndlessMethod::offsets;
    offsets.restored = true;
    requests.push_back(offsets);
    return requests;
}

void expect_twin(const EndlessTexture& texture, const PixelWindow& window, const std::vector<std::size_t>& groups)
{
    Device device = Device::open();
    const PngPixels expected = reference_endless_window(texture, window);
    for (const std::size_t group : groups)
        EXPECT_EQ(endless_window(device, texture, window, group).values, expected.values)
            << "method " << texture.method << ", groups of " << group;
}

constexpr PixelWindow far_window{-(std::int64_t{1} << 36) - 11, (std::int64_t{1} << 35) + 5, 53, 38};

// Oclgrind interprets these as well: see tests/CMakeLists.txt.
class EndlessMethods : public testing::TestWithParam<EndlessMethod>
{
};

TEST_P(EndlessMethods, AreTheSameOnADevice)
{
    EndlessRequest request;
    request.method = GetParam();
    const PngPixels exemplar = test::random_picture(61, 57, 3, 3);
    expect_twin(endless_texture(request, exemplar), {-5, -3, 21, 4}, {64});
    request.tileable = true;
    expect_twin(endless_texture(request, exemplar), {-5, -3, 21, 4}, {64});
}

INSTANTIATE_TEST_SUITE_P(Small, EndlessMethods,
                         testing::Values(EndlessMethod::repeated, EndlessMethod::offsets, EndlessMethod::hexagons,
                                         EndlessMethod::blended));

/// Far away, with one channel, all corrections of weights and other work-groups.
TEST(EndlessTexture, IsTheSameOnADevice)
{
    const PngPixels exemplar = test::random_picture(61, 57, 1, 3);
    EndlessRequest request;
    request.method = EndlessMethod::blended;
    expect_twin(endless_texture(request, exemplar), far_window, {64});
    request.method = EndlessMethod::hexagons;
    request.restored = true;
    request.gain = 3;
    expect_twin(endless_texture(request, exemplar), far_window, {16});
    request.turn = 1;
    expect_twin(endless_texture(request, exemplar), far_window, {16});
    request.tileable = true;
    expect_twin(endless_texture(request, test::random_picture(61, 57, 3, 3)), {-40, -30, 53, 38}, {64});
}

/// Tiles are laid as their own windows have them.
TEST(EndlessTexture, OfTilesIsTheirTiling)
{
    for (const TextureKind kind : {TextureKind::corner, TextureKind::wang}) {
        const TextureSet set = test::mapped_noise(kind, 3, 1, 2);
        const TileWindow tiles{-3, 5, 4, 3};
        const PngPixels tiling =
            texture_window_pixels(set, texture_window(set, tiles, 9), set.values, set.exemplar.channels);
        const PixelWindow window{-3 * set.size, -8 * set.size, 4 * set.size, 3 * set.size};
        EXPECT_EQ(reference_endless_window(endless_tiles(set, 9), window).values, tiling.values);
        expect_twin(endless_tiles(set, 9), {window.x + 5, window.y - 7, 40, 30}, {64});
    }
}

/// Parts of a window are those of the whole, in whichever piece of the plane each begins.
TEST(EndlessTexture, IsAFunctionOfThePlane)
{
    const PngPixels exemplar = test::random_picture(61, 57, 3, 3);
    for (const EndlessRequest& request : all_endless_requests()) {
        const EndlessTexture texture = endless_texture(request, exemplar);
        const PngPixels whole = reference_endless_window(texture, {-40, -50, 100, 90});
        for (const auto& [x, y] : {std::pair{0, 0}, {1, 47}, {63, 2}, {99, 89}}) {
            const PngPixels part = reference_endless_window(texture, {x - 40, y - 50, 1, 1});
            for (int c = 0; c < 3; ++c) EXPECT_EQ(part.values[part.at(0, 0, c)], whole.values[whole.at(x, y, c)]);
        }
    }
}

TEST(EndlessTexture, RepeatsAsItsExemplar)
{
    const PngPixels exemplar = test::random_picture(20, 12, 1, 3);
    EndlessRequest request;
    request.method = EndlessMethod::repeated;
    const PngPixels window = reference_endless_window(endless_texture(request, exemplar), {-3, 30, 50, 8});
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 50; ++x)
            EXPECT_EQ(window.values[window.at(x, y, 0)], exemplar.values[exemplar.at((x + 17) % 20, (y + 6) % 12, 0)]);
}

/// A turned piece as wide as the exemplar reaches beyond it by a whole exemplar and a texel; of one colour all is that.
TEST(EndlessTexture, GoesOnBesideTurnedPiecesThatAreWhole)
{
    EndlessRequest request;
    request.tileable = true;
    request.turn = 1;
    request.cell = 10;
    expect_twin(endless_texture(request, test::random_picture(10, 10, 1, 3)), {-40, -30, 120, 90}, {64});
    const PngPixels grey{10, 10, 1, std::vector<std::uint8_t>(100, 90)};
    for (const std::uint8_t value : reference_endless_window(endless_texture(request, grey), {0, 0, 300, 300}).values)
        ASSERT_EQ(value, 90);
}

TEST(EndlessTexture, TakesTheMemoryThatItSays)
{
    Device device = Device::open();
    EndlessRequest request;
    request.method = EndlessMethod::blended;
    const EndlessTexture texture = endless_texture(request, test::random_picture(61, 57, 3, 3));
    const std::uint64_t before = device.memory().total;
    device.watch_memory();
    endless_window(device, texture, far_window, 64);
    EXPECT_EQ(endless_memory(texture, far_window),
              (DeviceMemory{device.peak_memory().largest, device.peak_memory().total - before}));
    EXPECT_EQ(bytes_of(texture), 61u * 57 * 3 * 2 + 3 * 2048 * 4);
}

TEST(EndlessTexture, RefusesPiecesThatDoNotFit)
{
    EndlessRequest request;
    request.cell = 40;
    EXPECT_EQ(message_of([&] { check(request, test::random_picture(61, 57, 1, 3)); }),
              "cell = 40: must be at most 28, so that pieces of the exemplar, 61 x 57 pixels, are inside of it, unless "
              "it is tileable");
    request.cell.reset();
    EXPECT_EQ(message_of([&] { check(request, test::random_picture(16, 16, 1, 3)); }),
              "exemplar: 16 x 16 pixels: must have more for pieces of 8 pixels");
}

}
}
