// These functions stand in for claims about methods that only a module has, where a program lacks it: a result that has
// such sets asks for the module.
#include "base/errors/missing_module.hpp"
#include "reports/claims/paper_claims.hpp"

namespace poissonlab {
namespace {

std::vector<PaperClaim> claim_about(const char* sampler)
{
    return {{"", "6.0", "", "", [sampler](const ClaimSeries& report) -> std::optional<ClaimOutcome> {
                 for (const int dimension : {2, 3})
                     if (report.one({.sampler = sampler, .dimension = dimension})) throw MissingModule("methods");
                 return std::nullopt;
             }}};
}

}

std::vector<PaperClaim> claims_about_jones() { return claim_about("voronoi-darts"); }

std::vector<PaperClaim> claims_about_sector_darts() { return claim_about("sector-darts"); }

}
