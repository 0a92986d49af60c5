// A picture of marks: polygons, disks, strokes and words, in the order in which they are drawn. It is stored as JSON,
// see docs/output-folder.md; reports draw it.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

/// Marks of one colour. Numbers are in units of the picture, y upwards.
struct MarkGroup
{
    std::string color = "#000000";                              ///< "#rrggbb"
    std::vector<std::array<double, 3>> disks{};                 ///< x, y, radius
    std::vector<std::array<double, 5>> strokes{};               ///< x, y, x, y of the ends, width
    std::vector<std::vector<std::array<double, 2>>> polygons{}; ///< of three corners or more; drawn before the others

    bool operator==(const MarkGroup&) const = default;
};

/// Words around a place.
struct MarkWords
{
    std::array<double, 2> place{};
    double size = 0; ///< of the font
    std::string words;

    bool operator==(const MarkWords&) const = default;
};

struct MarkPicture
{
    double width = 1;
    double height = 1;
    int pixels = 1024;    ///< of the picture's width, where it is drawn in pixels
    std::string ground{}; ///< a PNG in the same folder, drawn below all marks over the whole width; empty: white
    std::vector<MarkGroup> groups{};
    std::vector<MarkWords> words{}; ///< over all of them

    bool operator==(const MarkPicture&) const = default;
};

/// The text of its file.
std::string mark_picture_json(const MarkPicture& picture);

/// Reads that file. Throws InputError that names the file and the member.
MarkPicture read_mark_picture(const std::filesystem::path& file);

}
