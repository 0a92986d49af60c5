// Endless textures without tiles as results: repeated exemplars, squares and hexagons at random places, by-example
// noise, and quilted pictures, with the measures that tiles have as well.
#include "host/distribution/textures/texture_run.hpp"

#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"
#include "host/device/device.hpp"
#include "host/distribution/textures/plane_picture.hpp"
#include "host/distribution/textures/texture_exemplar.hpp"
#include "host/distribution/textures/texture_pictures.hpp"
#include "host/distribution/textures/texture_values.hpp"
#include "host/texture/comparison/light_map.hpp"
#include "host/texture/endless/gaussian_exemplar.hpp"
#include "host/texture/endless/quilting.hpp"
#include "host/texture/exemplar.hpp"
#include "tiles/texture/tiling_judge.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {
namespace {

/// A texture of one seed: what its pixels are looked up in, or the picture that was quilted.
struct MadeTexture
{
    EndlessRequest request;
    std::optional<EndlessTexture> endless;
    QuiltedPicture quilted;
};

/// The side of a quilted picture: what is measured, and what is shown.
int quilted_side(const TextureSettings& settings, const PngPixels& exemplar)
{
    const int size = settings.request.size;
    return std::max({static_cast<int>(measured_tiles) * size, compared_side(exemplar),
                     static_cast<int>(std::max(settings.columns, settings.rows)) * size});
}

QuiltedPicture quilted_with_steps(const EndlessRequest& request, const PngPixels& exemplar, int width, int height,
                                  const DistributionPlace& place)
{
    return quilted_picture(request, exemplar, width, height, [&](int done, int total) {
        stop_if_interrupted();
        if (place.on_step) place.on_step(fmt::format("quilting: {} of {}", done, total));
    });
}

MadeTexture made_texture(const TextureSettings& settings, const PngPixels& exemplar, std::uint64_t seed,
                         const DistributionPlace& place)
{
    MadeTexture made{*settings.endless, {}, {}};
    made.request.seed = seed;
    if (made.request.method != EndlessMethod::quilted) {
        made.endless = endless_texture(made.request, exemplar);
        return made;
    }
    const int side = quilted_side(settings, exemplar);
    made.quilted = quilted_with_steps(made.request, exemplar, side, side, place);
    return made;
}

PngPixels square_of(const MadeTexture& made, int width, int height, const DistributionPlace& place)
{
    if (!made.endless) return picture_part(made.quilted.pixels, 0, 0, width, height);
    return endless_pixels(*made.endless, {0, 0, width, height}, place);
}

/// A quilted picture as one tile, whose seams can be measured.
TextureSet set_of_one(const QuiltedPicture& quilted, const PngPixels& exemplar)
{
    TextureSet set;
    set.size = quilted.pixels.width;
    set.exemplar = exemplar;
    set.tiles = {{}};
    set.sources = quilted.sources;
    set.values = quilted.pixels.values;
    return set;
}

/// The rectangle after which what a method shows could recur: the exemplar, squares, two rows of hexagons, or the step
/// from block to block.
struct LatticeRectangle
{
    int width = 0;
    int height = 0;
};

LatticeRectangle lattice_of(const EndlessRequest& request, const PngPixels& exemplar)
{
    if (request.method == EndlessMethod::repeated) return {exemplar.width, exemplar.height};
    if (request.method == EndlessMethod::quilted) return {quilting_step(request), quilting_step(request)};
    const int cell = request.cell_of(exemplar);
    return {cell, request.has_hexagons() ? 2 * request.row_of(exemplar) : cell};
}

/// Measures what recurs in as many rectangles as tilings have tiles, in as large a square as compare_texture() takes at
/// most, or in the picture that was quilted.
void add_recurrence(const MadeTexture& made, const PngPixels& exemplar, const DistributionPlace& place,
                    TextureValues& values)
{
    const auto [width, height] = lattice_of(made.request, exemplar);
    const int most = made.endless ? peak_side : made.quilted.pixels.width,
              side = static_cast<int>(
                  std::min<std::int64_t>(most, static_cast<std::int64_t>(recurrence_tiles) * std::max(width, height)));
    values["recurrence_width"] = width;
    // An exemplar of which the square does not hold two is repeated all the same.
    if (made.request.method == EndlessMethod::repeated && (side / width) * (side / height) < 2)
        values["recurrence"] = 1;
    else if (const auto recurs = recurrence(square_of(made, side, side, place), width, height))
        values["recurrence"] = *recurs;
}

TextureValues values_of(const TextureSettings& settings, const MadeTexture& made, const PngPixels& exemplar,
                        const DistributionPlace& place)
{
    const int size = settings.request.size, side = static_cast<int>(measured_tiles) * size;
    TextureValues values;
    if (made.endless) {
        values["atlas_pixels"] = static_cast<double>(exemplar.width) * exemplar.height;
        values["atlas_bytes"] = static_cast<double>(bytes_of(*made.endless));
        values["fetches"] = *fetches_of(made.request, exemplar.channels);
    } else {
        const double pixels = static_cast<double>(made.quilted.sources.size());
        values["atlas_pixels"] = pixels;
        values["atlas_bytes"] = pixels * exemplar.channels;
        values["fetches"] = 1;
        add_seam_values(set_of_one(made.quilted, exemplar), pixels / (static_cast<double>(size) * size), values);
    }
    const PngPixels square = square_of(made, side, side, place);
    add_picture_values(square, exemplar, size, values);
    add_recurrence(made, exemplar, place, values);
    if (patch_fits(exemplar, judged_patch))
        values["novelty"] = PatchNovelty(exemplar, judged_patch).share(square, std::max(1, side / 64));
    if (settings.is_compared)
        add_comparison(
            exemplar, [&](int pixels) { return square_of(made, pixels, pixels, place); },
            made.endless ? compared_tiles * size : made.quilted.pixels.width, values);
    return values;
}

/// The Gaussian exemplar as a picture: three standard deviations to either side of grey.
PngPixels gaussian_picture(const PngPixels& exemplar)
{
    using namespace contract::endless_texture;
    PngPixels picture{exemplar.width, exemplar.height, exemplar.channels, {}};
    for (const std::uint16_t number : gaussian_exemplar(exemplar).numbers)
        picture.values.push_back(
            static_cast<std::uint8_t>(std::clamp(128 + (number - GAUSSIAN_ZERO) * 128 / (3 * GAUSSIAN_STEPS), 0, 255)));
    return picture;
}

/// The source map of a quilted picture.
PngPixels block_picture(const MadeTexture& made, const PngPixels& exemplar, int width, int height)
{
    const TextureSet set = set_of_one(made.quilted, exemplar);
    return picture_part({set.size, set.size, 3, piece_values(set)}, 0, 0, width, height);
}

void add_pictures(const TextureSettings& settings, const MadeTexture& made, const PngPixels& exemplar,
                  const DistributionPlace& place, DistributionFiles& files, DistributionResult& result)
{
    const auto write = [&](const std::string& name, const PngPixels& pixels, const std::string& caption) {
        write_png(files.add(name), pixels);
        result.pictures.push_back({name, caption});
    };
    const int width = static_cast<int>(settings.columns) * settings.request.size,
              height = static_cast<int>(settings.rows) * settings.request.size;
    for (const std::string& word : settings.show) {
        if (word == "exemplar") write("exemplar.png", exemplar, "The exemplar.");
        if (word == "tiling") write("tiling.png", square_of(made, width, height, place), "A window of the texture.");
        if (word == "plane")
            write("plane.png",
                  made.endless ? plane_picture(mapped_endless(made.request, exemplar), place)
                               : plane_picture(made.quilted.pixels, place),
                  made.endless ? "The endless plane, with anisotropic filtering."
                               : "A square of the picture, repeated, with anisotropic filtering.");
        if (word == "gaussian")
            write("gaussian.png", gaussian_picture(exemplar),
                  "The Gaussian exemplar that is blended: its coordinates as red, green and blue.");
        if (word == "pieces")
            write("pieces.png", block_picture(made, exemplar, width, height),
                  "The source map: colours tell windows of the exemplar apart.");
    }
}

std::vector<std::string> endless_facts(const TextureSettings& settings, const PngPixels& exemplar)
{
    const EndlessRequest& request = *settings.endless;
    std::vector<std::string> facts{fmt::format("exemplar of {} x {}", exemplar.width, exemplar.height)};
    if (request.has_hexagons())
        facts.push_back(
            fmt::format("triangles of {} pixels, {} high", request.cell_of(exemplar), request.row_of(exemplar)));
    if (request.method == EndlessMethod::offsets)
        facts.push_back(fmt::format("squares of {} pixels", request.cell_of(exemplar)));
    if (request.method == EndlessMethod::quilted) facts.push_back(fmt::format("blocks of {} pixels", request.block));
    if (settings.sets > 1) facts.push_back(fmt::format("measures over {} textures", settings.sets));
    return facts;
}

}

PngPixels endless_pixels(const EndlessTexture& texture, const PixelWindow& window, const DistributionPlace& place)
{
    if (place.engine == Engine::reference) return reference_endless_window(texture, window);
    check_fits("the endless texture", endless_memory(texture, window), place.device().info());
    return endless_window(place.device(), texture, window, default_work_group_size);
}

PngPixels endless_picture(const EndlessSettings& settings, std::uint64_t seed, const DistributionPlace& place)
{
    const PngPixels exemplar = read_exemplar(settings.exemplar);
    const auto& [x, y, width, height] = settings.window;
    EndlessRequest request = settings.request;
    request.seed = seed;
    if (request.method == EndlessMethod::quilted)
        return quilted_with_steps(request, exemplar, static_cast<int>(width), static_cast<int>(height), place).pixels;
    return endless_pixels(endless_texture(request, exemplar), {x, y, static_cast<int>(width), static_cast<int>(height)},
                          place);
}

DistributionResult make_endless(const TextureSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                                DistributionFiles& files)
{
    const ExemplarPictures pictures = texture_exemplar(settings, seed, place);
    const PngPixels& exemplar = pictures.exemplar;
    const std::string name =
        settings.pattern.empty() ? settings.exemplar.stem().string() : "pattern of " + settings.pattern;
    DistributionResult result;
    result.parameters = {{"exemplar", name}, {"kind", endless_methods[settings.endless->method]}};
    result.facts = endless_facts(settings, exemplar);
    result.facts.insert(result.facts.end(), pictures.notes.begin(), pictures.notes.end());
    std::vector<TextureValues> values;
    std::vector<DistributionNumber> times;
    for (int number = 0; number < settings.sets; ++number) {
        const MadeTexture made = made_texture(settings, exemplar, seed + static_cast<std::uint64_t>(number), place);
        values.push_back(values_of(settings, made, exemplar, place));
        if (number > 0) continue;
        add_pictures(settings, made, exemplar, place, files, result);
        if (settings.has_timing && place.engine == Engine::opencl) {
            times = time_numbers(place.device(), *made.endless);
            times.push_back(
                time_number("frames", frames_a_second(place.device(), mapped_endless(made.request, exemplar))));
        }
    }
    result.numbers = texture_numbers(values);
    result.numbers.insert(result.numbers.end(), times.begin(), times.end());
    return result;
}

}
