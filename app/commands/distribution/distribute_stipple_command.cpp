// poissonlab distribute stipple, distribute hatch: a picture in dots or strokes.
#include "app/commands/distribution/distribute_options.hpp"
#include "app/commands/point_target.hpp"
#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "host/config/distributions/stipple_table.hpp"
#include "host/distribution/place_file.hpp"
#include "host/distribution/stipple.hpp"
#include "reports/drawings/mark_image.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

constexpr auto distribute_stipple_notes =
    R"help(Dots of one size, as many as the picture has ink: ink is 1 - luminance in linear light, or a formula in x and y from
-1 to 1 with values from 0, white, to 1, black. Number times area of the dots is the ink, exactly, in the picture and,
as evenly as they lie, in each part, as long as they do not overlap. What is said of the tones: the ink beyond which
dots of this size overlap even where it is constant, how many pixels have more, how much ink lies on other ink, and the
mean difference from the picture over windows of 32 pixels. Photographs have darker parts than dots can print: --ink 0.5
prints half of the ink everywhere.
--by says how dots find their places:
  gaussian     even points are warped, and then adaptive Gaussian blue noise (Ahmed, Ren, Wonka 2022) makes them even at
               every tone, in --iterations steps; the truest tones. Fewer than 135 dots are only warped.
  warping      even points through the inverse cumulative distribution (distribute warp): fast, but it stretches
               distances, which shows as clumps and bands
  ranks        points of the lowest ranks: of the self-similar tile (distribute rank), or, with --tiles, of a ranked tile
               set, whose dots do not overlap at all where no pixel is too dark; fast
For 12,800 dots the tone error after a blur by one distance of dots is, in percent of the mean ink: gaussian 1.5 to 2.1,
warping 3.9 to 10.6, ranks with tiles 6.3 to 8.4 (a ramp, a lit ball, a photograph of a forest); after a blur by four
distances 0.5 to 0.9, 0.8 to 5.4 and 1.1 to 2.1. All of it takes 2.7, 0.9 and 0.7 s of a processor.
--out, as often as you like: .svg has all dots, .png shows how much of each pixel is covered, encoded as sRGB, so that
a screen shows the ink that is asked for (--pixels wide, by default as the picture), other files have their middles, in units of the longest side, y upwards.
  poissonlab distribute stipple --image photo.jpg --points 40000 --out dots.svg --out dots.png
  poissonlab distribute stipple --image photo.jpg --dot 3 --ink 0.5 --out dots.ply --json)help";

constexpr auto distribute_hatch_notes =
    R"help(Strokes of one size with round ends instead of dots: see `help distribute stipple` for ink, tones and files. Strokes
are --slenderness times as long as wide, and lie along the picture's lines (its smoothed structure tensor), where it has
none at 45 degrees, or all at --angle. Long strokes overlap sooner than dots: what is said of the tones counts it.
  poissonlab distribute hatch --image photo.jpg --points 13000 --ink 0.5 --out strokes.svg
  poissonlab distribute hatch --image photo.jpg --stroke 1.5 --angle 0.8 --out strokes.png --pixels 2048)help";

constexpr std::uint64_t most_stippled = 1 << 24;
constexpr std::uint32_t most_steps = 1'000'000;

struct StippleOptions : DistributeOptions
{
    bool has_strokes = false;
    StippleSettings settings;
    double angle = NAN;
    std::string by;               ///< empty: usual_mark_places
    std::uint32_t iterations = 0; ///< 0: the default of the settings
    std::vector<std::string> outs;
    std::uint32_t pixels = 0;
    bool as_json = false;

    std::string line(const std::string& option, const std::string& problem) const
    {
        return fmt::format("{}: {}: {}", command, option, problem);
    }
};

void check_number(const StippleOptions& o, const char* option, double value, double low, double high)
{
    if (!(value >= low && value <= high))
        throw InputError(o.line(fmt::format("{} {}", option, value), fmt::format("must be from {} to {}", low, high)));
}

StippleSettings checked_settings(const StippleOptions& o)
{
    check_engine(o);
    StippleSettings settings = o.settings;
    settings.has_strokes = o.has_strokes;
    settings.points = o.points;
    const char* width = o.has_strokes ? "--stroke" : "--dot";
    if (o.points == 0 && settings.mark_width == 0)
        throw InputError(o.line(fmt::format("--points or {}", width), "one of them must be given, above 0"));
    if (o.points > most_stippled)
        throw InputError(
            o.line(fmt::format("--points {}", o.points), fmt::format("must be from 1 to {}", most_stippled)));
    if (o.points == 0) check_number(o, width, settings.mark_width, 0.01, 10'000);
    check_number(o, "--ink", settings.ink, 0.001, 1);
    check_number(o, "--slenderness", settings.slenderness, 1, 100);
    if (!std::isnan(o.angle)) {
        check_number(o, "--angle", o.angle, -7, 7);
        settings.angle = o.angle;
    }
    const auto by = std::ranges::find(mark_places, o.by);
    if (!o.by.empty() && by == mark_places.end())
        throw InputError(
            o.line(fmt::format("--by {}", printable(o.by)), fmt::format("must be {}", fmt::join(mark_places, " or "))));
    settings.by = usual_mark_places;
    if (!o.by.empty()) settings.by = static_cast<MarkPlaces>(by - mark_places.begin());
    if (settings.by == MarkPlaces::ranks && !o.method.empty())
        throw InputError(o.line("--by ranks", "goes without --method"));
    if (o.iterations > 0) {
        if (settings.by != MarkPlaces::gaussian) throw InputError(o.line("--iterations", "goes with --by gaussian"));
        settings.iterations = o.iterations;
    }
    if (o.pixels > static_cast<std::uint32_t>(max_drawing_pixels))
        throw InputError(o.line(fmt::format("--pixels {}", o.pixels), "must be at most 32768"));
    for (const std::filesystem::path out : o.outs) {
        check_output(o, out);
        if (out.extension() != ".svg" && out.extension() != ".png")
            check_point_target(o.command, out, ", .svg or .png");
    }
    settings.method = even_method_choice(o);
    return settings;
}

/// Width and height of a .png.
std::array<int, 2> png_size(const StippleOptions& o, const InkPicture& picture)
{
    if (o.pixels == 0) return {picture.ink.width, picture.ink.height};
    const auto wide = static_cast<int>(o.pixels);
    const double high = std::round(static_cast<double>(picture.ink.height) * wide / picture.ink.width);
    if (high > max_drawing_pixels)
        throw InputError(o.line(fmt::format("--pixels {}", wide),
                                fmt::format("the picture would be {} pixels high; must be at most 32768", high)));
    return {wide, std::max(1, static_cast<int>(high))};
}

void write_marks(const StippleOptions& o, const InkPicture& picture, const Stippling& stippling)
{
    const auto [wide, high] = png_size(o, picture);
    for (const std::filesystem::path file : o.outs) {
        if (file.extension() == ".svg")
            write_whole_file(file, drawing_svg(draw_marks(mark_picture(picture, stippling), {})));
        else if (file.extension() == ".png")
            write_coverage(file,
                           coverage_of(stippling.marks, wide, high, static_cast<double>(wide) / picture.ink.width));
        else
            write_places(file, stippling.places,
                         static_cast<std::uint32_t>(std::max(picture.ink.width, picture.ink.height)),
                         fmt::format("poissonlab {} --image {}: {} middles of marks in units of the longest side of {} "
                                     "x {} pixels, y upwards",
                                     o.command, printable(o.settings.image), stippling.places.size() / 2,
                                     picture.ink.width, picture.ink.height));
    }
}

void say_tones(const StippleOptions& o, const TonesOfMarks& tones, const Stippling& stippling)
{
    const std::size_t count = stippling.places.size() / 2;
    if (o.as_json) {
        const nlohmann::ordered_json json{{"marks", count},
                                          {"mark_width", stippling.mark_width},
                                          {"mark_area", stippling.mark_area},
                                          {"tone_error", tones.error},
                                          {"darkest_ink", tones.darkest_ink},
                                          {"too_dark", tones.too_dark},
                                          {"overlap", tones.overlap}};
        fmt::print("{}\n", json.dump(2));
        return;
    }
    if (o.quiet) return;
    fmt::print("{} {}, {:.3g} pixels {}; tone error {:.4f} over windows of 32 pixels\n", count,
               o.has_strokes ? "strokes" : "dots", stippling.mark_width, o.has_strokes ? "wide" : "in diameter",
               tones.error);
    fmt::print("{:.1f} % of the pixels are too dark: they have more ink than {:.3f}, where {} overlap; {:.2f} % of the "
               "ink lies on other ink\n",
               100 * tones.too_dark, tones.darkest_ink, o.has_strokes ? "strokes can" : "dots", 100 * tones.overlap);
}

void stipple_picture(const StippleOptions& o)
{
    const StippleSettings settings = checked_settings(o);
    try {
        const InkPicture picture = read_ink(settings);
        say_note(o, picture.ink.note);
        DistributeOptions shown = o; // steps go to standard output, where programs read JSON
        shown.quiet = o.quiet || o.as_json;
        const DistributionPlace place = make_place(shown);
        const Stippling stippling = stipple(picture, settings, o.seed, place);
        const Coverage coverage = coverage_of(stippling.marks, picture.ink.width, picture.ink.height, 1);
        write_marks(o, picture, stippling);
        say_tones(o, tones_of(picture, settings, stippling, coverage, place), stippling);
    } catch (const InputError& error) {
        const std::string message = error.what();
        if (message.starts_with(o.command)) throw;
        throw InputError(fmt::format("{}: {}", o.command, message));
    }
}

std::vector<Option> picture_options(StippleOptions& o)
{
    return {
        {"--image", &o.settings.image, "The picture, or a formula of its ink", "IMAGE|FORMULA", required},
        {"--image-from", &o.settings.from, "Of a picture: ink (the default), light, or one of its channels", "NAME"},
        {"--ink", &o.settings.ink, "The part of the ink that is printed; default: 1", "SHARE"}};
}

/// Options of both; `width` is that of a mark.
std::vector<Option> mark_options(StippleOptions& o, Option width)
{
    std::vector<Option> even = even_point_options(o);
    for (Option& option : even)
        if (option.name == "--points") {
            option = allowing(std::move(option), integers(1, most_stippled));
            option.is_required = optional;
            option.help = "How many marks; their size follows from the ink. By ranks: about so many";
        }
    width.excludes = "--points";
    const std::vector<Option> own{
        std::move(width),
        {"--by", &o.by, "gaussian (the default), warping or ranks", "NAME"},
        allowing({"--iterations", &o.iterations, "Of --by gaussian: steps that all points take; default: 200", "N"},
                 integers(1, most_steps)),
        {"--out", &o.outs, "A file, .svg, .png or of points; may be repeated", "FILE", required},
        allowing({"--pixels", &o.pixels, "The width of a .png; default: the picture's", "W"},
                 integers(1, max_drawing_pixels)),
        {"--json", &o.as_json, "Say what is said of the tones as JSON"}};
    return joined({picture_options(o), even, own, device_options(o)});
}

}

Command distribute_stipple_command()
{
    const auto o = std::make_shared<StippleOptions>();
    o->command = "distribute stipple";
    return {"stipple", "Print a picture in dots of one size",
            mark_options(*o, {"--dot", &o->settings.mark_width,
                              "The diameter of dots, in pixels of the picture; their number follows", "D"}),
            distribute_stipple_notes, action_on(o, stipple_picture)};
}

Command distribute_hatch_command()
{
    const auto o = std::make_shared<StippleOptions>();
    o->command = "distribute hatch";
    o->has_strokes = true;
    const std::vector<Option> own{
        {"--angle", &o->angle, "The direction of all strokes, in radians; default: along lines", "A"},
        {"--slenderness", &o->settings.slenderness, "How many times as long as wide strokes are; default: 8", "K"}};
    return {"hatch", "Print a picture in strokes of one size",
            joined({mark_options(*o, {"--stroke", &o->settings.mark_width,
                                      "The width of strokes, in pixels of the picture; their number follows", "W"}),
                    own}),
            distribute_hatch_notes, action_on(o, stipple_picture)};
}

}
