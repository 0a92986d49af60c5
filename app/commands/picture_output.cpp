#include "app/commands/picture_output.hpp"

#include "app/commands/point_target.hpp"
#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

constexpr double pixels_a_unit = 2;

}

void check_picture_file(const std::string& command, const std::filesystem::path& file)
{
    if (file.extension() != ".svg" && file.extension() != ".png")
        throw InputError(fmt::format("{}: --out {}: must end in .svg or .png", command, file.string()));
    check_target_folder(command, file);
}

void write_picture_file(const std::filesystem::path& file, const Drawing& drawing, int pixels)
{
    const int usual = std::min(max_drawing_pixels, static_cast<int>(std::ceil(pixels_a_unit * drawing.width)));
    if (file.extension() == ".svg")
        write_whole_file(file, drawing_svg(drawing));
    else
        write_drawing_png(file, drawing, pixels > 0 ? pixels : usual);
}

}
