// poissonlab distribute icons: arrows that show a vector field and cannot overlap.
#include "app/commands/distribution/distribute_options.hpp"
#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "host/distribution/distribution_run.hpp"
#include "host/distribution/icons.hpp"
#include "reports/drawings/mark_image.hpp"

#include <fmt/format.h>

namespace poissonlab {
namespace {

constexpr auto distribute_icons_notes =
    R"help(Arrows at even points; each stays in a disk around its point whose radius is half of the least distance, so that no
two can overlap. The field: the first two channels of a picture (such as .exr), or formulas in x and y from -1 to 1 over
a square. u points to the right, v upwards; an arrow is that of the pixel at its point. A vector of length 0 is a dot,
one that is not a number a hole. Formulas that begin with a minus sign are written --u=-y.
--out, as often as you like: .svg, .png (--pixels wide) or .csv, the points in units of the longest side with u and v.
  poissonlab distribute icons --u=-y --v x --points 500 --out rotation.svg
  poissonlab distribute icons --field wind.exr --points 2000 --length one --out wind.png --out wind.csv)help";

constexpr std::uint32_t most_icon_pixels = max_drawing_pixels / 2;

struct IconOptions : DistributeOptions
{
    IconSettings settings;
    std::string length = "magnitude";
    std::vector<std::string> outs;
    std::uint32_t pixels = 1024;
};

IconSettings checked_icons(const IconOptions& o)
{
    check_engine(o);
    check_points(o);
    IconSettings settings = o.settings;
    const bool has_formulas = !settings.u.empty() && !settings.v.empty();
    if (settings.field.empty() ? !has_formulas : !(settings.u.empty() && settings.v.empty()))
        throw InputError(o.command + ": needs --field, or --u and --v");
    if (o.length != "magnitude" && o.length != "one")
        throw InputError(fmt::format("{}: --length {}: must be magnitude or one", o.command, printable(o.length)));
    if (o.pixels < 1 || o.pixels > most_icon_pixels)
        throw InputError(fmt::format("{}: --pixels {}: must be from 1 to {}", o.command, o.pixels, most_icon_pixels));
    for (const std::string& out : o.outs) {
        const std::string extension = std::filesystem::path(out).extension();
        if (extension != ".svg" && extension != ".png" && extension != ".csv")
            throw InputError(fmt::format("{}: --out {}: must end in .svg, .png or .csv", o.command, printable(out)));
        check_output(o, out);
    }
    settings.points = o.points;
    settings.have_one_length = o.length == "one";
    settings.method = even_method_choice(o);
    return settings;
}

void write_icons(const std::filesystem::path& file, const Icons& icons, const VectorField& field, int pixels)
{
    MarkPicture picture = icon_picture(icons, field);
    if (file.extension() == ".csv") {
        write_whole_file(file, icons_csv(icons));
        return;
    }
    picture.pixels = pixels;
    const Drawing drawing = draw_marks(picture, {});
    if (file.extension() == ".svg")
        write_whole_file(file, drawing_svg(drawing));
    else
        write_drawing_png(file, drawing, pixels);
}

void draw_icons(const IconOptions& o)
{
    const IconSettings settings = checked_icons(o);
    try {
        const VectorField field = read_field(settings);
        const SquarePoints points = even_points(chosen_method(settings.method), settings.points, field.u.width,
                                                field.u.height, o.seed, make_place(o));
        const Icons icons = icons_at(points, field, settings.have_one_length);
        for (const std::string& out : o.outs) write_icons(out, icons, field, static_cast<int>(o.pixels));
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", o.command, error.what()));
    }
}

}

Command distribute_icons_command()
{
    const auto o = std::make_shared<IconOptions>();
    o->command = "distribute icons";
    const std::vector<Option> of_field{
        {"--field", &o->settings.field, "A picture whose first two channels are the vectors", "IMAGE"},
        {"--u", &o->settings.u, "The vectors to the right", "FORMULA", optional, 1, "--field"},
        {"--v", &o->settings.v, "The vectors upwards", "FORMULA", optional, 1, "--field"}};
    const std::vector<Option> own{
        {"--length", &o->length, "Of arrows: magnitude (the default), or one for all", "NAME"},
        {"--out", &o->outs, "A file, .svg, .png or .csv; may be repeated", "FILE", required},
        allowing({"--pixels", &o->pixels, "The width of a .png; default: 1024", "W"}, integers(1, most_icon_pixels))};
    return {"icons", "Show a vector field by arrows that do not overlap",
            joined({of_field, even_point_options(*o), own, device_options(*o)}), distribute_icons_notes,
            action_on(o, draw_icons)};
}

}
