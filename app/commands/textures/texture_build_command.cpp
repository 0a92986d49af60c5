// poissonlab texture build: texture tiles from a picture.
#include "app/commands/kind_options.hpp"
#include "base/errors/errors.hpp"
#include "experiment/run/progress.hpp"
#include "host/device/device.hpp"
#include "host/device/kernel.hpp"
#include "host/distribution/textures/texture_values.hpp"
#include "host/kinds/kinds.hpp"
#include "host/settings/distributions/texture_config.hpp"
#include "host/texture/advice/advice_words.hpp"
#include "host/texture/comparison/light_map.hpp"
#include "host/texture/exemplar_pictures.hpp"
#include "host/texture/regular/straightening.hpp"
#include "host/texture/texture_build.hpp"
#include "results/own_files.hpp"
#include "tiles/texture/texture_certificate.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdio>

namespace poissonlab {
namespace {

constexpr auto texture_build_notes =
    R"(corner: C^4 tiles by the colours of their corners, a patch of the picture a colour; pieces around the middles of
edges and in the middles of tiles cover their joints (--stages 1: in the middles of tiles only, as Ng and others do).
wang: C^4 tiles by the colours of their edges, or --tiles compact (8 tiles for two colours, 18 for three, 12 for two and
--vertical-colors 3), by quilting after Cohen and others; their corners do not always fit. With --marked-exemplar each
tile has all sixteen marks of its corners (--tiles compact: 128 for two colours), for maps; --tiles random-marks is the
half of the compact ones that is enough where marks are at random (64).
omega: --tiles 16 (the default), 16b, 4, 8 or 32 of Ng and others, over 4 colours, for scanlines.
The outermost pixels of a tile, its ring, depend on the colours that it shares alone. DIR gets atlas.png, sources.png,
exemplar.png and texture.json: see docs/texture-set.md.
With --also normal.png, which may be repeated, tiles of that picture are cut along the same curves, into atlas-normal.png,
number for number. An exemplar of 16 bits or floating-point numbers, NAME, is chosen and cut by 8 bits of sRGB; atlas-NAME
has its own numbers.
Bricks, planks and threads that are regular, also seen at an angle: --straighten makes their courses straight and a whole
number for each tile, and their joints run through. exemplar.png is the straightened picture then.
Light that differs over more than a tile is evened (--flatten off keeps it), and exemplar.png is the flattened picture then;
companions stay as they are. Seams of smooth pictures are blended (--blend off leaves them). Tiles whose light
differs more than that of squares of the picture are levelled (--level off keeps it).
Without --colors and --size the picture decides, as texture advise says; or a line says where they are against that.
  poissonlab texture build corner --exemplar gravel.png --out gravel)";

struct TextureBuildOptions : KindOptions
{
    using KindOptions::KindOptions;
    std::filesystem::path out;
};

/// A set, and what was said of its picture.
struct AdvisedTexture
{
    BuiltTexture built;
    std::vector<std::string> advice;
};

void print_built(const TextureBuildOptions& options, const AdvisedTexture& made, double seconds)
{
    if (options.is_quiet() && !options.prints_json()) return;
    const BuiltTexture& built = made.built;
    const TextureSet& set = built.set;
    const TextureCertificate proof = certify_texture(set);
    const std::optional<double> recurs = set_recurrence(set, options.seed());
    if (options.prints_json()) {
        nlohmann::ordered_json json{{"folder", printable(options.out.string())},
                                    {"tiles", set.tiles.size()},
                                    {"tile_size", set.size},
                                    {"windows", built.windows.size()},
                                    {"tile_pairs", proof.tile_pairs},
                                    {"joints", proof.joints},
                                    {"exceptions", proof.exceptions},
                                    {"seconds", seconds}};
        json["joint"] = built.is_joint;
        if (!made.advice.empty()) json["advice"] = made.advice;
        if (!built.choice.empty()) json["choice"] = built.choice;
        for (const CompanionMap& map : set.companions) json["companions"].push_back(printable(map.atlas_file));
        if (recurs) json["recurrence"] = *recurs;
        fmt::print("{}\n", json.dump(2));
        return;
    }
    fmt::print("{}: {} tiles of {} x {} pixels from {} windows, {}\n", printable(options.out.string()),
               set.tiles.size(), set.size, set.size, built.windows.size(), duration_text(seconds));
    if (!built.choice.empty()) fmt::print("{}\n", built.choice);
    fmt::print("{} pairs of tiles fit: {:.2f} joints a pair across their borders{}\n", proof.tile_pairs,
               static_cast<double>(proof.joints) / static_cast<double>(proof.tile_pairs),
               proof.exceptions == 0
                   ? ""
                   : fmt::format(", {:.2f} pixels a pair beside corners that do not fit",
                                 static_cast<double>(proof.exceptions) / static_cast<double>(proof.tile_pairs)));
    if (recurs) fmt::print("{}\n", recurrence_words(set, *recurs));
    for (const CompanionMap& map : set.companions)
        fmt::print("{}: {}, {} of {}, at the same sources\n", printable(map.atlas_file),
                   map.is_original ? "the exemplar's own numbers" : "a companion",
                   map.picture.channels.size() == 1 ? "a channel"
                                                    : fmt::format("{} channels", map.picture.channels.size()),
                   sample_types[map.picture.type]);
}

/// Smoothing is what a device does here: without it, none is opened.
HarmonicSolver harmonic_solver(const DistributionPlace& place)
{
    if (place.engine == Engine::reference) return relax_reference;
    return [device = place.device](GradientDomain& domain) { relax_on(device(), domain, default_work_group_size); };
}

/// Returns the choices that the caller left to the picture.
OpenAdvice open_advice(const TextureSettings& asked, bool is_marked)
{
    OpenAdvice open;
    open.colors = asked.are_colors_open && asked.request.kind == TextureKind::corner && !is_marked;
    open.joint = asked.request.is_joint_open && asked.request.has_corners();
    open.straighten = !asked.is_straightened && !is_marked;
    open.flatten = !asked.is_flattened && !is_marked;
    open.is_light_said = true;
    return open;
}

/// Takes what is not given from the picture, and says so before the work begins, or where a size that is given is
/// against the advice. Returns what was said.
std::vector<std::string> settle_by_picture(const TextureBuildOptions& options, TextureSettings& asked,
                                           const ExemplarPictures& pictures)
{
    const PngPixels& picture = pictures.exemplar;
    TextureAdvice advice =
        advise_texture(pictures.split > 0 ? picture_part(picture, 0, 0, pictures.split, picture.height) : picture);
    take_advice(asked.request, advice, asked.is_size_open, asked.are_colors_open);
    check(asked.request);
    if (!asked.request.joint && asked.request.rounds != TextureRequest{}.rounds)
        throw InputError(fmt::format("rounds = {}: is for tiles that are chosen together, which {} of {} x {} pixels "
                                     "are only with --joint on",
                                     asked.request.rounds, requested_tiles(asked.request).size(), asked.request.size,
                                     asked.request.size));
    advice.is_joint = asked.request.is_judged;
    const OpenAdvice open = open_advice(asked, pictures.split > 0);
    const std::string note = advice_note(advice, asked.request, open);
    std::vector<std::string> lines;
    if (asked.is_size_open)
        lines = advice_lines(advice, open);
    else if (!note.empty())
        lines.push_back(note);
    if (options.prints_json() || options.is_quiet()) return lines;
    for (const std::string& line : lines) fmt::print("{}\n", line);
    std::fflush(stdout);
    return lines;
}

/// Straightens and flattens the exemplar as asked. Adds a note if a set that is chosen together could have joints that
/// run through.
void prepare_exemplar(ExemplarPictures& pictures, const TextureSettings& asked)
{
    if (asked.is_straightened) straighten(pictures, asked.request.size);
    flatten(pictures, asked.request.size, asked.is_flattened);
    if (asked.is_straightened || !asked.request.joint) return;
    const std::string note = regularity_note(pictures.exemplar, asked.request.size);
    if (!note.empty()) pictures.notes.push_back(note);
}

AdvisedTexture built_texture(const TextureBuildOptions& options, TextureSettings asked)
{
    const DistributionPlace place = options.place();
    const auto tell = [&](const std::string& stage, std::size_t done, std::size_t total) {
        place.on_step(fmt::format("{}: {} of {}", stage, done, total));
    };
    asked.request.seed = options.seed();
    ExemplarPictures pictures = read_exemplar_pictures(asked.exemplar, asked.marked_exemplar, asked.also);
    try {
        const std::vector<std::string> advice = settle_by_picture(options, asked, pictures);
        prepare_exemplar(pictures, asked);
        asked.request.split = pictures.split;
        for (const std::string& note : pictures.notes) options.say_note(note);
        BuiltTexture built = build_texture(asked.request, pictures.exemplar, tell, harmonic_solver(place));
        add_companions(built, std::move(pictures.companions));
        for (const std::string& note : built.notes) options.say_note(note);
        if (asked.is_straightened) built.set.parameters["straighten"] = "true";
        if (pictures.is_flattened) built.set.parameters["flatten"] = "true";
        return {std::move(built), advice};
    } catch (const InputError& error) {
        throw error.moved_to({asked.exemplar.string()});
    }
}

void build_texture_tiles(const TextureBuildOptions& options)
{
    const KindSettings read = options.settings();
    check_output_folder(options.out, "texture build: ");
    const auto begin = std::chrono::steady_clock::now();
    const AdvisedTexture made = built_texture(options, read.as<TextureSettings>());
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    write_texture_set(options.out, made.built.set);
    print_built(options, made, seconds);
}

}

Command texture_build_command()
{
    const auto o = std::make_shared<TextureBuildOptions>(*find_kind("", "texture build"), "kind");
    return kind_command(o, {{"--out", &o->out, "The folder of the tiles", "DIR", required}}, texture_build_notes,
                        build_texture_tiles);
}

}
