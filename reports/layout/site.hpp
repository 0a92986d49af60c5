// A report as a small site: which pages there are, and what all of them share.
#pragma once

#include "reports/gallery/gallery.hpp"
#include "reports/gallery/gallery_use.hpp"
#include "reports/layout/series_curves.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

/// A page that the navigation of every page leads to.
struct SitePage
{
    std::string file; ///< in the report's folder
    std::string text;
};

/// Everything that pages are made of, and all pictures as values. Neither drawing nor rendering changes it.
struct Site
{
    std::filesystem::path out; ///< the report's folder
    std::string title;
    std::vector<ReportRun> runs;
    std::vector<Panel> overlays;                    ///< plots of the series of all runs; of one run, those of the run
    std::vector<SitePage> pages;                    ///< in the order of the navigation
    std::vector<const GalleryMethod*> gallery = {}; ///< of the dimensions that the series with spectra have
    Gallery gallery_use = Gallery::offered;

    bool has_several_runs() const { return runs.size() > 1; }
    std::vector<const ReportSeries*> series() const;

    /// The distributions and schemes of all runs.
    std::vector<const DistributionResult*> distributions() const;

    /// True if there is a compare page: at least two series have curves, or one that the gallery can lie behind.
    bool has_curves_to_compare() const;
};

/// Files of the site, in the report's folder.
inline constexpr auto overview_page = "index.html";
inline constexpr auto compare_page = "compare.html";
inline constexpr auto claims_page = "claims.html";

/// The folder of style sheet and scripts, in the report's folder.
inline constexpr auto asset_folder = "site";

/// The page of a series or a run.
std::filesystem::path page_of(const ReportSeries& series);
std::filesystem::path page_of(const ReportRun& run);

/// The file of the tile set of a series of tilings, where it is stored.
std::filesystem::path tile_set_of(const ReportSeries& series);

/// True for series of tilings with a tile set in the plane that is stored: endless_page_of() shows it.
bool has_endless_page(const ReportSeries& series);
std::filesystem::path endless_page_of(const ReportSeries& series);

/// The runs laid out, with all that is to be drawn. `title` may be empty: it is made of the runs'. Throws InputError.
Site make_site(const std::vector<Run>& runs, const std::filesystem::path& out, const std::string& title,
               Gallery gallery = Gallery::offered);

/// The series of all runs under names that tell them apart.
SeriesList series_of(const Site& site);

/// Writes the style sheet and the scripts.
void write_assets(const Site& site);

}
