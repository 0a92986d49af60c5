// Numbers and tables of pages that are written by hand, put in from the tables that come with the program.
#include "analysis/statistics/jackknife.hpp"
#include "app/commands/manual/manual.hpp"
#include "base/errors/errors.hpp"
#include "reports/claims/claim_table.hpp"
#include "reports/gallery/gallery.hpp"
#include "reports/gallery/sizes.hpp"
#include "reports/gallery/table_reader.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <sstream>
#include <vector>

namespace poissonlab {
namespace {

constexpr std::string_view marker = "<!--= ", marker_end = " -->", results_end = "<!--/-->";

std::string with_error(const Estimate& estimate, int decimals)
{
    if (!estimate.standard_error) return format_fixed(estimate.value, decimals);
    return format_estimate(estimate.value, estimate.standard_error, decimals).text();
}

/// An estimate of the gallery by the words "NAME KEY DECIMALS" of a source.
std::string gallery_number(std::istream& words, bool with_its_error)
{
    std::string name, key;
    int decimals = 0;
    words >> name >> key >> decimals;
    const auto& gallery = reference_gallery();
    const auto method = std::ranges::find(gallery, name, &GalleryMethod::name);
    if (method == gallery.end()) throw InputError("the gallery has no method " + name);
    const auto found = method->measures.find(key);
    if (found == method->measures.end()) throw InputError(fmt::format("{} has no measure {}", name, key));
    return with_its_error ? with_error(found->second, decimals) : format_fixed(found->second.value, decimals);
}

using StoredMeasures = std::map<std::pair<std::string, std::string>, Estimate>;

/// Measures of a table beside the gallery's own, by the names of series and keys.
StoredMeasures stored_measures(const std::string& file)
{
    StoredMeasures measures;
    for (TableReader line(gallery_file(file), file, "name,measure,value,standard_error"); line.next();)
        measures[{line.text(0), line.text(1)}] = line.estimate(2, 3);
    return measures;
}

/// A measure of a table beside the gallery's own: it is of several sets of tiles, with the error between them.
Estimate measure_of_sets(const StoredMeasures& measures, const std::string& name, const std::string& key)
{
    const auto found = measures.find({name, key});
    if (found == measures.end()) throw InputError(fmt::format("there is no {} of {}", key, name));
    if (!found->second.standard_error) throw InputError(fmt::format("{} of {} has no error between sets", key, name));
    return found->second;
}

std::string seam_table()
{
    const StoredMeasures measures = stored_measures("seams.csv");
    std::string text =
        "| colours | tiles | strips: mean peak | share | strips together: mean peak | share | chains: mean "
        "peak | share |\n| --- | --- | --- | --- | --- | --- | --- | --- |\n";
    for (const int colors : {2, 3, 4, 6}) {
        text += fmt::format(
            "| {} | {} |", colors,
            format_count(static_cast<std::uint64_t>(colors * colors) * static_cast<std::uint64_t>(colors * colors)));
        for (const char* border : {"repulsion", "repulsion-joint-20", "border-chain"}) {
            const std::string name = fmt::format("corner-tiles-C-{}-N-32-{}-sets-12", colors, border);
            const Estimate peak = measure_of_sets(measures, name, "near_lattice_peaks"),
                           share = measure_of_sets(measures, name, "lattice_excess");
            text += fmt::format(" {} | {} % |", format_estimate(peak.value, peak.standard_error).text(),
                                format_estimate(100 * share.value, 100 * *share.standard_error).text());
        }
        text += "\n";
    }
    return text;
}

/// The relative radius of averaged tiles after so many moves, over the sets of configs/averaged-tiles.toml.
std::string averaged_table()
{
    std::map<int, std::vector<double>> radii; // by moves
    constexpr const char* file = "averaged.csv";
    for (TableReader line(gallery_file(file), file, "realization,iteration,relative_radius"); line.next();)
        radii[static_cast<int>(line.number(1))].push_back(line.number(2));
    std::string text = "| moves | relative radius, mean of the sets | least | largest |\n| --- | --- | --- | --- |\n";
    for (const auto& [moves, each] : radii) {
        const auto [least, largest] = std::ranges::minmax(each);
        const double mean = std::accumulate(each.begin(), each.end(), 0.0) / static_cast<double>(each.size());
        text += fmt::format("| {} | {} | {} | {} |\n", format_count(static_cast<std::uint64_t>(moves)),
                            format_estimate(mean, standard_error_of_mean(each)).text(), format_fixed(least, 3),
                            format_fixed(largest, 3));
    }
    return text;
}

/// The exponents of configs/even.toml beside those that are proven.
std::string even_table()
{
    struct Row
    {
        const char *name, *title, *proven;
    };
    constexpr std::array rows{
        Row{"corner-tiles-C-3-N-32-repulsion-sets-6", "strips, as in the papers", "2"},
        Row{"corner-tiles-C-3-N-32-border-chain-moments-0-sets-6", "chains", "2"},
        Row{"corner-tiles-C-3-N-32-border-chain-moments-1-sets-6", "chains, equal first moments", "4"},
        Row{"corner-tiles-C-3-N-32-border-chain-moments-2-sets-6", "chains, equal first and second moments", "6"},
    };
    const StoredMeasures measures = stored_measures("even.csv");
    std::string text = "| | proven exponent | measured |\n| --- | --- | --- |\n";
    for (const Row& row : rows) {
        const Estimate exponent = measure_of_sets(measures, row.name, "hyperuniformity_exponent");
        text += fmt::format("| {} | {} | {} |\n", row.title, row.proven,
                            format_estimate(exponent.value, exponent.standard_error).text());
    }
    return text;
}

/// A cell of a table in Markdown.
std::string cell(std::string text)
{
    for (std::size_t at = 0; (at = text.find('|', at)) != text.npos; at += 2) text.insert(at, "\\");
    return text;
}

std::string claim_table(const std::string& agreement)
{
    std::string text = "| paper | section | says | agrees if | measured here |\n| --- | --- | --- | --- | --- |\n";
    for (const StoredClaim& claim : reference_claims())
        if (claim.agreement == agreement)
            text += fmt::format("| {} | {} | {} | {} | {} |\n", cell(claim.paper), claim.section, cell(claim.says),
                                cell(claim.criterion), cell(claim.measured));
    return text;
}

std::string stored_result(const std::string& source)
{
    std::istringstream words(source);
    std::string kind, agreement;
    words >> kind;
    if (kind == "measure" || kind == "value") return gallery_number(words, kind == "measure");
    if (kind == "scale") return "\n" + scale_table();
    if (kind == "seams") return "\n" + seam_table();
    if (kind == "even") return "\n" + even_table();
    if (kind == "averaged") return "\n" + averaged_table();
    if (kind == "sizes") return "\n" + size_table();
    if (kind == "claims" && words >> agreement) return "\n" + claim_table(agreement);
    throw InputError(
        fmt::format("\"{}\": must be measure, value, scale, seams, even, averaged, sizes or claims", source));
}

}

std::string with_stored_results(const std::string& page, const std::string& file)
{
    std::string text;
    std::size_t from = 0;
    for (std::size_t at = 0; (at = page.find(marker, from)) != page.npos;) {
        const int line =
            1 + static_cast<int>(std::count(page.begin(), page.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
        const std::size_t source = at + marker.size(), source_end = page.find(marker_end, source),
                          end = page.find(results_end, source);
        if (source_end == page.npos || end == page.npos || end < source_end)
            throw InputError::at({file, line}, fmt::format("<!--= must be closed by {}", results_end));
        text += page.substr(from, source_end + marker_end.size() - from);
        try {
            text += stored_result(page.substr(source, source_end - source));
        } catch (const InputError& error) {
            throw InputError::at({file, line}, error.what());
        }
        text += results_end;
        from = end + results_end.size();
    }
    return text + page.substr(from);
}

}
