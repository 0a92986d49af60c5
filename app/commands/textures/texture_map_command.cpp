// poissonlab texture map: an endless plane with texture tiles, or with another endless texture, in perspective.
#include "app/commands/kind_options.hpp"
#include "base/errors/errors.hpp"
#include "base/files/output_place.hpp"
#include "host/device/device.hpp"
#include "host/distribution/textures/endless_keys.hpp"
#include "host/distribution/textures/texture_run.hpp"
#include "host/sampling/sampler.hpp"
#include "host/texture/exemplar.hpp"
#include "host/texture/mapping/endless_map.hpp"
#include "host/texture/mapping/texture_map.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <utility>

namespace poissonlab {
namespace {

constexpr auto texture_map_notes =
    R"(DIR has a texture set, or is a picture. Complete sets of corner or Wang tiles are laid by a hash, anywhere; of others,
a window of --laid N x N tiles is laid in scanlines and repeated, with seams where windows meet. A picture is repeated,
or is the exemplar of an endless texture by another --method, as `texture endless` has them, with the same options, as
far as one can see; 64 x 64 pixels count as a tile. As on graphics cards, pieces of the exemplar are looked up at levels,
and what they show is blended: where a pixel sees many small pieces of a large exemplar, it shows one of them. With --laid,
a window of N x N tiles around the camera is blended first, has levels of its own, and is repeated beyond, with seams.
Quilted pictures are always such a window, from tile 0 on. The camera is above the middle of a tile, or where --start
says, and looks to the north; a --pitch of 90 looks straight down. Filters:
  nearest      one texel
  bilinear     four texels; the distance shimmers
  mipmap       between levels that fit the longer side of a pixel's footprint: no shimmer, but a blurred distance
  anisotropic  up to 16 such look-ups along it (the default)
Look-ups:
  exact        each texel through its own tile, at all levels (the default)
  packed       neighbours in the atlas, as graphics cards read them: the same up to the level that the ring allows, of
               Wang tiles but at their corners
  clamped      no neighbours: tiles become visible
  repeated     the atlas itself, side by side, for comparison; of sets without a hash, the window that was laid
Averages are of light. The same tiles lie where the program of runtime/texture_tiles.h, C, OpenCL C or GLSL, sees them.
--frames writes a fly-through: PICTURE gets a number before its suffix.
  poissonlab texture map gravel --size 1024 576 --pitch 12 --out plain.png
  poissonlab texture map gravel --frames 60 --advance 6 --out fly.png
  poissonlab texture map gravel.png --method hexagons --size 1024 576 --pitch 12 --out hexagons.png)";

constexpr std::uint32_t not_laid = std::numeric_limits<std::uint32_t>::max(); // --laid is not given
constexpr int usual_laid_root = 5;

struct TextureMapSettings
{
    EndlessRequest request; ///< the endless texture that a picture is mapped as
    TextureCamera camera;   ///< of a size and over a tile that are no keys
    std::uint32_t frames = 1;
    double advance = 0; ///< tiles
};

void texture_map_keys(Keys& keys, TextureMapSettings& s)
{
    TextureCamera& camera = s.camera;
    keys.numbers("start", camera.start, {{0, 1}}, {"X", "Y"}, "the place in the tile that the camera is above")
        .unit("tiles");
    keys.number("above", camera.above, {0.01, 10'000}, "the camera's height over the plane").unit("tiles");
    keys.number("pitch", camera.pitch, {0, 90}, "how far the camera looks below the horizon").unit("degrees");
    keys.number("yaw", camera.yaw, {-360, 360}, "how far it looks to the right of north").unit("degrees");
    keys.number("field", camera.field, {1, 150}, "what it sees from the picture's top to its bottom").unit("degrees");
    keys.word("filter", camera.filter, texture_filters, "how texels become pixels");
    keys.integer("samples", camera.samples, 1, 16, "samples of a pixel along each axis");
    keys.integer("frames", s.frames, 1, 100'000, "pictures of a fly-through");
    keys.number("advance", s.advance, {-1e6, 1e6}, "how far the camera flies ahead in all of them").unit("tiles");
    s.request.method = EndlessMethod::repeated;
    keys.word("method", s.request.method, endless_methods,
              "of a picture: the endless texture that it is the exemplar of");
    endless_keys(keys, s.request);
    check_keys_of_method(keys, s.request.method, "method");
}

struct TextureMapOptions : KindOptions
{
    using KindOptions::KindOptions;
    std::filesystem::path folder;
    std::vector<std::int64_t> size{1024, 576}, tile{0, 0};
    std::string lookup; // empty: the one that is right for the set
    std::uint32_t laid = not_laid;
};

/// Pixels of a texture without tiles that count as a tile: of the camera's height, of --tile and of --laid.
constexpr int tile_of_pixels = contract::endless_map::TILE_TEXELS;

/// Tiles from 0 whose pixels `texture endless` has as well.
constexpr std::int64_t farthest_endless_tile = std::int64_t{1} << 45;

constexpr std::int64_t most_map_pixels = 16'384;

/// The camera at its place, as large as its picture.
TextureCamera placed_camera(const TextureMapOptions& o, TextureCamera camera)
{
    if (o.size.size() != 2)
        throw InputError(fmt::format("texture map: --size {}: must be W H", fmt::join(o.size, " ")));
    if (o.tile.size() != 2)
        throw InputError(fmt::format("texture map: --tile {}: must be X Y", fmt::join(o.tile, " ")));
    for (const std::int64_t pixels : o.size)
        if (pixels < 1 || pixels > most_map_pixels)
            throw InputError(
                fmt::format("texture map: --size {}: must be an integer from 1 to {}", pixels, most_map_pixels));
    camera.width = static_cast<int>(o.size[0]);
    camera.height = static_cast<int>(o.size[1]);
    camera.tile_x = o.tile[0];
    camera.tile_y = o.tile[1];
    return camera;
}

/// Throws InputError for --laid of what is not laid in scanlines.
void check_is_laid(const TextureMapOptions& o, const char* what)
{
    if (o.laid != not_laid)
        throw InputError(fmt::format("--laid {}: is for sets without a hash, which are laid in scanlines; this is {}",
                                     o.laid, what));
}

/// The number of which --laid is the square.
int checked_laid_root(const TextureMapOptions& o)
{
    if (o.laid == not_laid) return usual_laid_root;
    for (int n = 2; n <= most_laid_root; ++n)
        if (o.laid == static_cast<std::uint32_t>(n * n)) return n;
    throw InputError(fmt::format("texture map: --laid {}: must be 4, 9, 16, 25, 36, 49 or 64", o.laid));
}

/// Exact look-ups, or those that were asked for; sets without places have one.
TextureLookup lookup_of(const TextureMapOptions& o, const TextureSet& set)
{
    if (has_places(set)) return o.lookup.empty() ? TextureLookup::exact : *texture_lookups.find(o.lookup);
    if (!o.lookup.empty() && o.lookup != texture_lookups[TextureLookup::repeated])
        throw InputError(
            fmt::format("--lookup {}: is for complete sets of corner or Wang tiles, which a hash lays; must "
                        "be repeated",
                        o.lookup));
    return TextureLookup::repeated;
}

void check_endless_tile(const TextureCamera& camera)
{
    const auto [low, high] = std::minmax(camera.tile_x, camera.tile_y);
    if (low < -farthest_endless_tile || high > farthest_endless_tile)
        throw InputError(fmt::format("--tile {} {}: must be within 2^45 tiles", camera.tile_x, camera.tile_y));
}

/// The window of an endless texture around the camera's tile, which moves to where it lies in the window. Quilted
/// pictures begin at 0.
TexturePyramid endless_pyramid(const TextureMapOptions& o, const EndlessRequest& request,
                               const DistributionPlace& place, TextureCamera& camera)
{
    const int root = checked_laid_root(o), tiles = root * root, side = tiles * tile_of_pixels;
    EndlessSettings settings{request, o.folder, {0, 0, side, side}};
    if (request.method != EndlessMethod::quilted) {
        check_endless_tile(camera);
        const std::int64_t west = camera.tile_x - tiles / 2, south = camera.tile_y - tiles / 2;
        settings.window[0] = west * tile_of_pixels;
        settings.window[1] = -(south + tiles) * tile_of_pixels; // tiles count to the north, pixels to the south
        camera.tile_x = camera.tile_y = tiles / 2;
    }
    return picture_pyramid(endless_picture(settings, o.seed(), place), root);
}

/// A plane that is mapped: what a view of it takes, and its light. It refers to the place where it is drawn.
struct MappedPlane
{
    int channels = 1;
    std::function<DeviceMemory(const TextureView&)> memory;
    std::function<std::vector<float>(const TextureView&)> picture;
};

MappedPlane plane_of(TexturePyramid of, TextureLookup lookup, const DistributionPlace& place)
{
    const auto pyramid = std::make_shared<const TexturePyramid>(std::move(of));
    return {pyramid->channels, [pyramid](const TextureView& view) { return texture_map_memory(*pyramid, view); },
            [pyramid, lookup, &place](const TextureView& view) {
                return place.engine == Engine::opencl
                           ? map_texture(place.device(), *pyramid, lookup, view, default_work_group_size)
                           : reference_map_texture(*pyramid, lookup, view);
            }};
}

MappedPlane plane_of(MappedEndless of, const TextureCamera& camera, const DistributionPlace& place)
{
    const auto mapped = std::make_shared<const MappedEndless>(std::move(of));
    const auto origin = mapped->origin(camera.tile_x, camera.tile_y);
    return {mapped->texture.channels, [mapped](const TextureView& view) { return endless_map_memory(*mapped, view); },
            [mapped, origin, &place](const TextureView& view) {
                return place.engine == Engine::opencl
                           ? map_endless(place.device(), *mapped, origin, view, default_work_group_size)
                           : reference_map_endless(*mapped, origin, view);
            }};
}

/// A picture has no other look-up than to be repeated.
MappedPlane plane_of_picture(const TextureMapOptions& o, EndlessRequest request, const DistributionPlace& place,
                             TextureCamera& camera)
{
    if (!o.lookup.empty() && o.lookup != texture_lookups[TextureLookup::repeated])
        throw InputError(fmt::format("--lookup {}: is for texture sets; must be repeated", o.lookup));
    if (request.method == EndlessMethod::quilted || o.laid != not_laid)
        return plane_of(endless_pyramid(o, request, place, camera), TextureLookup::repeated, place);
    check_endless_tile(camera);
    request.seed = o.seed();
    return plane_of(mapped_endless(request, read_exemplar(o.folder)), camera, place);
}

/// Throws InputError for --method beside a texture set.
void check_has_no_method(const EndlessRequest& request)
{
    if (request.method != EndlessMethod::repeated)
        throw InputError(
            fmt::format("--method {}: is for pictures; this is a texture set", endless_methods[request.method]));
}

MappedPlane plane_of_set(const TextureMapOptions& o, const EndlessRequest& request, const DistributionPlace& place,
                         int laid_root)
{
    const TextureSet set = read_texture_set(o.folder);
    check_has_no_method(request);
    const TextureLookup lookup = lookup_of(o, set);
    if (!has_places(set)) return plane_of(laid_pyramid(set, o.seed(), laid_root), lookup, place);
    check_is_laid(o, "a complete set of corner or Wang tiles");
    return plane_of(texture_pyramid(set, o.seed()), lookup, place);
}

/// One of so many pictures: "fly-00007.png" of "fly.png".
std::filesystem::path frame_file(const std::filesystem::path& out, std::uint32_t frame, std::uint32_t frames)
{
    if (frames == 1) return out;
    std::filesystem::path file = out;
    file.replace_filename(fmt::format("{}-{:05}{}", out.stem().string(), frame, out.extension().string()));
    return file;
}

void map_texture_plane(const TextureMapOptions& o)
{
    const auto settings = o.settings().as<TextureMapSettings>();
    TextureCamera camera = placed_camera(o, settings.camera);
    if (!o.lookup.empty()) value_of_word("texture map", "--lookup", o.lookup, texture_lookups);
    const int laid_root = checked_laid_root(o);
    const DistributionPlace place = o.place();
    const std::uint32_t frames = settings.frames;
    if (frames > 1 && names_standard_output(o.out))
        throw InputError(
            fmt::format("texture map: --out {}: standard output takes one frame, not {}", o.out.string(), frames));
    const std::filesystem::path out = checked_output("texture map", "--out", o.out, {{".png"}});
    const MappedPlane plane = [&] {
        try {
            std::error_code unknown;
            if (!std::filesystem::exists(o.folder, unknown)) throw InputError("no such picture, and no such folder");
            if (std::filesystem::is_regular_file(o.folder, unknown))
                return plane_of_picture(o, settings.request, place, camera);
            return plane_of_set(o, settings.request, place, laid_root);
        } catch (const InputError& error) {
            if (!error.place().file.empty()) throw;
            throw error.moved_to({o.folder.string()});
        }
    }();
    if (place.engine == Engine::opencl)
        check_fits(fmt::format("texture map: {}", o.folder.string()), plane.memory(view_of(camera)),
                   place.device().info());
    for (std::uint32_t frame = 0; frame < frames; ++frame) {
        camera.forward = settings.advance * frame / frames;
        const PngPixels pixels =
            encoded_pixels(plane.picture(view_of(camera)), camera.width, camera.height, plane.channels);
        write_png(frame_file(out, frame, frames), pixels);
        if (place.on_step) place.on_step(fmt::format("frame {} of {}", frame + 1, frames));
    }
    if (!o.prints_json()) return;
    const nlohmann::ordered_json json{{"file", printable(frame_file(out, 0, frames).string())},
                                      {"frames", frames},
                                      {"width", camera.width},
                                      {"height", camera.height},
                                      {"channels", plane.channels}};
    fmt::print("{}\n", json.dump(2));
}

}

Command texture_map_command()
{
    static const Kind mapped =
        described_command("texture map", "Draw an endless plane of texture tiles in perspective", texture_map_keys);
    const auto o = std::make_shared<TextureMapOptions>(mapped);
    return {
        "map", mapped.summary,
        joined({{{"DIR", &o->folder, "The folder of a texture set, from texture build, or a picture"},
                 allowing({"--size", &o->size, "Pixels of the picture; default: 1024 576", "W H", optional, 2},
                          Integers{1, most_map_pixels}),
                 {"--tile", &o->tile, "The tile below the camera; default: 0 0", "X Y", optional, 2},
                 {"--lookup", &o->lookup, "exact, packed, clamped or repeated", "NAME"},
                 {"--laid", &o->laid,
                  "For sets without a hash: tiles along a side of the window, 4, 9, 16, 25, 36, 49 or 64; default: 25. "
                  "For "
                  "pictures: such a window instead of the plane",
                  "N"},
                 {"--out", &o->out, "The picture (.png)", "PICTURE", required}},
                o->options()}),
        texture_map_notes, action_on(o, map_texture_plane)};
}

}
