// These functions stand in for pictures of sets in 3D, and claims about these, where a program lacks them: results in
// 3D ask for the module.
#include "base/errors/missing_module.hpp"
#include "reports/claims/paper_claims.hpp"
#include "reports/images/cube_image.hpp"

#include <algorithm>

namespace poissonlab {

GreyImage draw_spectrum_cube(const std::vector<Spectrum>& /*planes*/, const ToneMapping& /*tone_mapping*/,
                             double /*scale*/)
{
    throw MissingModule("space");
}

std::vector<PaperClaim> claims_about_spheres()
{
    return {{"", "6.0", "", "", [](const ClaimSeries& report) -> std::optional<ClaimOutcome> {
                 const auto is_in_space = [](const ReportSeries* series) { return series->run->dimension == 3; };
                 if (std::ranges::any_of(report.series(), is_in_space)) throw MissingModule("space");
                 return std::nullopt;
             }}};
}

}
