#include "app/commands/output_file.hpp"

#include "base/errors/errors.hpp"
#include "base/files/output_place.hpp"
#include "base/files/standard_streams.hpp"
#include "base/files/whole_file.hpp"
#include "base/points/point_file_endings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <system_error>

#include <unistd.h>

namespace poissonlab {
namespace {

constexpr double pixels_a_unit = 2;

namespace fs = std::filesystem;

void check_ending(const std::string& begin, const fs::path& file, const OutputFormats& formats)
{
    std::vector<std::string> endings = formats.endings;
    if (formats.may_be_points)
        std::ranges::copy_if(point_file_endings(), std::back_inserter(endings), [&](const std::string& ending) {
            return std::ranges::find(formats.endings, ending) == formats.endings.end();
        });
    const std::string ending = file.extension().string();
    const bool is_known = ending.empty() ? formats.may_be_points || formats.may_lack_ending
                                         : std::ranges::find(endings, ending) != endings.end();
    if (!is_known) throw InputError(begin + "must end in " + either(endings));
}

/// Throws where the file could not be written in the end.
void check_place(const std::string& begin, const fs::path& file)
{
    std::error_code unknown;
    const OutputPlace place = output_place(file);
    const auto refuse_access = [&] {
        throw StorageError(begin + "cannot be written: " + std::generic_category().message(errno));
    };
    if (place.is_stream) {
        if (place.descriptor < 0 && ::access(place.stream.c_str(), W_OK) != 0) refuse_access();
        return;
    }
    const fs::path folder = place.file.has_parent_path() ? place.file.parent_path() : ".";
    if (!fs::is_directory(folder, unknown))
        throw InputError(begin + "there is no folder " + printable(folder.string()));
    if (fs::is_directory(place.file, unknown)) throw InputError(begin + "is a folder");
    const bool is_there = fs::exists(place.file, unknown);
    if (::access(folder.c_str(), W_OK | X_OK) != 0 || (is_there && ::access(place.file.c_str(), W_OK) != 0))
        refuse_access();
}

/// True for each name that standard output has, also once it is kept and has another number.
bool is_standard_output(const fs::path& name)
{
    if (names_standard_output(name)) return true;
    const int descriptor = output_place(name).descriptor;
    return descriptor >= 0 && (descriptor == STDOUT_FILENO || descriptor == kept_standard_output());
}

}

void write_picture_file(const std::filesystem::path& file, const Drawing& drawing, int pixels)
{
    const int usual = std::min(max_drawing_pixels, static_cast<int>(std::ceil(pixels_a_unit * drawing.width)));
    if (file.extension() == ".svg")
        write_whole_file(file, drawing_svg(drawing));
    else
        write_drawing_png(file, drawing, pixels > 0 ? pixels : usual);
}

fs::path output_name(const fs::path& file, const OutputFormats& formats)
{
    const bool is_text = formats.may_be_points || formats.may_lack_ending;
    return file == "-" && !is_text ? fs::path("-" + formats.endings.front()) : file;
}

fs::path checked_output(const std::string& command, const std::string& option, const fs::path& file,
                        const OutputFormats& formats)
{
    const std::string begin = fmt::format("{}: {} {}: ", command, option, printable(file.string()));
    if (file.empty()) throw InputError(begin + "must be the name of a file");
    const fs::path name = output_name(file, formats);
    check_ending(begin, name, formats);
    const bool is_alone = formats.with_second_file.empty() || name.extension() != formats.with_second_file;
    if (names_standard_output(name) && !is_alone)
        throw InputError(fmt::format("{}has a second file beside it, for which standard output has no place", begin));
    if (is_standard_output(name)) {
        if (kept_standard_output() >= 0) throw InputError(begin + "standard output takes one file");
        keep_standard_output();
        return name;
    }
    check_place(begin, name);
    return name;
}

std::string either(const std::vector<std::string>& words)
{
    if (words.size() < 2) return words.empty() ? "" : words.front();
    const std::vector<std::string> first(words.begin(), words.end() - 1);
    return fmt::format("{} or {}", fmt::join(first, ", "), words.back());
}

}
