// Judged claims as a table, and those that come with the program.
#pragma once

#include "reports/claims/paper_claims.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace poissonlab {

/// A line of a table of claims.
struct StoredClaim
{
    std::string paper;   ///< as HTML: authors, title, year
    std::string section; ///< empty: the paper as a whole
    std::string id;
    std::vector<std::string> samplers; ///< of the methods that it is about; empty: tilings and the like
    std::string agreement;             ///< as name_of() has it
    std::string says;
    std::string criterion;
    std::string measured;
};

/// paper,section,claim,samplers,agreement,says,criterion,measured; samplers with blanks between them.
std::string claims_csv(const std::vector<JudgedClaim>& claims);

/// The lines of such a table. Throws InputError with its line.
std::vector<StoredClaim> read_claims(std::string_view table);

/// The claims that come with the program, judged by results of its own: docs/gallery/claims.csv.
const std::vector<StoredClaim>& reference_claims();

}
