// The pictures of distributions of a report: those of marks are drawn here, others are stored as they are shown.
//
// The pictures of points in a region of the plane: their curves beside those of random points.
#pragma once

#include "analysis/regions/region_curve_row.hpp"
#include "reports/images/picture_store.hpp"
#include "reports/layout/panel.hpp"
#include "results/run.hpp"

#include <filesystem>
#include <vector>

namespace poissonlab {

/// One distribution of the report.
struct ReportDistribution
{
    const Run* run = nullptr; ///< the runs outlive this
    const DistributionResult* stored = nullptr;
    std::filesystem::path pictures; ///< folder of its pictures
    std::vector<Panel> curves{};    ///< of points in a region, and those that it stores
};

/// Texture tiles and tile packings have sections of their own.
inline bool is_of_textures(const ReportDistribution& distribution) { return distribution.stored->is_texture(); }
inline bool is_of_packings(const ReportDistribution& distribution) { return distribution.stored->kind == "packing"; }

/// Is true of all others.
inline bool is_of_densities(const ReportDistribution& distribution)
{
    return !is_of_textures(distribution) && !is_of_packings(distribution);
}

/// Reads what curves show, where there are some. Throws InputError when stored files are not what they should be.
void lay_out_curves(ReportDistribution& distribution);

/// The PNG of a picture: drawn, or the stored one.
std::filesystem::path png_of(const ReportDistribution& distribution, const DistributionPicture& picture);

/// True of pictures in dots or strokes, which are as dark as the ink that is asked for.
bool shows_tones(const ReportDistribution& distribution);

/// A copy of such a picture whose bytes are light, not sRGB: browsers take means of bytes where they scale a picture,
/// and the page's filter encodes what they show.
std::filesystem::path light_copy_of(const ReportDistribution& distribution, const DistributionPicture& picture);

/// Writes a PNG, and an SVG unless there is a ground, for each picture of marks. Throws InputError when stored files
/// are not what they should be.
void draw_distribution_pictures(const ReportDistribution& distribution, PictureStore& store);

/// The sets that curves are of.
struct RegionSets
{
    double intensity = 0;     ///< points per square of the region's units
    std::size_t envelope = 0; ///< random sets beside them
    bool has_density = false;
    double covariance_error = 0;
    std::filesystem::path file; ///< of the curves
    bool is_in_metres = false;
};

/// Curves of a series, or of another set, in the colour of that index.
std::vector<Panel> region_curve_panels(const std::vector<RegionCurveRow>& rows, const RegionSets& sets,
                                       std::size_t index);

}
