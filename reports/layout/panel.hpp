// A picture of a page as a value: what is drawn, under which name, and all that is said about it. A picture is added to
// the report by a function that makes such a value, in one of the files *_panels.cpp; drawing it, the page, its links
// and its guide follow.
#pragma once

#include "reports/drawings/cells_image.hpp"
#include "reports/drawings/points_image.hpp"
#include "reports/plots/plot.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace poissonlab {

/// A picture of a stored spectrum.
struct SpectrumPicture
{
    enum class Part
    {
        whole, ///< the 2D spectrum, or the three coordinate planes of a 3D one
        cube,
        slices,
        close_ups,
        autocorrelation, ///< of a 2D spectrum: its transform
    };
    std::filesystem::path file;
    int size = 0; ///< frequencies along each axis, as results.json says
    int dimension = 2;
    Part part = Part::whole;
    PeriodicBox box{}; ///< that the sets lie in
};

/// A picture of the stored samples of the zone plate.
struct ZonePlatePicture
{
    std::filesystem::path file;
    int size = 0; ///< pixels along each axis, as results.json says
};

/// A picture of a stored image whose mean is 1.
struct DensityPicture
{
    std::filesystem::path file;
    int size = 0; ///< pixels along each axis, as results.json says
};

/// A stored picture of marks, see mark_picture.hpp.
struct MarkPanel
{
    std::filesystem::path file;
};

/// A stored result that a picture shows, and what a link to it says.
struct StoredFile
{
    std::string words;
    std::filesystem::path file;
};

/// A small picture of the same for tables and lists, drawn beside it as <stem>-thumbnail.png, of plots .svg.
struct Thumbnail
{
    std::string kind; ///< for the buttons of tables: "spectrum", "plate", "radial" or "points"
    std::string name; ///< for readers
};

struct Panel
{
    std::string stem; ///< name of its files, without extension
    std::variant<Plot, PointsView, CellsView, SpectrumPicture, ZonePlatePicture, DensityPicture, MarkPanel> picture;
    std::string title;
    std::string caption = {};
    std::string guide = {}; ///< how to read it, as HTML; empty: that is said elsewhere
    std::vector<StoredFile> stored = {};
    std::optional<Thumbnail> thumbnail = {};
    std::string image_class = "ink";
    std::string figure_class = {};

    const Plot* plot() const { return std::get_if<Plot>(&picture); }
};

/// The names of a panel's files, in its folder.
std::string shown_file(const Panel& panel);     ///< on the page
std::string full_size_file(const Panel& panel); ///< one click away
std::string thumbnail_file(const Panel& panel); ///< of a panel that has a thumbnail
std::string print_file(const Panel& panel); ///< the PNG; of a plot it is there only where print pictures were asked for

}
