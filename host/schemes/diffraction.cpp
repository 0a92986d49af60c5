// kind = "diffraction": tilings with aperiodic sets beside stochastic ones, by eye, by the power spectrum of one
// colour, and by the autocorrelation of all.
//
// Cohen, Shade, Hiller and Deussen, Wang Tiles for Image and Texture Generation, 2003, figure 2: each pixel is a tile.
#include "analysis/tilings/color_statistics.hpp"
#include "base/images/grey_image.hpp"
#include "base/images/png_file.hpp"
#include "base/programs/interrupt.hpp"
#include "host/schemes/scheme_run.hpp"
#include "tiles/tilings/tile_shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace poissonlab {
namespace {

constexpr std::uint64_t small_picture = 32, large_picture = 256; // tiles along each side, as the article has them
constexpr int picture_side = 512;                                // pixels
constexpr double strongest_share = 0.001;                        // of the frequencies
constexpr int diffraction_lags = 64;

/// All tiles of a square, rows from the south.
std::vector<TileIndex> square_of(const TilingRequest& request, std::uint64_t size)
{
    std::vector<TileIndex> tiles(size * size);
    stream_tiles(request, {0, 0, 0, size, size, 1},
                 [&](std::int64_t x, std::int64_t y, auto, std::span<const TileIndex> row) {
                     std::ranges::copy(row, tiles.begin() + y * static_cast<std::int64_t>(size) + x);
                 });
    return tiles;
}

/// The colours of southern edges, or of south-western corners.
ColorField field_of(const TilingRequest& request, const std::vector<TileIndex>& tiles, std::uint64_t size)
{
    ColorField field{request.colors, size, {}};
    for (const TileIndex tile : tiles)
        field.values.push_back(static_cast<std::uint8_t>(request.kind == TileKind::wang
                                                             ? wang_tile(tile, request.all_colors()).south
                                                             : corner_tile(tile, request.colors).south_west));
    return field;
}

/// The colours of the tiles of a set, each its own: red, green, blue.
std::vector<std::array<std::uint8_t, 3>> pixels_of_tiles(const TileSet& set)
{
    std::vector<std::array<std::uint8_t, 3>> pixels(set.size());
    for (std::size_t tile = 0; tile < pixels.size(); ++tile) {
        const std::string color = tile_color(static_cast<Color>(tile));
        for (std::size_t i = 0; i < 3; ++i)
            std::from_chars(color.data() + 1 + 2 * i, color.data() + 3 + 2 * i, pixels[tile][i], 16);
    }
    return pixels;
}

PngPixels tile_pixels(const TilingRequest& request, std::uint64_t tiles)
{
    const TileSet set = tile_set_of(request);
    const auto colors = pixels_of_tiles(set);
    const std::vector<TileIndex> square = square_of(request, tiles);
    const int block = picture_side / static_cast<int>(tiles);
    PngPixels pixels{picture_side, picture_side, 3, {}};
    pixels.values.reserve(std::size_t{3} * picture_side * picture_side);
    for (int row = 0; row < picture_side; ++row)
        for (int column = 0; column < picture_side; ++column) {
            const auto x = static_cast<std::size_t>(column / block);
            const auto y = tiles - 1 - static_cast<std::size_t>(row / block);
            const auto& pixel = colors[set.position(square[y * tiles + x]).value()];
            pixels.values.insert(pixels.values.end(), pixel.begin(), pixel.end());
        }
    return pixels;
}

/// A picture with -10 dB in black and 30 dB in white.
GreyImage spectrum_image_of(const ColorSpectrum& spectrum)
{
    const int n = static_cast<int>(spectrum.size);
    GreyImage image(n, n, 0);
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            const double power =
                spectrum.power[static_cast<std::size_t>(y) * spectrum.size + static_cast<std::size_t>(x)];
            const double decibels = 10 * std::log10(std::max(power, 1e-9));
            image.at(x, n - 1 - y) =
                static_cast<std::uint8_t>(std::lround(255 * std::clamp((decibels + 10) / 40, 0.0, 1.0)));
        }
    return image;
}

void add_tiling(const TilingRequest& request, const DiffractionSettings& settings, DistributionFiles& files,
                DistributionResult& result)
{
    stop_if_interrupted();
    const std::string& name = request.algorithm;
    const ColorField field = field_of(request, square_of(request, settings.size), settings.size);
    const ColorSpectrum spectrum = color_spectrum(field, settings.color);
    const auto lags = std::min<int>(diffraction_lags, static_cast<int>(settings.size) - 1);
    const ColorAutocorrelation autocorrelation = color_autocorrelation(field, lags);
    const auto add_pixels = [&](const std::string& file, std::uint64_t tiles) {
        write_png(files.add(file), tile_pixels(request, tiles));
        result.pictures.push_back({file, fmt::format("{0}, {1} x {1} tiles, each a colour.", name, tiles)});
    };
    add_pixels(name + "-small.png", small_picture);
    add_pixels(name + "-large.png", large_picture);
    write_png(files.add(name + "-spectrum.png"), spectrum_image_of(spectrum));
    result.pictures.push_back(
        {name + "-spectrum.png",
         fmt::format("{0}: power spectrum of colour {1} over {2} x {2} tiles; black -10 dB, white "
                     "30 dB.",
                     name, settings.color, settings.size)});
    result.numbers.push_back({"peak_" + name, "Highest power, " + name, spectrum.peak(), "1: the mean", {}, true});
    result.numbers.push_back({"strongest_" + name,
                              "Power of the strongest 0.1 % of frequencies, " + name,
                              spectrum.strongest(strongest_share),
                              "of all; chance: 0.0079",
                              {},
                              true});
    result.tables.front().rows.push_back(
        {name, fmt::format("{}", tile_set_of(request).size()), fmt::format("{:.1f}", spectrum.peak()),
         fmt::format("{:.2f} %", 100 * spectrum.strongest(strongest_share)),
         fmt::format("{:.1f}", autocorrelation.largest),
         fmt::format("({}, {})", autocorrelation.largest_at[0], autocorrelation.largest_at[1]),
         fmt::format("{:.2f}", autocorrelation.bound)});
}

}

DistributionResult make_diffraction(const DiffractionSettings& settings, DistributionFiles& files)
{
    DistributionResult result;
    result.facts = {fmt::format("{0} x {0} tiles", settings.size),
                    fmt::format("colour {} of southern edges, or of south-western corners", settings.color)};
    result.tables.push_back(
        {fmt::format("Power spectra of one colour, of mean 1; autocorrelations of all colours in "
                     "standard deviations of random order, up to {} tiles along each axis",
                     diffraction_lags),
         {"tiling", "tiles in the set", "highest power", "part of the power in the strongest 0.1 %; chance: 0.79 %",
          "largest correlation", "at", "chance passes in 1 of 100"},
         {}});
    for (const TilingRequest& request : settings.tilings) add_tiling(request, settings, files, result);
    return result;
}

}
