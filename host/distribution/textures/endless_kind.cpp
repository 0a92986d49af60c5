// The kind of `texture endless`, which draws a window of an endless texture without tiles.
#include "base/errors/errors.hpp"
#include "host/distribution/textures/endless_keys.hpp"
#include "host/distribution/textures/texture_run.hpp"
#include "host/kinds/kinds.hpp"
#include "host/texture/endless/quilting.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace poissonlab {
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
