#include "reports/claims/claim_table.hpp"

#include "base/text/csv_fields.hpp"
#include "reports/gallery/table_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iterator>
#include <sstream>

namespace poissonlab {
namespace {

constexpr std::string_view claims_file = "claims.csv";
constexpr std::string_view claims_header = "paper,section,claim,samplers,agreement,says,criterion,measured";

std::vector<std::string> words_between_blanks(const std::string& text)
{
    std::istringstream words(text);
    return {std::istream_iterator<std::string>(words), {}};
}

}

std::string claims_csv(const std::vector<JudgedClaim>& claims)
{
    std::string table = fmt::format("{}\n", claims_header);
    for (const JudgedClaim& judged : claims)
        fmt::format_to(std::back_inserter(table), "{},{},{},{},{},{},{},{}\n", csv_quoted(judged.paper->title),
                       csv_quoted(judged.claim->section), judged.claim->id, fmt::join(judged.samplers, " "),
                       name_of(judged.outcome.agreement), csv_quoted(judged.claim->says),
                       csv_quoted(judged.claim->criterion), csv_quoted(judged.outcome.measured));
    return table;
}

std::vector<StoredClaim> read_claims(std::string_view table)
{
    std::vector<StoredClaim> claims;
    for (TableReader line(table, claims_file, claims_header); line.next();)
        claims.push_back({line.text(0), line.text(1), line.text(2), words_between_blanks(line.text(3)), line.text(4),
                          line.text(5), line.text(6), line.text(7)});
    return claims;
}

const std::vector<StoredClaim>& reference_claims()
{
    static const std::vector<StoredClaim> claims = read_claims(gallery_file(claims_file));
    return claims;
}

}
