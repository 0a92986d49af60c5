#include "reports/claims/paper_claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace poissonlab {

Agreement Tally::agreement() const
{
    if (held_ == cases_) return Agreement::agrees;
    return 2 * held_ >= cases_ ? Agreement::partly : Agreement::disagrees;
}

std::string Tally::words() const
{
    return cases_ < 2 ? std::string() : fmt::format("holds in {} of {} cases", held_, cases_);
}

const std::vector<PaperClaim>& paper_claims()
{
    static const std::vector<PaperClaim> claims = [] {
        auto all = claims_about_untiled_sets();
        std::ranges::move(claims_about_accelerated_darts(), std::back_inserter(all));
        std::ranges::move(claims_about_early_tiles(), std::back_inserter(all));
        std::ranges::move(claims_about_recursive_tiles(), std::back_inserter(all));
        std::ranges::move(claims_about_penrose_tilings(), std::back_inserter(all));
        std::ranges::move(claims_about_tiles(), std::back_inserter(all));
        std::ranges::move(claims_about_patterns(), std::back_inserter(all));
        std::ranges::move(recommendations(), std::back_inserter(all));
        // Sections are 6.3 or 6.2.2; claims of one section stay together, in their order.
        const auto section = [](const PaperClaim& claim) { return std::stoi(claim.section.substr(2)); };
        std::ranges::stable_sort(all, {}, section);
        return all;
    }();
    return claims;
}

std::vector<JudgedClaim> judge_claims(const std::vector<const ReportSeries*>& series)
{
    const ClaimSeries finder(series);
    std::vector<JudgedClaim> judged;
    for (const auto& claim : paper_claims())
        if (auto outcome = claim.measure(finder)) judged.push_back({&claim, std::move(*outcome)});
    return judged;
}

}
