// poissonlab analyze: point sets made elsewhere, through the same analysis and report.
#include "app/commands/class_series.hpp"
#include "app/commands/command.hpp"
#include "app/commands/core/finish_report.hpp"
#include "base/crew/thread_limit.hpp"
#include "base/errors/errors.hpp"
#include "base/files/file_kind.hpp"
#include "base/files/text_lines.hpp"
#include "base/images/raw_picture.hpp"
#include "base/text/decimal_commas.hpp"
#include "experiment/config/overrides.hpp"
#include "experiment/config/plan.hpp"
#include "experiment/run/make_experiment.hpp"
#include "experiment/run/runner.hpp"
#include "experiment/series/imported_points.hpp"
#include "experiment/series/region_points.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace poissonlab {
namespace {

constexpr auto analyze_notes =
    R"(Each FILE has one realization, or several: text (one point a line, coordinates in [0,1) separated by blanks;
a line with # alone separates realizations), CSV (columns x, y and z by name), PLY, NumPy .npy, HDF5 or UTK .bin. All
realizations must have as many points. Of a snapshot in several files, one is named: all are read.
Other ranges of coordinates: --domain, or a comment before the points, `# domain 0:512` (PLY: `comment domain 0:512`),
with a range for each axis where the sides of a periodic box differ: `# domain 0:2 0:1`.
  poissonlab analyze set-*.dat --label "My method" --out mine
  poissonlab analyze lamps.csv --region roads.geojson --along
  poissonlab analyze points.csv --surface bunny.obj
  poissonlab analyze trees.csv --classes species --region park.geojson
A picture is measured as a mask of thresholds, for dithering or as a texture of blue noise: the power of its values,
their histogram, and the pixels below thresholds.
  poissonlab analyze blue-noise.png --channel R
--set takes the keys of a config's [analysis] that are about the analysis:
  --set analysis.zone_plate=true      sample the zone plate (2D; made for 262,144 points)
  --set analysis.window=true          the sets are windows, not tori: no distance goes across their borders (2D:
                                      --periodic no corrects spectra and curves for the border as well)
  --set analysis.tiles=8              the sets are made of 8 x 8 tiles: report their lattice peaks
  --set analysis.box=[2,1]            the sets lie in a periodic box of these sides, with coordinates over them
  --set analysis.envelope=99          with --region: so many random sets are measured beside (default 39)
  --set analysis.tapers=8             with --region: the spectrum is the mean by so many orthogonal tapers
  --set analysis.eigenfunctions=20000 with --surface: how many eigenfunctions of the mesh measure the spectrum
  --set analysis.density=age.png      with --region: what points follow, a picture or a formula over the region's box
  --set analysis.spectrum_size=2048   frequencies along each axis; also spectrum=exact, volume=true (3D))";

constexpr std::uint32_t no_type = 99; // of particles

struct AnalyzeOptions
{
    std::vector<std::filesystem::path> files;
    std::filesystem::path out; ///< empty: out/<label>
    std::string label;
    std::string domain; ///< as for parse_domain(); empty: what the files say
    std::uint32_t particles = no_type;
    std::string region;   ///< as for read_region(); empty: sets fill their square
    bool along = false;   ///< whether points lie on the region's lines
    std::string surface;  ///< the mesh that points lie on; empty: they lie on none
    std::string classes;  ///< the column that has the class of each point; empty: points have none
    std::string channel;  ///< of a picture
    std::string periodic; ///< yes or no; empty: what the closest pairs say
    std::vector<std::string> overrides;
    bool gallery = false;
    bool in_pieces = false;
    int threads = 0;
    bool quiet = false;
    std::string command;
};

/// Messages about files call the options by these words.
constexpr PointOptions option_words{.domain = "--domain {}:{}",
                                    .region = "--region 'rectangle {} {} {} {}'",
                                    .crs = "--set analysis.crs=EPSG:4326",
                                    .particles = "--particles {}"};

/// An option as the key of [analysis] that it stands for.
ConfigTable entry_of(const char* option, const char* key, decltype(ConfigNode::value) value, const std::string& text)
{
    ConfigTable entries(1);
    entries.front().key = key;
    ConfigNode& node = entries.front().node;
    node.value = std::move(value);
    node.location.file = fmt::format("analyze: {}", option);
    node.location.is_argument = true;
    node.text = text;
    return entries;
}

/// The keys of [analysis] that --set gives. overridden_region() refuses what else there is.
ConfigTable keys_of_set(const std::vector<std::string>& overrides)
{
    ConfigTable top{{"analysis", {ConfigTable{}, {}, {}}}};
    apply_overrides(top, overrides);
    const auto* keys = find(top, "analysis")->get_if<ConfigTable>();
    return keys ? *keys : ConfigTable{};
}

/// True where --set asks for measures that sets in regions do not have.
bool has_measures_of_squares(const ConfigTable& set)
{
    return find(set, "window") || find(set, "tiles") || find(set, "zone_plate");
}

/// Sets that are not periodic are measured as sets in the square as a region, whose border is corrected for. Windows,
/// whose border leaves a cross in the spectrum, are what else can be: in space, on the disk, and with measures that
/// regions do not have.
bool is_measured_in_square(const Experiment& experiment, const ConfigTable& set)
{
    return experiment.dimension == 2 && experiment.series.front().strips.empty() && !has_measures_of_squares(set);
}

ConfigTable window_entry(const Experiment& experiment, const ConfigTable& set)
{
    if (is_measured_in_square(experiment, set))
        return entry_of("--periodic", "region", std::string(unit_square_region), "no");
    return entry_of("--periodic", "window", true, "no");
}

/// The square or rectangle of a typed domain as a region, in which sets keep their units.
std::string rectangle_of(const PointDomain& domain)
{
    return fmt::format("rectangle {} {} {} {}", domain[0].low, domain[1].low, domain[0].high, domain[1].high);
}

/// The box of sets whose domain has sides that differ.
ConfigTable box_entry(const AnalyzeOptions& options, const std::vector<double>& sides)
{
    if (options.periodic == "no")
        throw InputError(sides.size() == 3
                             ? "analyze: --periodic no: sets in space can be measured without wrapping in cubes only"
                             : "analyze: --periodic no cannot be combined with a domain of a file whose sides differ: "
                               "give it as --region, such as \"rectangle 0 0 2 1\"");
    ConfigList list;
    for (const double side : sides) list.push_back({side, {}, fmt::format("{}", side)});
    ConfigTable entries = entry_of("--domain", "box", list, {});
    if (options.domain.empty()) // the file says it
        entries.front().node.location.file = printable(options.files.front().string()) + ": its box";
    return entries;
}

void check_region_options(const AnalyzeOptions& options, const ConfigTable& set)
{
    const ConfigNode* region = find(set, "region");
    if (region && !options.region.empty())
        throw InputError("analyze: " + region->location.file + ": cannot be combined with --region");
    if (options.periodic.empty()) return;
    if (options.periodic != "yes" && options.periodic != "no")
        throw InputError("analyze: --periodic " + options.periodic + ": must be yes or no");
    if (region || !options.region.empty())
        throw InputError(
            fmt::format("analyze: --periodic cannot be combined with {}: nothing goes around a torus there",
                        region ? region->location.file : "--region"));
}

/// The experiment of a config that the user has not written and whose lines say nothing.
Experiment experiment_of_text(const std::string& text)
{
    const std::string name = "analyze";
    try {
        return make_experiment(parse_config(text, name), "", 0);
    } catch (const InputError& error) {
        if (error.place().file != name) throw;
        throw error.moved_to({name});
    }
}

std::string quoted(const std::string& text) { return nlohmann::json(text).dump(); }

void check_printable(const std::string& typed)
{
    if (printable(typed) != typed)
        throw InputError(
            fmt::format("analyze: {}: names of files, labels and channels must be printable UTF-8", printable(typed)));
}

void check_printable(const AnalyzeOptions& options)
{
    for (const std::string& typed : {options.files.front().string(), options.label, options.channel, options.region,
                                     options.surface, options.classes})
        check_printable(typed);
}

/// Measures one file by a kind of work, whose other keys --set gives: a picture as a mask of thresholds, or points on
/// the lines of a region or on a mesh. Relative paths start at the current folder.
void analyze_by_kind(const AnalyzeOptions& options, bool is_picture)
{
    check_printable(options);
    const std::string file =
        (is_picture ? std::ranges::find_if(options.files, has_picture_name) : options.files.begin())->string();
    const bool is_mesh = !options.surface.empty(), has_region = !options.region.empty();
    if (options.along && !has_region) throw InputError("analyze: --along needs --region");
    const bool has_others = is_picture ? is_mesh || has_region : !options.channel.empty() || (is_mesh && has_region);
    if (has_others || (!options.classes.empty() && !is_mesh) || !options.domain.empty() ||
        options.particles != no_type || !options.periodic.empty() || options.gallery || options.in_pieces ||
        options.files.size() > 1)
        throw InputError(fmt::format(
            "analyze: {}--out, --label, --set, --threads and --quiet can be given with it",
            is_picture
                ? printable(file) + ": is a picture, which is measured alone, as a mask of thresholds: --channel, "
            : is_mesh ? "--surface measures one file of points on a mesh: --classes, "
                      : "--along measures one file of points on lines: --region, "));
    if (is_picture) read_picture_header(file);
    std::string keys = fmt::format("kind = \"{}\"\n{} = {}\n",
                                   is_picture ? "mask-picture"
                                   : is_mesh  ? "mesh-set"
                                              : "line-set",
                                   is_picture ? "mask" : "set", quoted(file));
    const std::initializer_list<std::pair<const char*, std::string>> others{{"channel", options.channel},
                                                                            {"region", options.region},
                                                                            {"mesh", options.surface},
                                                                            {"classes", options.classes}};
    for (const auto& [key, value] : others)
        if (!value.empty()) keys += fmt::format("{} = {}\n", key, quoted(value));
    for (const std::string& text : options.overrides)
        keys += text.starts_with("analysis.")
                    ? text.substr(text.find('.') + 1) + "\n"
                    : throw InputError("analyze: --set " + text + ": must be analysis.KEY=VALUE");
    const std::string label = options.label.empty() ? options.files.front().stem().string() : options.label;
    Experiment experiment = experiment_of_text(fmt::format("title = {}\n[[distribution]]\n{}", quoted(label), keys));
    experiment.command = options.command;
    const auto out = options.out.empty() ? std::filesystem::path("out") / safe_name(label) : options.out;
    Progress progress(Progress::detect(options.quiet));
    run_experiment(experiment, out, progress);
    finish_report({out}, out, progress, PrintPictures::none, Gallery::offered);
}

/// A single value of --set as TOML.
std::string toml_of(const ConfigNode& node)
{
    const auto* text = node.get_if<std::string>();
    if (!text) return node.text;
    check_printable(*text);
    return quoted(*text);
}

/// Returns the keys of kind = "class-set" that measure a file as these options do. `set` are the keys of --set, and
/// `analysis` is what they and the options together say. Options that do not say how a region is read apply to the
/// series of each class.
std::string class_set_keys_of(const AnalyzeOptions& options, const ConfigTable& set, const AnalysisOptions& analysis)
{
    check_printable(options);
    if (const ConfigNode* box = find(set, "box"))
        throw InputError("analyze: " + box->location.file +
                         ": cannot be combined with --classes: --domain gives the sides");
    std::string keys =
        fmt::format("set = {}\nclasses = {}\n", quoted(options.files.front().string()), quoted(options.classes));
    if (!options.region.empty()) keys += fmt::format("region = {}\n", quoted(options.region));
    if (!options.domain.empty()) keys += fmt::format("domain = {}\n", quoted(options.domain));
    const bool has_region = !options.region.empty() || find(set, "region");
    if (!has_region && (analysis.window || analysis.region)) keys += "window = true\n"; // a square is a region as well
    for (const char* key : {"region", "planar", "crs", "overlap", "buffer"})
        if (const ConfigNode* node = find(set, key)) keys += fmt::format("{} = {}\n", key, toml_of(*node));
    return keys;
}

void analyze(const AnalyzeOptions& options)
{
    const ThreadLimit limit(options.threads);
    const bool has_picture = std::ranges::any_of(options.files, has_picture_name);
    if (has_picture || options.along || !options.surface.empty()) return analyze_by_kind(options, has_picture);
    if (!options.channel.empty()) throw InputError("analyze: --channel needs a picture");
    std::optional<PointDomain> domain;
    if (!options.domain.empty()) {
        domain = parse_domain(options.domain);
        if (!domain)
            throw InputError("analyze: --domain " + options.domain + ": must be " + domain_form +
                             decimal_comma_words(options.domain));
    }
    if (domain && domain->dimension() > 0 && options.in_pieces)
        throw InputError("analyze: --in-pieces cannot be combined with --domain of a range for each axis");
    const ConfigTable set = keys_of_set(options.overrides);
    check_region_options(options, set);
    PointReading how{.domain = domain, .options = option_words};
    if (options.particles != no_type) how.particles = static_cast<int>(options.particles);
    if (!options.classes.empty()) {
        if (options.files.size() > 1 || options.in_pieces || options.particles != no_type)
            throw InputError("analyze: --classes measures one file: it cannot be combined with others, --in-pieces and "
                             "--particles");
        how.classes = {options.classes, [](std::string_view) {}};
    }
    ConfigTable entries;
    if (!options.region.empty()) entries = entry_of("--region", "region", options.region, options.region);
    auto region = overridden_region(options.overrides, entries);
    if (region && domain)
        throw InputError("analyze: --domain cannot be combined with --region: points are then in the region's units");
    if (region && options.in_pieces) throw InputError("analyze: --in-pieces cannot be combined with --region");
    const auto take_as_region = [&] { // with its sides, which the torus has once
        entries = entry_of("--periodic", "region", rectangle_of(*domain), "no");
        how.domain.reset();
        region = overridden_region(options.overrides, entries);
    };
    if (domain && domain->dimension() == 2 && options.periodic == "no" && !has_measures_of_squares(set))
        take_as_region();
    const std::string label = options.label.empty() ? options.files.front().stem().string() : options.label;
    LargeImports large{options.out.empty() ? std::filesystem::path("out") / label : options.out, options.in_pieces};
    if (!options.classes.empty()) large = {};
    Experiment experiment = region ? import_region_points(options.files, options.label, *region->region, how)
                                   : import_points(options.files, options.label, how, large);
    const std::vector<double> sides = experiment.analysis.box_sides;
    if (how.domain && options.periodic == "no" && is_measured_in_square(experiment, set)) {
        take_as_region();
        experiment = import_region_points(options.files, options.label, *region->region, how);
    } else if (!sides.empty())
        entries = box_entry(options, sides);
    else if (options.periodic == "no" && !(domain && region))
        entries = window_entry(experiment, set);
    experiment.overrides = options.overrides;
    experiment.analysis = overridden_analysis(options.overrides, experiment.dimension, entries);
    experiment.analysis.is_periodic = options.periodic == "yes";
    check_imported(experiment);
    if (!options.classes.empty()) add_class_series(experiment, class_set_keys_of(options, set, experiment.analysis));
    experiment.command = options.command;
    const auto out = options.out.empty() ? std::filesystem::path("out") / experiment.series.front().name : options.out;
    Progress progress(Progress::detect(options.quiet));
    for (const std::string& note : experiment.notes) progress.note(note);
    for (const std::string& note : region_notes(experiment)) progress.note(note);
    run_experiment(experiment, out, progress);
    finish_report({out}, out, progress, PrintPictures::none, options.gallery ? Gallery::laid_behind : Gallery::offered);
}

}

Command analyze_command(const std::string& typed)
{
    const auto o = std::make_shared<AnalyzeOptions>();
    o->command = typed;
    return {"analyze",
            "Analyse point sets made elsewhere and write a report",
            {{"FILE", &o->files, "Point sets, one series"},
             {"--out", &o->out, "The output folder; default: out/ and the label", "DIR"},
             {"--label", &o->label, "The name of the sets in the report; default: the first file's name", "TEXT"},
             {"--domain", &o->domain,
              "Range of all coordinates, such as 512 or -1:1, or one for each axis, such as \"0:2 0:1\": sets lie in a "
              "periodic rectangle (box); default: what a file says, or 0:1",
              "[LOW:]HIGH"},
             allowing({"--particles", &o->particles,
                       "The particles of a snapshot that are the points: 0 for PartType0, and so on; default: the only "
                       "type that it has",
                       "TYPE"},
                      Integers{0, 6}),
             {"--region", &o->region,
              "The region of the plane that points lie in, whose units they have: a file of GeoJSON or WKT, rectangle "
              "X0 Y0 X1 Y1, disk X Y RADIUS",
              "REGION"},
             {"--along", &o->along, "Measure the points along the lines and outlines of the region"},
             {"--surface", &o->surface, "The mesh that points lie on, whose eigenfunctions give the spectrum", "MESH"},
             allowing({"--classes", &o->classes,
                       "The column or property that has the class of each point: classes are measured alone, together "
                       "and in pairs; with --surface by their nearest distances",
                       "COLUMN"},
                      "the name or the number of a column"),
             {"--channel", &o->channel, "The channel of a picture that is measured as a mask, such as G", "NAME"},
             {"--periodic", &o->periodic,
              "Whether sets go on across their border as on a torus; no: they are measured within the square (cube); "
              "default: yes, with a message where the closest pairs say no",
              "yes|no"},
             {"--gallery", &o->gallery, "Lay reference curves of the laboratory's methods behind those of the sets"},
             {"--in-pieces", &o->in_pieces,
              "Read each file in pieces and keep its points on the disk, as is done of more than 16,777,216"},
             {"--set", &o->overrides, "Set a key of [analysis]; may be repeated", "analysis.KEY=VALUE"},
             {"--threads", &o->threads, "Use so many threads; default: all", "N"},
             {"--quiet", &o->quiet, "Print nothing but errors and the report's path"}},
            analyze_notes,
            action_on(o, analyze)};
}

}
