// The kind of `texture endless`, which draws a window of an endless texture without tiles.
#include "host/distribution/textures/endless_keys.hpp"

#include "base/errors/errors.hpp"
#include "base/images/raw_picture.hpp"
#include "host/distribution/textures/texture_run.hpp"
#include "host/kinds/kinds.hpp"
#include "host/texture/endless/quilting.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

namespace poissonlab {

void endless_keys(Keys& keys, EndlessRequest& r)
{
    keys.integer("cell", r.cell, least_endless_cell, most_endless_cell,
                 "of offsets, hexagons and blended: between lattice points, rounded to an even number")
        .unit("pixels")
        .otherwise("the exemplar's shorter side over 2 sqrt 3, of offsets a third of it");
    keys.integer("exponent", r.exponent, 1, most_endless_exponent,
                 "of hexagons and blended: the power of barycentric weights; larger ones blend less")
        .otherwise("7, of blended 1");
    keys.number("falloff", r.falloff, {0, 0.95},
                "of hexagons: the part of a weight that is the lightness of its pixel");
    keys.integer("gain", r.gain, 1, most_endless_gain,
                 "of hexagons: the contrast of weights, w becoming (2 w)^gain / 2 below a half");
    keys.number("turn", r.turn, {0, 1}, "of hexagons: how far each turns by chance, in half turns to either side");
    keys.flag("restored", r.restored, "of offsets and hexagons: give back the variance that blending takes");
    keys.flag("tileable", r.tileable, "of offsets, hexagons and blended: the exemplar's opposite borders fit");
    keys.integer("block", r.block, least_quilting_block, most_quilting_block,
                 "of quilted: the side of a block, a sixth of which overlaps")
        .unit("pixels");
    keys.number("tolerance", r.tolerance, {0, 10},
                "of quilted: blocks are drawn from those whose misfit is at most so much of the least one above it");
}

void check_keys_of_method(const Keys& keys, EndlessMethod method, const std::string& chosen_by)
{
    using enum EndlessMethod;
    struct KeyOfMethods
    {
        const char* key;
        std::vector<EndlessMethod> methods;
    };
    static const std::vector<KeyOfMethods> table{
        {"cell", {offsets, hexagons, blended}},
        {"exponent", {hexagons, blended}},
        {"falloff", {hexagons}},
        {"gain", {hexagons}},
        {"turn", {hexagons}},
        {"restored", {offsets, hexagons}},
        {"tileable", {offsets, hexagons, blended}},
        {"block", {quilted}},
        {"tolerance", {quilted}},
    };
    for (const auto& [key, methods] : table) {
        if (!keys.is_given(key) || std::ranges::find(methods, method) != methods.end()) continue;
        std::vector<std::string> words;
        for (const EndlessMethod one : methods) words.emplace_back(endless_methods[one]);
        throw keys.invalid(key, fmt::format("is for {} {}", keys.name_of(chosen_by), fmt::join(words, ", ")));
    }
}

void check_exemplar_size(const Keys& keys, const EndlessRequest& request, const std::filesystem::path& exemplar,
                         int pattern_size)
{
    if (!keys.is_read()) return;
    PngPixels size{pattern_size, pattern_size, 1, {}};
    if (!exemplar.empty()) {
        try {
            const PictureHeader header = read_picture_header(exemplar);
            size.width = header.width;
            size.height = header.height;
        } catch (const InputError&) {
            return; // reading the picture says more
        }
    }
    keys.check([&] { check(request, size); });
}

std::string endless_label(const EndlessRequest& request, const std::string& exemplar)
{
    std::string label = exemplar + ": ";
    switch (request.method) {
    case EndlessMethod::repeated:
        label += "repeated";
        break;
    case EndlessMethod::offsets:
        label += "squares at random offsets";
        break;
    case EndlessMethod::hexagons:
        label += "hex-tiling";
        break;
    case EndlessMethod::blended:
        label += "by-example noise";
        break;
    case EndlessMethod::quilted:
        label += "quilted in one piece";
        break;
    }
    if (request.gain > 1) label += fmt::format(", gain of {}", request.gain);
    if (request.turn > 0) label += fmt::format(", hexagons turned by up to {:.4g} degrees", 180 * request.turn);
    if (request.restored) label += ", variance restored";
    if (request.exponent) label += fmt::format(", weights to the power {}", *request.exponent);
    label[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(label[0])));
    return label;
}

std::vector<std::string> endless_shows(EndlessMethod method)
{
    std::vector<std::string> words{"exemplar", "tiling", "plane"};
    if (method == EndlessMethod::blended) words.emplace_back("gaussian");
    if (method == EndlessMethod::quilted) words.emplace_back("pieces");
    return words;
}

namespace {

/// Places are 64-bit integers, of which sums with sides of windows must not overflow.
constexpr std::int64_t farthest_pixel = std::int64_t{1} << 52;

void window_key(Keys& keys, EndlessSettings& s)
{
    std::vector<std::int64_t> window(s.window.begin(), s.window.end());
    keys.whole_numbers("window", window, -farthest_pixel, {"X", "Y", "width", "height"},
                       "the pixels that are drawn: the upper left one, y downwards, width and height");
    if (window[0] > farthest_pixel || window[1] > farthest_pixel)
        throw keys.invalid("window", "must begin within 2^52 pixels");
    for (const std::int64_t side : {window[2], window[3]})
        if (side < 1 || side > most_endless_pixels)
            throw keys.invalid("window", fmt::format("must have 1 to {} pixels along each side", most_endless_pixels));
    if (s.request.method == EndlessMethod::quilted && (window[0] != 0 || window[1] != 0))
        throw keys.invalid("window", "must begin at 0 0 for quilted: its blocks follow from those before them");
    std::ranges::copy(window, s.window.begin());
}

void endless_picture_keys(Keys& keys, EndlessSettings& s)
{
    keys.word("kind", s.request.method, endless_methods, "the method");
    keys.picture("exemplar", s.exemplar, "the picture, of any kind that OpenImageIO reads").required();
    window_key(keys, s);
    endless_keys(keys, s.request);
    check_keys_of_method(keys, s.request.method, "kind");
    check_exemplar_size(keys, s.request, s.exemplar, 0);
}

std::string endless_picture_label(const EndlessSettings& s)
{
    return endless_label(s.request, printable(s.exemplar.stem().string()));
}

DistributionResult make_endless_picture(const EndlessSettings& settings, std::uint64_t seed,
                                        const DistributionPlace& place, DistributionFiles& files)
{
    const PngPixels pixels = endless_picture(settings, seed, place);
    write_png(files.add("texture.png"), pixels);
    DistributionResult result;
    result.pictures = {{"texture.png", "A window of the texture."}};
    return result;
}

}

Kind endless_kind()
{
    return make_kind<EndlessSettings>({"", "texture endless", "texture endless", "Endless texture without tiles",
                                       "Draw an endless texture by other methods than tiles"},
                                      endless_picture_keys, endless_picture_label, make_endless_picture);
}

}
