// A table [[texture]]: texture tiles, how well they fit over several sets, and pictures of the first one.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, sections 5.3 and 5.4.
#include "host/distribution/textures/texture_run.hpp"
#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"
#include "host/device/device.hpp"
#include "host/distribution/textures/plane_picture.hpp"
#include "host/distribution/textures/texture_exemplar.hpp"
#include "host/distribution/textures/texture_pictures.hpp"
#include "host/distribution/textures/texture_values.hpp"
#include "host/texture/exemplar.hpp"
#include "host/texture/exemplar_pictures.hpp"
#include "host/texture/texture_build.hpp"
#include "tiles/texture/texture_tiling.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {
namespace {

/// Makes the pictures that a table asks for.
class TextureShow
{
public:
    TextureShow(const TextureSettings& settings, const BuiltTexture& built, const DistributionPlace& place,
                DistributionFiles& files, DistributionResult& result)
        : settings_(settings), built_(built), set_(built.set), place_(place), files_(files), result_(result)
    {}

    void add(const std::string& word)
    {
        if (word == "exemplar") result_.pictures.push_back({"exemplar.png", "The exemplar."});
        if (word == "set")
            result_.pictures.push_back(
                {"atlas.png",
                 set_.is_complete() ? "All tiles, packed: neighbours fit, and so do opposite sides." : "All tiles."});
        if (word == "windows")
            write("windows.png", window_picture(set_.exemplar, built_.windows, built_.patches),
                  "The windows that tiles show: patches or samples in colours, new pieces in white.");
        if (word == "steps" && set_.has_corners())
            write("steps.png", step_picture(built_),
                  "A tile: four patches, the part that is cut out, the tile with a new piece over the seam, and the "
                  "same with "
                  "new pieces in grey.");
        if (word == "seams")
            write("seams.png", seam_picture(set_), "Seams of all tiles, where sources are no neighbours.");
        if (word == "pieces")
            write("pieces.png", atlas_of_pieces(), "The source map: colours tell windows of the exemplar apart.");
        if (word == "tiling") write("tiling.png", window_of(set_.values, set_.exemplar.channels), "A tiling.");
        if (word == "marks" && set_.classes == 2)
            write("marks.png", marks_picture(set_), "A tile with all marks of its corners: marked ones have dots.");
        if (word == "tiling-marks" && set_.classes == 2)
            write("tiling-marks.png", marked_window_picture(set_, shown_window()),
                  "Its corners: marked ones have dots.");
        if (word == "tiling-pieces")
            write("tiling-pieces.png", window_of(piece_values(set_), 3), "Its windows of the exemplar.");
        if (word == "gradients") add_gradients();
        if (word == "levels" && is_mapped())
            write("levels.png", level_picture(texture_pyramid(set_, settings_.request.seed)),
                  fmt::format("Levels of the atlas, in light. Look-ups in it are exact up to level {}{}.",
                              exact_level(), set_.has_corners() ? "" : ", but at corners of tiles"));
        if (word == "plane" && is_power_of_two())
            write("plane.png", plane_picture(set_, settings_.request.seed, place_), plane_caption(set_));
    }

private:
    /// True if graphics cards can map it: see texture_pyramid().
    bool is_mapped() const { return has_places(set_) && is_power_of_two(); }
    bool is_power_of_two() const { return (set_.size & (set_.size - 1)) == 0; }

    int exact_level() const
    {
        int level = 0;
        while (2 << level <= set_.ring) ++level;
        return level;
    }

    void write(const std::string& name, const PngPixels& pixels, const std::string& caption)
    {
        write_png(files_.add(name), pixels);
        result_.pictures.push_back({name, caption});
    }

    /// The tiling that is shown: with the marks, where there are some.
    TextureWindow shown_window() const
    {
        const TileWindow window{0, 0, settings_.columns, settings_.rows};
        if (settings_.marks.empty()) return texture_window(set_, window, settings_.request.seed);
        return marked_texture_window(
            set_, window, settings_.request.seed,
            corner_marks(read_exemplar(settings_.marks, AlphaUse::covers), settings_.columns, settings_.rows));
    }

    PngPixels window_of(std::span<const std::uint8_t> values, int channels) const
    {
        return texture_window_pixels(set_, shown_window(), values, channels);
    }

    PngPixels atlas_of_pieces() const
    {
        TextureSet pieces = set_;
        pieces.values = piece_values(set_);
        pieces.exemplar.channels = 3;
        return atlas_of(pieces);
    }

    void add_gradients()
    {
        const PngPixels tiling = texture_window_pixels(
            set_, texture_window(set_, {0, 0, measured_tiles, measured_tiles}, settings_.request.seed), set_.values,
            set_.exemplar.channels);
        write("gradients.png", step_map_picture(step_map(tiling, set_.exemplar, set_.size)),
              "Differences between neighbours by their place in the tile, over 16 x 16 tiles: grey is the exemplar's "
              "mean, "
              "white twice as much. Seams are lighter lines.");
    }

    const TextureSettings& settings_;
    const BuiltTexture& built_;
    const TextureSet& set_;
    const DistributionPlace& place_;
    DistributionFiles& files_;
    DistributionResult& result_;
};

std::vector<std::string> facts_of(const TextureSettings& settings, const BuiltTexture& built)
{
    const TextureSet& set = built.set;
    std::vector<std::string> facts{
        fmt::format("{} {} tiles of {} x {} pixels", set.tiles.size(), texture_kinds[set.kind], set.size, set.size),
        fmt::format("exemplar of {} x {}", set.exemplar.width, set.exemplar.height),
        fmt::format("{} windows", built.windows.size()), fmt::format("ring of {}", set.ring)};
    if (settings.sets > 1) facts.push_back(fmt::format("measures over {} sets", settings.sets));
    return facts;
}

/// The words that tell placements and exemplars apart.
std::vector<DistributionParameter> parameters_for_claims(const TextureSettings& settings, const TextureSet& set)
{
    std::vector<DistributionParameter> parameters{
        {"exemplar", settings.pattern.empty() ? settings.exemplar.stem().string() : "pattern of " + settings.pattern},
        {"kind", texture_kinds[settings.request.kind]},
        {"colors", std::to_string(settings.request.colors.horizontal)},
        {"size", std::to_string(settings.request.size)},
        {"smooth", settings.request.smooth ? "true" : "false"},
        {"overlap", fmt::format("{}", settings.request.overlap)},
    };
    if (!settings.marked_exemplar.empty())
        parameters.push_back({"marked_exemplar", settings.marked_exemplar.stem().string()});
    for (const char* key : {"straighten", "flatten", "blend", "level"})
        if (set.parameters.contains(key)) parameters.push_back({key, set.parameters.at(key)});
    for (const auto& [key, value] : parameters_of(settings.request)) {
        const auto is_there = [&](const DistributionParameter& parameter) { return parameter.key == key; };
        if (std::ranges::none_of(parameters, is_there)) parameters.push_back({key, value});
    }
    return parameters;
}

/// Facts, files and pictures of a set.
void add_set(const TextureSettings& settings, const BuiltTexture& built, const DistributionPlace& place,
             DistributionFiles& files, DistributionResult& result)
{
    result.facts = facts_of(settings, built);
    write_texture_files([&](const std::string& name) { return files.add(name); }, built.set);
    for (const char* name : {"texture.json", "atlas.png", "sources.png", "exemplar.png"})
        result.files.emplace_back(name);
    for (const CompanionMap& map : built.set.companions)
        for (const std::string& name : {map.atlas_file, map.picture_file}) result.files.emplace_back(name);
    TextureShow show(settings, built, place, files, result);
    for (const std::string& word : settings.show) show.add(word);
}

}

DistributionResult make_texture(const TextureSettings& asked, std::uint64_t seed, const DistributionPlace& place,
                                DistributionFiles& files)
{
    if (asked.endless) return make_endless(asked, seed, place, files);
    TextureSettings settings = asked;
    settings.request.seed = seed; // of the first set
    const ExemplarPictures pictures = texture_exemplar(settings, seed, place);
    const HarmonicSolver solve = [&](GradientDomain& domain) {
        if (place.engine == Engine::reference)
            relax_reference(domain);
        else
            relax_on(place.device(), domain, default_work_group_size);
    };
    DistributionResult result;
    std::vector<TextureValues> values;
    std::vector<DistributionNumber> times;
    for (int number = 0; number < settings.sets; ++number) {
        TextureRequest request = settings.request;
        request.seed += static_cast<std::uint64_t>(number);
        request.split = pictures.split;
        const auto tell = [&](const std::string& stage, std::size_t done, std::size_t total) {
            stop_if_interrupted();
            if (place.on_step) place.on_step(fmt::format("set {}, {}: {} of {}", number + 1, stage, done, total));
        };
        BuiltTexture built = build_texture(request, pictures.exemplar, tell, solve);
        // Measures are means over sets of one construction: that of the first.
        settings.request.joint = built.is_joint;
        settings.request.is_judged = false;
        values.push_back(tile_values(built.set, request.seed));
        if (settings.is_compared)
            add_comparison(built.set.exemplar, square_of_tiles(built.set, request.seed), compared_tiles * request.size,
                           values.back());
        if (number > 0) continue;
        add_companions(built, pictures.companions);
        if (settings.is_straightened) built.set.parameters["straighten"] = "true";
        if (pictures.is_flattened) built.set.parameters["flatten"] = "true";
        result.parameters = parameters_for_claims(settings, built.set);
        add_set(settings, built, place, files, result);
        if (!built.choice.empty()) result.facts.push_back(built.choice);
        result.facts.insert(result.facts.end(), pictures.notes.begin(), pictures.notes.end());
        result.facts.insert(result.facts.end(), built.notes.begin(), built.notes.end());
        if (settings.has_timing && place.engine == Engine::opencl) {
            times = time_numbers(place.device(), endless_tiles(built.set, request.seed));
            times.push_back(
                time_number("frames", frames_a_second(place.device(), texture_pyramid(built.set, request.seed))));
        }
    }
    result.numbers = texture_numbers(values);
    result.numbers.insert(result.numbers.end(), times.begin(), times.end());
    return result;
}

}
