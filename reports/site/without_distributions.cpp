// These functions stand in for pages of distributions where a program has no module that makes any: results that have
// some ask for the module.
#include "base/errors/missing_module.hpp"
#include "reports/pages/page_parts.hpp"

namespace poissonlab {

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
