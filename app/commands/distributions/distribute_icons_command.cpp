// poissonlab distribute icons: arrows that show a vector field and cannot overlap.
#include "app/commands/kind_options.hpp"
#include "app/commands/output_file.hpp"
#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "host/distribution/distribution_run.hpp"
#include "host/distribution/icons.hpp"
#include "host/distribution/runs/run_numbers.hpp"
#include "host/kinds/kinds.hpp"
#include "reports/drawings/mark_image.hpp"

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

void write_icons(const std::filesystem::path& file, const Icons& icons, const VectorField& field, int pixels)
{
    if (file.extension() == ".csv") return write_whole_file(file, icons_csv(icons));
    MarkPicture picture = icon_picture(icons, field);
    picture.pixels = pixels;
    write_picture_file(file, draw_marks(picture, {}), pixels);
}

void draw_icons(const KindOptions& o)
{
    const auto settings = o.read<IconSettings>();
    const VectorField field = read_field(settings);
    const SquarePoints points = even_points(chosen_method(settings.method), settings.points, field.u.width,
                                            field.u.height, o.seed(), o.place());
    const Icons icons = icons_at(points, field, settings.have_one_length);
    for (const std::filesystem::path& out : o.outs.files()) write_icons(out, icons, field, static_cast<int>(o.pixels));
    if (o.prints_json()) print_numbers(icon_numbers(icons, field, points.size() / 2));
}

}

Command distribute_icons_command()
{
    return kind_command(*find_kind("distribution", "icons"), {{{".svg", ".png", ".csv"}}}, distribute_icons_notes,
                        draw_icons, "", {most_icon_pixels, "1024", 1024});
}

}
