// poissonlab texture build: texture tiles from a picture.
#include "app/commands/command.hpp"
#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"
#include "host/config/nearest_key.hpp"
#include "host/device/device.hpp"
#include "host/device/kernel.hpp"
#include "host/run/progress.hpp"
#include "host/sampling/sampler.hpp"
#include "host/texture/exemplar.hpp"
#include "host/texture/texture_build.hpp"
#include "tiles/texture/texture_certificate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>

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
  poissonlab texture build corner --colors 3 --exemplar gravel.png --size 64 --out gravel)";

constexpr double automatic_core = -1e300;

struct TextureBuildOptions
{
    std::string kind; ///< "corner", "wang" or "omega"
    std::uint32_t colors = 0;
    std::uint32_t vertical_colors = 0; ///< 0: the same
    std::filesystem::path exemplar;
    std::filesystem::path marked_exemplar; ///< empty: none
    std::uint32_t size = 0;
    std::filesystem::path out;
    std::string tiles;
    std::vector<std::int64_t> ring, diversity; ///< none or one
    std::uint32_t stages = 3;
    std::uint32_t candidates = 8;
    std::uint32_t attempts = 100;
    std::string weight = "gradient";
    std::string cut = "min-cut";
    double core = automatic_core;
    double overlap = 0.125;
    bool smooth = false;
    std::uint64_t seed = 1;
    std::string engine = "opencl";
    std::string device;
    bool quiet = false;
};

template <class Table>
auto value_of_word(const Table& table, const std::string& what, const std::string& word)
{
    const auto value = table.find(word);
    if (!value)
        throw InputError(fmt::format("texture build: {} \"{}\": unknown{} (known: {})", what, word,
                                     did_you_mean(word, table.all()), fmt::join(table.all(), ", ")));
    return *value;
}

/// Numbers of options are checked as those of the request, which are ints.
int as_int(std::int64_t value) { return static_cast<int>(std::clamp<std::int64_t>(value, INT32_MIN, INT32_MAX)); }

TextureRequest checked_request(const TextureBuildOptions& o)
{
    TextureRequest request;
    request.kind = value_of_word(texture_kinds, "kind", o.kind);
    request.colors = {o.colors, o.vertical_colors == 0 ? o.colors : o.vertical_colors};
    request.tiles = o.tiles;
    request.size = as_int(o.size);
    if (!o.ring.empty()) request.ring = as_int(o.ring[0]);
    if (!o.diversity.empty()) request.diversity = as_int(o.diversity[0]);
    request.stages = as_int(o.stages);
    request.candidates = as_int(o.candidates);
    request.attempts = as_int(o.attempts);
    request.weight = value_of_word(seam_weights, "--weight", o.weight);
    request.cut = value_of_word(quilting_cuts, "--cut", o.cut);
    if (o.core != automatic_core) request.core = o.core;
    request.overlap = o.overlap;
    request.smooth = o.smooth;
    if (!o.marked_exemplar.empty()) request.split = 1; // until the pictures are read
    request.seed = o.seed;
    try {
        check(request);
    } catch (const InputError& error) {
        throw error.moved_to({"texture build"});
    }
    return request;
}

void check_folder(const std::filesystem::path& folder)
{
    std::error_code unknown;
    if (std::filesystem::exists(folder, unknown) && !std::filesystem::is_directory(folder, unknown))
        throw InputError(fmt::format("texture build: --out {}: is no folder", folder.string()));
}

void print_built(const TextureBuildOptions& options, const BuiltTexture& built, double seconds)
{
    const TextureSet& set = built.set;
    const TextureCertificate proof = certify_texture(set);
    fmt::print("{}: {} tiles of {} x {} pixels from {} windows, {}\n", printable(options.out.string()),
               set.tiles.size(), set.size, set.size, built.windows.size(), duration_text(seconds));
    fmt::print("{} pairs of tiles fit: {:.2f} joints a pair across their borders{}\n", proof.tile_pairs,
               static_cast<double>(proof.joints) / static_cast<double>(proof.tile_pairs),
               proof.exceptions == 0
                   ? ""
                   : fmt::format(", {:.2f} pixels a pair beside corners that do not fit",
                                 static_cast<double>(proof.exceptions) / static_cast<double>(proof.tile_pairs)));
}

/// Smoothing is what a device does here: without it, none is opened.
HarmonicSolver harmonic_solver(const TextureBuildOptions& options)
{
    if (value_of_word(engines, "--engine", options.engine) == Engine::reference) return relax_reference;
    return [name = options.device](GradientDomain& domain) {
        Device device = Device::open(name);
        relax_on(device, domain, default_work_group_size);
    };
}

void build_texture_tiles(const TextureBuildOptions& options)
{
    TextureRequest request = checked_request(options);
    check_folder(options.out);
    const HarmonicSolver solver = harmonic_solver(options);
    PngPixels exemplar = read_exemplar(options.exemplar);
    if (!options.marked_exemplar.empty()) {
        request.split = exemplar.width;
        exemplar = side_by_side(exemplar, read_exemplar(options.marked_exemplar));
    }
    Progress progress(Progress::detect(options.quiet));
    const auto begin = std::chrono::steady_clock::now();
    const BuiltTexture built = [&] {
        try {
            const auto tell = [&](const std::string& stage, std::size_t done, std::size_t total) {
                stop_if_interrupted();
                progress.step(fmt::format("{}: {} of {}", stage, done, total));
            };
            return build_texture(request, exemplar, tell, solver);
        } catch (const InputError& error) {
            throw error.moved_to({options.exemplar.string()});
        }
    }();
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    write_texture_set(options.out, built.set);
    progress.finish();
    if (!options.quiet) print_built(options, built, seconds);
}

}

Command texture_build_command()
{
    const auto o = std::make_shared<TextureBuildOptions>();
    return {
        "build",
        "Make texture tiles from a picture",
        {{"KIND", &o->kind, "corner, wang or omega"},
         allowing({"--colors", &o->colors, "Number of colours; 4 for omega tiles", "C", required},
                  integers(2, most_texture_colors)),
         {"--exemplar", &o->exemplar, "The picture, of any kind that OpenImageIO reads", "FILE", required},
         {"--marked-exemplar", &o->marked_exemplar,
          "The picture around marked corners; those of corner tiles have the second half of the colours", "FILE"},
         allowing({"--size", &o->size, "The side of a tile in pixels, at least twice that of what the picture shows",
                   "T", required},
                  integers(least_tile_pixels, most_tile_pixels)),
         {"--out", &o->out, "The folder of the tiles", "DIR", required},
         {"--tiles", &o->tiles, "Which tiles, see below", "NAME"},
         allowing(
             {"--vertical-colors", &o->vertical_colors, "Of compact Wang tiles: the number for vertical edges", "C"},
             integers(2, most_texture_colors)),
         allowing(
             {"--ring", &o->ring, "Pixels at the border that depend on shared colours alone; default: T / 16", "W"},
             "an integer from 0 to T / 5 - 1"),
         allowing(
             {"--stages", &o->stages, "3 (the default), 1: without pieces around edges, or 0: without new pieces", "N"},
             "0, 1 or 3"),
         {"--overlap", &o->overlap,
          "Of Wang tiles and of 0 stages: half of the band in which samples overlap, in tiles; default: 0.125", "B"},
         allowing({"--candidates", &o->candidates, "Windows that are cut for a piece; default: 8", "K"},
                  integers(1, most_texture_candidates)),
         allowing({"--diversity", &o->diversity,
                   "Pixels between the middles of any two windows; default: T / 4, or what is sure to fit", "D"},
                  "an integer from 0 to T"),
         {"--weight", &o->weight, "Of cuts: gradient (the default), or plain differences", "NAME"},
         {"--cut", &o->cut, "Of Wang tiles: min-cut (the default), or path", "NAME"},
         {"--core", &o->core,
          "The radius of a disk that the middle of a tile covers, in tiles; default: 0.3, with one stage 0", "R"},
         allowing({"--attempts", &o->attempts,
                   "Sets of patches that are drawn, of which the best is taken; default: 100", "N"},
                  integers(1, most_texture_attempts)),
         {"--smooth", &o->smooth,
          "Give new pieces the colours around them; Wang tiles, as Ng tried, get seams from it"},
         {"--seed", &o->seed, "Everything random follows from it; default: 1", "S"},
         {"--engine", &o->engine, "Of smoothing: opencl (the default), or reference", "NAME"},
         {"--device", &o->device, "The OpenCL device: part of its name, or its number", "NAME"},
         {"--quiet", &o->quiet, "Print nothing but errors"}},
        texture_build_notes,
        action_on(o, build_texture_tiles)};
}

}
