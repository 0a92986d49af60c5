#include "reports/claims/paper_claims.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace poissonlab {

namespace {

Paper dissertation()
{
    constexpr std::array parts{claims_about_methodology,  claims_about_darts,   claims_about_lloyd,
                               claims_about_building,     claims_about_spheres, claims_about_jones,
                               claims_about_sector_darts, claims_about_tiles,   recommendations};
    std::vector<PaperClaim> all;
    for (const auto& part : parts) std::ranges::move(part(), std::back_inserter(all));
    // Sections are 6.3 or 6.2.2; claims of one section stay together, in their order.
    const auto section = [](const PaperClaim& claim) {
        return std::pair(std::stoi(claim.section), std::stoi(claim.section.substr(2)));
    };
    std::ranges::stable_sort(all, {}, section);
    return {"lagae-2007", "Ares Lagae, <cite>Tile-Based Methods in Computer Graphics</cite> (2007)", std::move(all)};
}

}

const std::vector<Paper>& papers()
{
    static const std::vector<Paper> all = [] {
        std::vector<Paper> list{dissertation()};
        std::ranges::move(papers_on_tiles(), std::back_inserter(list));
        std::ranges::move(later_papers(), std::back_inserter(list));
        return list;
    }();
    return all;
}

std::vector<JudgedClaim> judge_claims(const std::vector<const ReportSeries*>& series,
                                      const std::vector<const DistributionResult*>& distributions)
{
    const ClaimSeries finder(series, distributions);
    std::vector<JudgedClaim> judged;
    for (const Paper& paper : papers())
        for (const PaperClaim& claim : paper.claims) {
            auto outcome = claim.measure(finder);
            auto samplers = finder.take_asked();
            if (outcome) judged.push_back({&paper, &claim, std::move(*outcome), std::move(samplers)});
        }
    return judged;
}

}
