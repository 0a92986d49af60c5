// The page that holds the claims of papers against what was measured.
#include "base/word_table.hpp"
#include "reports/claims/paper_claims.hpp"
#include "reports/pages/page.hpp"
#include "reports/pages/page_frame.hpp"
#include "reports/pages/page_parts.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {

namespace {

/// Marks an agreement for those who do not see colours.
const char* mark_of(Agreement agreement)
{
    constexpr WordTable<Agreement, 5> words{{{{Agreement::agrees, "✓"},
                                              {Agreement::partly, "◐"},
                                              {Agreement::disagrees, "✗"},
                                              {Agreement::open, "?"},
                                              {Agreement::shown, "–"}}}};
    return words[agreement];
}

PageData row(const JudgedClaim& judged)
{
    const Agreement agreement = judged.outcome.agreement;
    PageData data;
    data.set("id", "claim-" + judged.claim->id);
    data.set("section", judged.claim->section);
    data.set("says", judged.claim->says);
    data.set("criterion", judged.claim->criterion);
    data.set("measured", judged.outcome.measured);
    data.set("agreement", name_of(agreement));
    data.set("mark", mark_of(agreement));
    return data;
}

std::string summary(const std::vector<JudgedClaim>& claims)
{
    const auto count = [&](Agreement agreement) {
        return std::ranges::count(claims, agreement, [](const auto& judged) { return judged.outcome.agreement; });
    };
    return fmt::format("{} claims: {} agree, {} in part, {} disagree, {} open; {} shown and not judged.", claims.size(),
                       count(Agreement::agrees), count(Agreement::partly), count(Agreement::disagrees),
                       count(Agreement::open), count(Agreement::shown));
}

/// True if the criterion or the outcome of a claim has these words, which the page then explains.
bool mentions(const std::vector<JudgedClaim>& claims, const std::string& words)
{
    return std::ranges::any_of(claims, [&](const JudgedClaim& judged) {
        return judged.claim->criterion.find(words) != std::string::npos ||
               judged.outcome.measured.find(words) != std::string::npos;
    });
}

}

std::string render_claims_page(const Site& site, const std::vector<JudgedClaim>& claims)
{
    PageData list{PageData::type::list};
    for (const Paper& paper : papers()) {
        PageData rows{PageData::type::list};
        for (const auto& judged : claims)
            if (judged.paper == &paper) rows << row(judged);
        if (rows.is_empty_list()) continue;
        PageData data;
        data.set("id", "paper-" + paper.key);
        data.set("title", paper.title);
        data.set("rows", rows);
        list << data;
    }
    PageData page;
    page.set("papers", list);
    page.set("summary", summary(claims));
    page.set("explains_peaks", mentions(claims, "mean peak"));
    page.set("explains_plates", mentions(claims, "false plate"));
    return render_in_frame(site, {site.out / claims_page, "The papers' claims · " + site.title, {}}, "claims", page);
}

}
