#include "app/command_line.hpp"

#include "app/commands/commands.hpp"
#include "base/errors/errors.hpp"
#include "base/files/standard_streams.hpp"
#include "base/programs/interrupt.hpp"
#include "base/programs/shell_words.hpp"
#include "host/config/nearest_key.hpp"
#include "host/crew/crew.hpp"
#include "host/crew/failure.hpp"
#include "version.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <limits>

namespace poissonlab {
namespace {

constexpr int exit_other = 1;
constexpr int exit_input = 2;
constexpr int exit_device = 3;
constexpr int exit_changed = 4;

constexpr auto main_footer = R"(Examples:
  poissonlab run configs/quick.toml                        an experiment and its report, in out/quick
  poissonlab run configs/quick.toml --set seed=2 --out a   the same with another seed, in a
  poissonlab analyze points-*.dat --label "My method" --out mine
  poissonlab report out/quick mine --out both              one report over both
  poissonlab diff before after                             which numbers changed beyond their error
  poissonlab help samplers                                 every method of making point sets

Exit status: 0 everything asked for is there; 2 the config, a file or an argument is wrong;
3 OpenCL failed; 4 diff found changes; 130 interrupted; 1 anything else.)";

constexpr auto run_footer =
    R"(CONFIG is a TOML file; configs/quick.toml explains every key. `poissonlab samplers` lists the methods.
--set changes the config without editing it; keys have dots, methods count from 0:
  --set seed=2   --set analysis.points=4096   --set engine=reference
  --set method.0.label=White   --set "method.relative_radius=[0.6, 0.7]" (every method that has it)
  --set method.0.start.relative_radius=0.7 (in a table of the method)
Results are written to DIR when everything is done; see docs/output-folder.md. Until then, and when something
fails, a previous result in DIR stays as it is. The last line of output is the path of the report.

Finished work is kept in DIR/.units: a run that was interrupted goes on where it was, and one with other settings makes
only what these change. Several processes share the work:
  mpirun -n 8 poissonlab run CONFIG --out DIR         on machines that share DIR
  poissonlab run CONFIG --out DIR --shard 1/3         and 2/3, 3/3, each anywhere; if DIR is shared, the last one writes
                                                      the results; if not, `poissonlab merge`, then run without
                                                      --shard)";

constexpr auto merge_footer =
    R"(Copies what is stored in DIR/.units and not in OUT/.units; what is damaged is left out. Then the same run writes
the results:
  poissonlab merge out/shard-1 out/shard-2 out/shard-3 --out out/all
  poissonlab run config.toml --out out/all)";

constexpr auto analyze_footer =
    R"(Each FILE has one realization, or several: text (one point a line, coordinates in [0,1) separated by blanks;
a line with # alone separates realizations), PLY or NumPy .npy. All realizations must have as many points.
Other ranges of coordinates: --domain, or a comment before the points, `# domain 0:512` (PLY: `comment domain 0:512`).
  poissonlab analyze set-*.dat --label "My method" --out mine
--set takes the keys of a config's [analysis] that are about the analysis:
  --set analysis.zone_plate=true      sample the zone plate (2D; made for 262,144 points)
  --set analysis.tiles=8              the sets are made of 8 x 8 tiles: report their lattice peaks
  --set analysis.spectrum_size=2048   frequencies along each axis; also spectrum=exact, volume=true (3D))";

constexpr auto diff_footer =
    R"(OLD and NEW are output folders of the same experiment, or collections of such. Prints the numbers that changed
beyond their error over realizations (Welch's test, corrected for the number of tests: one false alarm in a hundred
comparisons), better or worse where that is known, and series that are new or missing. Numbers without chance are
compared exactly; times only between equal machines, devices and threads.
Exit status 4: something changed.
  poissonlab diff out/before out/after --out difference)";

constexpr auto tiling_footer =
    R"(Prints tile indices, a row of tiles a line, north first; cubes: layer after layer from the bottom, with an empty
line between them. A tile's coordinates are those of its lower left corner; they may be negative, of 64 bits.
An index is the number whose digits are the colours: N E S W (wang), NE SE SW NW (corner); the same at the top and
then at the bottom (cube).
  corner  direct; scanline, scanline-compact
  wang    edge-hash, two-hashes, one-hash (a compact set); scanline, scanline-compact
  cube    direct
Scanline tilings start at their north-west tile; the window must be at 0 0.
--hash long-period (repeats after 5,930,659,848 tiles), permutation (256; the fastest), xxh64 (never repeats);
with edge-hash, after half as many.
  poissonlab tiling corner --colors 3 --window -4 -4 8 8)";

constexpr auto tiles_build_footer =
    R"(corner: C^4 tiles; edge: C^12; sphere: C^8 in three dimensions; template: T tiles. Lloyd relaxation alone is good
for relative radii up to 0.75, with --repulsion 0.85 can be had. The file is described in docs/tile-set-file.md.
  poissonlab tiles build corner --colors 4 --points 64 --out corner.ptiles
  poissonlab tiles build template --tiles 16 --points 32 --relative-radius 0.8 --repulsion --out template.ptiles)";

constexpr auto tiles_points_footer =
    R"(Coordinates are in tiles, from the lowest corner of the window. Rows of tiles from south to north (3D: layers
from the bottom), in each from west to east. The seed chooses the tiling: windows of the same seed fit together.
The format follows the extension: .npy, .ply (ascii), or text; the latter two say `domain 0:N`, the longest side of the
window, so that poissonlab analyze takes the points of a square one; for .npy, --domain N. Edges of the window are not
those of a torus.
  poissonlab tiles points corner.ptiles --window -8 -8 16 16 --out points.npy)";

constexpr auto tiles_verify_footer =
    R"(FILE is a tile set, .ptiles or JSON: see docs/tile-set-file.md. Whatever made it, the minimum distance is proven
for every tiling: the exact smallest one among all points that can be near each other. Exit status 2 if the file is
damaged, tiles do not fit together, or it promises more than is proven.
Density: points in the regions over those of as many points spread evenly.)";

/// Accepts what is an integer of this type and nothing else: no overflow, no sign for numbers that have none.
template <class Integer>
CLI::Validator integer()
{
    return CLI::Validator(
        [](const std::string& text) -> std::string {
            Integer value{};
            const char* const end = text.data() + text.size();
            const auto [stop, error] = std::from_chars(text.data(), end, value);
            if (error == std::errc() && stop == end) return {};
            return fmt::format("{}: must be an integer from {} to {}", text, std::numeric_limits<Integer>::min(),
                               std::numeric_limits<Integer>::max());
        },
        "");
}

/// The program's subcommands with their options, and what was given.
class CommandLine
{
public:
    CommandLine()
    {
        app_.set_version_flag("--version", "poissonlab " POISSONLAB_VERSION_STRING, "Print the version");
        app_.footer(main_footer);
        add_run();
        add_merge();
        add_analyze();
        add_report();
        add_diff();
        add_tiling();
        add_tiles();
        devices_ = app_.add_subcommand("devices", "List what OpenCL offers on this machine");
        samplers_ = app_.add_subcommand("samplers", "List the methods of making point sets and their parameters");
        help_ = app_.add_subcommand("help", "Explain a command, or the samplers");
        help_->add_option("TOPIC", topic_, "A command; \"samplers\" lists the methods");
    }

    void parse(int argc, const char* const* argv);
    /// Returns the exit status.
    int execute();
    int show_help_or_version(const CLI::ParseError& outcome) { return app_.exit(outcome); }

private:
    void add_run();
    void add_merge();
    void add_analyze();
    void add_report();
    void add_diff();
    void add_tiling();
    void add_tiles();
    void add_tiles_build();
    void add_tiles_points();
    void add_tiles_verify();
    void explain();
    std::vector<std::string> command_names() const;

    CLI::App app_{"poissonlab: makes Poisson disk point sets on OpenCL devices, analyses them, and reports.",
                  "poissonlab"};
    RunOptions run_options_;
    MergeOptions merge_options_;
    AnalyzeOptions analyze_options_;
    ReportOptions report_options_;
    DiffOptions diff_options_;
    TilingOptions tiling_options_;
    TilesBuildOptions tiles_build_options_;
    TilesPointsOptions tiles_points_options_;
    TilesVerifyOptions tiles_verify_options_;
    std::string topic_;
    bool help_wanted_ = false;
    CLI::App* run_ = nullptr;
    CLI::App* merge_ = nullptr;
    CLI::App* analyze_ = nullptr;
    CLI::App* report_ = nullptr;
    CLI::App* diff_ = nullptr;
    CLI::App* tiling_ = nullptr;
    CLI::App* tiles_ = nullptr;
    CLI::App* tiles_build_ = nullptr;
    CLI::App* tiles_points_ = nullptr;
    CLI::App* tiles_verify_ = nullptr;
    CLI::App* devices_ = nullptr;
    CLI::App* samplers_ = nullptr;
    CLI::App* help_ = nullptr;
};

void CommandLine::add_run()
{
    RunOptions& o = run_options_;
    run_ = app_.add_subcommand("run", "Run the experiment of a config and write its report");
    run_->add_option("CONFIG", o.config, "The experiment (.toml)")->required();
    run_->add_option("--out", o.out, "The output folder; default: out/ and the config's name")->option_text("DIR");
    run_->add_option("--device", o.device, "The OpenCL device: part of its name, or its number in `poissonlab devices`")
        ->option_text("NAME");
    run_->add_option("--set", o.overrides, "Change a key of the config; may be repeated")
        ->option_text("KEY=VALUE")
        ->allow_extra_args(false);
    run_->add_option("--threads", o.threads, "Use so many threads, and compute units of a CPU device; default: all")
        ->option_text("N")
        ->check(CLI::Range(1, 4096));
    run_->add_option("--shard", o.shard, "Only share i of n of the work, see below")->option_text("i/n");
    run_->add_flag("--quiet", o.quiet, "Print nothing but errors and the report's path");
    run_->add_flag("--json", o.json, "Print progress as JSON objects, one a line")->excludes("--quiet");
    run_->footer(run_footer);
}

void CommandLine::add_merge()
{
    MergeOptions& o = merge_options_;
    merge_ = app_.add_subcommand("merge", "Take over finished work of other output folders, such as those of shards");
    merge_->add_option("DIR", o.folders, "Output folders of `run --shard`")->required();
    merge_->add_option("--out", o.out, "The output folder that gets it")->required()->option_text("OUT REQUIRED");
    merge_->add_flag("--quiet", o.quiet, "Print nothing but errors");
    merge_->footer(merge_footer);
}

void CommandLine::add_analyze()
{
    AnalyzeOptions& o = analyze_options_;
    analyze_ = app_.add_subcommand("analyze", "Analyse point sets made elsewhere and write a report");
    analyze_->add_option("FILE", o.files, "Point sets, one series")->required();
    analyze_->add_option("--out", o.out, "The output folder; default: out/ and the label")->option_text("DIR");
    analyze_->add_option("--label", o.label, "What the report calls them; default: the first file's name")
        ->option_text("TEXT");
    analyze_
        ->add_option("--domain", o.domain,
                     "Range of all coordinates, such as 512 or -1:1; default: what a file says, or 0:1")
        ->option_text("[LOW:]HIGH");
    analyze_->add_option("--set", o.overrides, "Set a key of [analysis]; may be repeated")
        ->option_text("analysis.KEY=VALUE")
        ->allow_extra_args(false);
    analyze_->add_option("--threads", o.threads, "Use so many threads; default: all")
        ->option_text("N")
        ->check(CLI::Range(1, 4096));
    analyze_->add_flag("--quiet", o.quiet, "Print nothing but errors and the report's path");
    analyze_->footer(analyze_footer);
}

void CommandLine::add_report()
{
    ReportOptions& o = report_options_;
    report_ = app_.add_subcommand("report", "Build a report again, or one over several output folders");
    report_->add_option("DIR", o.folders, "Folders that `run` or `analyze` wrote")->required();
    report_->add_option("--out", o.out, "Where the report goes; default: DIR, where there is one")->option_text("DIR");
    report_->add_flag("--print", o.print, "Draw curves as PNG for print as well; pages need only the SVG");
    report_->add_flag("--quiet", o.quiet, "Print nothing but errors and the report's path");
}

void CommandLine::add_diff()
{
    DiffOptions& o = diff_options_;
    diff_ = app_.add_subcommand("diff", "Say which numbers of two results changed beyond their error");
    diff_->add_option("OLD", o.before, "An output folder")->required();
    diff_->add_option("NEW", o.after, "Another one of the same experiment")->required();
    diff_->add_option("--out", o.out, "Write a page there, diff.html")->option_text("DIR");
    diff_->add_flag("--json", o.json, "Print JSON");
    diff_->add_flag("--all", o.all, "List numbers that did not change as well");
    diff_->footer(diff_footer);
}

void CommandLine::add_tiling()
{
    TilingOptions& o = tiling_options_;
    tiling_ = app_.add_subcommand("tiling", "Print the tile indices of a stochastic tiling");
    tiling_->add_option("KIND", o.kind, "corner, wang or cube")->required();
    tiling_->add_option("--colors", o.colors, "Number of colours")
        ->option_text("C")
        ->check(integer<std::uint32_t>())
        ->required();
    tiling_->add_option("--algorithm", o.algorithm, "How tiles are chosen, see below; default: the first")
        ->option_text("NAME");
    tiling_->add_option("--hash", o.hash, "What gives lattice points their colours; default: long-period")
        ->option_text("NAME");
    tiling_->add_option("--seed", o.seed, "Everything random follows from it; default: 1")
        ->option_text("S")
        ->check(integer<std::uint64_t>());
    tiling_->add_option("--window", o.window, "The tiles to print: lower left one, width and height")
        ->option_text("X Y W H (cube: X Y Z W H D)")
        ->expected(1, 6)
        ->check(integer<std::int64_t>())
        ->required();
    tiling_->add_option("--period", o.period, "The tiling closes after so many tiles; 0: it does not")
        ->option_text("MX [MY [MZ]]")
        ->expected(1, 3)
        ->check(integer<std::int64_t>());
    tiling_->footer(tiling_footer);
}

void CommandLine::add_tiles()
{
    tiles_ = app_.add_subcommand("tiles", "Poisson disk tile sets");
    tiles_->require_subcommand(1);
    add_tiles_build();
    add_tiles_points();
    add_tiles_verify();
}

void CommandLine::add_tiles_build()
{
    TilesBuildOptions& o = tiles_build_options_;
    tiles_build_ = tiles_->add_subcommand("build", "Build a tile set and prove the minimum distance of its tilings");
    tiles_build_->add_option("KIND", o.kind, "corner, edge, template or sphere")->required();
    tiles_build_->add_option("--colors", o.colors, "Number of colours; not for template tiles")
        ->option_text("C")
        ->check(integer<std::uint32_t>());
    tiles_build_->add_option("--tiles", o.tiles, "Number of template tiles")
        ->option_text("T")
        ->check(integer<std::uint32_t>());
    tiles_build_->add_option("--points", o.points, "Points of each tile")
        ->option_text("N")
        ->check(integer<std::uint32_t>())
        ->required();
    tiles_build_->add_option("--relative-radius", o.relative_radius, "That every tiling has at least; default: 0.75")
        ->option_text("RHO");
    tiles_build_->add_option("--filling", o.filling, "dart-throwing or relaxation-dart-throwing (the default)")
        ->option_text("NAME");
    tiles_build_->add_option("--lloyd", o.lloyd_iterations, "Lloyd iterations of each piece; default: 20")
        ->option_text("I")
        ->check(integer<std::uint32_t>());
    tiles_build_->add_flag("--repulsion", o.repulsion, "Push apart what Lloyd relaxation leaves too close");
    tiles_build_->add_option("--seed", o.seed, "Everything random follows from it; default: 1")
        ->option_text("S")
        ->check(integer<std::uint64_t>());
    tiles_build_->add_option("--out", o.out, "The file: .ptiles, or .json for people")->option_text("FILE")->required();
    tiles_build_->add_option("--engine", o.engine, "opencl (the default), or reference")->option_text("NAME");
    tiles_build_->add_option("--device", o.device, "The OpenCL device: part of its name, or its number")
        ->option_text("NAME");
    tiles_build_->add_flag("--quiet", o.quiet, "Print nothing but errors");
    tiles_build_->footer(tiles_build_footer);
}

void CommandLine::add_tiles_points()
{
    TilesPointsOptions& o = tiles_points_options_;
    tiles_points_ = tiles_->add_subcommand("points", "Write the points of a window of a tiling to a file");
    tiles_points_->add_option("FILE", o.file, "The tile set (.ptiles, .json)")->required();
    tiles_points_->add_option("--window", o.window, "The tiles: lowest one, and how many along each axis")
        ->option_text("X Y W H (3D: X Y Z W H D)")
        ->expected(1, 6)
        ->check(integer<std::int64_t>())
        ->required();
    tiles_points_->add_option("--out", o.out, "The point file")->option_text("FILE")->required();
    tiles_points_->add_option("--seed", o.seed, "Which tiling; default: 1")
        ->option_text("S")
        ->check(integer<std::uint32_t>());
    tiles_points_->add_option("--device", o.device, "The OpenCL device: part of its name, or its number")
        ->option_text("NAME");
    tiles_points_->footer(tiles_points_footer);
}

void CommandLine::add_tiles_verify()
{
    TilesVerifyOptions& o = tiles_verify_options_;
    tiles_verify_ = tiles_->add_subcommand("verify", "Check a tile set's file and prove its minimum distance");
    tiles_verify_->add_option("FILE", o.file, "The tile set (.ptiles, .json)")->required();
    tiles_verify_->add_flag("--json", o.json, "Print JSON");
    tiles_verify_->footer(tiles_verify_footer);
}

std::vector<std::string> CommandLine::command_names() const
{
    std::vector<std::string> names;
    for (const CLI::App* command : app_.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(command->get_name());
    return names;
}

/// The command as it would be typed: arguments in quotes where a shell needs them. Without --shard: whoever did the
/// work, results are the same.
std::string typed_command(int argc, const char* const* argv)
{
    std::string text = "poissonlab";
    for (int i = 1; i < argc; ++i) {
        const std::string_view argument = argv[i];
        if (argument == "--shard")
            ++i;
        else if (!argument.starts_with("--shard="))
            text += " " + shell_word(argv[i]);
    }
    return text;
}

void CommandLine::parse(int argc, const char* const* argv)
{
    const std::vector<std::string> names = command_names();
    if (argc < 2)
        throw InputError(fmt::format("a command is missing: {} (see poissonlab --help)", fmt::join(names, ", ")));
    const std::string first = argv[1];
    if (!first.starts_with("-") && std::ranges::find(names, first) == names.end())
        throw InputError(fmt::format("unknown command \"{}\"{} (commands: {})", first, did_you_mean(first, names),
                                     fmt::join(names, ", ")));
    // Topics are names of commands, which the parser would run instead of explaining.
    if (first == "help" && (argc == 2 || argv[2][0] != '-')) {
        if (argc > 3) throw InputError("help explains one topic at a time");
        help_wanted_ = true;
        topic_ = argc == 3 ? argv[2] : "";
        return;
    }
    run_options_.command = analyze_options_.command = typed_command(argc, argv);
    app_.parse(argc, argv);
}

void CommandLine::explain()
{
    if (topic_ == "samplers") return samplers_command();
    if (topic_.empty()) {
        fmt::print("{}", app_.help());
        return;
    }
    const std::vector<std::string> names = command_names();
    if (std::ranges::find(names, topic_) == names.end())
        throw InputError(fmt::format("no help on \"{}\"{} (topics: {})", topic_, did_you_mean(topic_, names),
                                     fmt::join(names, ", ")));
    fmt::print("{}", app_.get_subcommand(topic_)->help());
}

int CommandLine::execute()
{
    if (*diff_) return diff_command(diff_options_) ? exit_changed : 0;
    if (*run_) run_command(run_options_);
    if (*merge_) merge_command(merge_options_);
    if (*analyze_) analyze_command(analyze_options_);
    if (*report_) report_command(report_options_);
    if (*tiling_) tiling_command(tiling_options_);
    if (*tiles_build_) tiles_build_command(tiles_build_options_);
    if (*tiles_points_) tiles_points_command(tiles_points_options_);
    if (*tiles_verify_) tiles_verify_command(tiles_verify_options_);
    if (*devices_) devices_command();
    if (*samplers_) samplers_command();
    if (help_wanted_) explain();
    return 0;
}

int fail(int status, const std::string& message)
{
    if (is_crew_follower()) return status; // the process that leads says it
    std::fflush(stdout);
    // Not by fmt, which throws where standard error is closed, too.
    std::fputs(("poissonlab: error: " + message + "\n").c_str(), stderr);
    return status;
}

/// The status, unless some of the output is lost.
int flushed(int status)
{
    const bool is_lost = std::fflush(stdout) != 0 || std::ferror(stdout) != 0;
    return is_lost ? fail(exit_other, "cannot write to standard output") : status;
}

/// Says what the exception being handled is. Returns the exit status.
int tell_of_exception()
{
    Failure failure;
    try {
        stop_if_interrupted(); // what fails after a signal, such as a program that got it as well, is no error
        throw;
    } catch (...) {
        failure = Failure::current();
    }
    switch (failure.kind) {
    case Failure::Kind::interrupted:
        std::fflush(stdout);
        tell_of_interruption();
        return exit_interrupted;
    case Failure::Kind::input:
        return fail(exit_input, failure.message);
    case Failure::Kind::device:
        return fail(exit_device, failure.message);
    default:
        return fail(exit_other, failure.message);
    }
}

}

int run_command_line(int argc, const char* const* argv)
{
    open_standard_streams();
    try {
        CommandLine command_line;
        try {
            command_line.parse(argc, argv);
        } catch (const CLI::ParseError& outcome) {
            if (outcome.get_exit_code() == 0) return flushed(command_line.show_help_or_version(outcome));
            std::string message = outcome.what();
            std::ranges::replace(message, '\n', ' ');
            return fail(exit_input, printable(message) + " (see poissonlab --help)");
        }
        catch_interrupts();
        return flushed(command_line.execute());
    } catch (const std::exception&) {
        return tell_of_exception();
    }
}

}
