// These functions stand in for distributions and sets in regions where a program has no module that makes any: results
// that have some ask for the module.
#include "base/errors/missing_module.hpp"
#include "reports/drawings/mark_image.hpp"
#include "reports/layout/series_panels.hpp"
#include "reports/pages/page_parts.hpp"

namespace poissonlab {

void members(JsonMembers& /*m*/, const DistributionResult& /*distribution*/) { throw MissingModule("regions"); }
void members(JsonMembers& /*m*/, DistributionResult& /*distribution*/) { throw MissingModule("regions"); }

MarkPicture read_mark_picture(const std::filesystem::path& /*file*/) { throw MissingModule("regions"); }

Drawing draw_marks(const MarkPicture& /*picture*/, const std::filesystem::path& /*folder*/)
{
    throw MissingModule("regions");
}

Panel region_points_panel(const ReportSeries& /*series*/) { throw MissingModule("regions"); }

void add_region_panels(const ReportSeries& series, std::size_t /*index*/, std::vector<Panel>& /*panels*/)
{
    if (!series.region_curves.empty()) throw MissingModule("regions");
}

void lay_out_curves(ReportDistribution& /*distribution*/) { throw MissingModule("regions"); }

void draw_distribution_pictures(const ReportDistribution& /*distribution*/, PictureStore& /*store*/)
{
    throw MissingModule("regions");
}

std::filesystem::path png_of(const ReportDistribution& /*distribution*/, const DistributionPicture& /*picture*/)
{
    throw MissingModule("regions");
}

void set_distributions(PageData& page, const ReportRun& run, const std::filesystem::path& /*from*/)
{
    if (!run.distributions.empty() || !run.schemes.empty()) throw MissingModule("regions");
    for (const char* field : {"has_packings", "has_distributions", "has_schemes"}) page.set(field, false);
}

void set_textures(PageData& page, const ReportRun& run, const std::filesystem::path& /*from*/)
{
    if (!run.distributions.empty()) throw MissingModule("regions");
    for (const char* field : {"texture_groups", "has_textures", "has_texture_tables", "texture_notes"})
        page.set(field, false);
}

}
