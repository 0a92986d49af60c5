// poissonlab texture endless: a window of an endless texture by other methods than tiles.
#include "app/commands/kind_options.hpp"
#include "base/errors/errors.hpp"
#include "host/distribution/textures/texture_run.hpp"
#include "host/kinds/kinds.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace poissonlab {
namespace {

constexpr auto texture_endless_notes =
    R"(Methods that engines use today where tiles could be, for comparison at the same exemplar; [[texture]] measures them
as well. Every pixel of the plane follows from its place and the seed, X to the right and Y down, a texel a pixel.
  repeated  the exemplar side by side
  offsets   squares at random places of the exemplar, smoothly blended at their borders (Quilez): four texels a pixel
  hexagons  hexagons at random places, whose weights have a power and follow lightness (Mikkelsen 2022): three texels.
            --gain 2 has more contrast between weights, --restored gives back the variance that blending takes, and by
            --turn 1 hexagons turn by any angle
  blended   by-example noise (Heitz and Neyret 2018, Deliot and Heitz 2019): three texels of a Gaussian exemplar at equal
            variance, and a table back for each channel. --exponent 4 blends less (Burley 2019)
  quilted   blocks that fit, cut along paths (Efros and Freeman 2001): no function of the plane, X and Y are 0
The exemplar need not fit to itself: pieces lie inside of it, unless it is --tileable. Nothing is mirrored.
  poissonlab texture endless hexagons --exemplar gravel.png --window 0 0 1920 1080 --out plain.png
  poissonlab texture endless blended --exemplar gravel.png --seed 3 --out noise.png)";

struct TextureEndlessOptions : KindOptions
{
    using KindOptions::KindOptions;
    std::filesystem::path out;
};

void draw_endless_texture(const TextureEndlessOptions& o)
{
    const KindSettings read = o.settings();
    const std::filesystem::path out = checked_output("texture endless", "--out", o.out, {{".png"}});
    const PngPixels pixels = endless_picture(read.as<EndlessSettings>(), o.seed(), o.place());
    write_png(out, pixels);
    if (!o.prints_json()) return;
    const nlohmann::ordered_json json{{"file", printable(o.out.string())},
                                      {"width", pixels.width},
                                      {"height", pixels.height},
                                      {"channels", pixels.channels}};
    fmt::print("{}\n", json.dump(2));
}

}

Command texture_endless_command()
{
    const auto o = std::make_shared<TextureEndlessOptions>(*find_kind("", "texture endless"), "kind");
    return kind_command(o, {{"--out", &o->out, "The picture (.png)", "PICTURE", required}}, texture_endless_notes,
                        draw_endless_texture);
}

}
