// The pictures of a tile set or tiling: its tiles or their regions, and the autocorrelation of its colours.
//
// The pictures of constructions of a report.
#pragma once

#include "reports/images/picture_store.hpp"
#include "results/run.hpp"

#include <filesystem>
#include <string>

namespace poissonlab {

/// One tile set or tiling of the report.
struct ReportTiling
{
    const Run* run = nullptr; ///< the runs outlive this
    const TilingResult* stored = nullptr;
    std::filesystem::path pictures; ///< folder of its pictures
};

/// The range of autocorrelation pictures from black to white: z from -6 to 6.
inline constexpr double shown_z = 6;

/// The picture of an autocorrelation, for example "corners-autocorrelation.png".
inline std::string autocorrelation_picture(const ColorStatistics& colors)
{
    return std::filesystem::path(colors.autocorrelation_file).stem().string() + ".png";
}

/// Writes tiles.svg, tiles.png and a picture of each autocorrelation. Throws InputError when stored files are
/// not what results.json says.
void draw_tiling_pictures(const ReportTiling& tiling, PictureStore& store);

/// One picture of a construction.
struct ReportConstruction
{
    const Run* run = nullptr; ///< the runs outlive this
    const ConstructionResult* stored = nullptr;
    Scene scene;
    std::filesystem::path pictures; ///< folder of its picture
};

/// True where the panels are steps, one after the other: those of a method that makes a set, and the stages of a tile.
bool has_steps(const ReportConstruction& construction);

/// True for steps of a method that makes a point set, which are many.
bool is_set(const ReportConstruction& construction);

/// The page of the steps.
std::filesystem::path steps_page_of(const ReportConstruction& construction);

/// The scene as pictures have it: of many steps some, from the first to the last.
Scene pictured_scene(const ReportConstruction& construction);

/// Writes construction.svg and construction.png.
void draw_construction_picture(const ReportConstruction& construction, PictureStore& store);

}
