// The claims about tiles, tilings and textures, which belong to no program that lacks these.
#include "reports/claims/paper_claims.hpp"

#include <array>
#include <iterator>

namespace poissonlab {

std::vector<PaperClaim> claims_about_tiles()
{
    constexpr std::array parts{claims_about_tilings,         claims_about_aperiodic_sets, claims_about_textures,
                               claims_about_early_tiles,     claims_about_peaks,          claims_about_recursive_tiles,
                               claims_about_penrose_tilings, claims_about_edge_tiles,     claims_about_template_tiles,
                               claims_about_corner_tiles,    claims_about_applications};
    std::vector<PaperClaim> all;
    for (const auto& part : parts) std::ranges::move(part(), std::back_inserter(all));
    return all;
}

std::vector<Paper> papers_on_tiles()
{
    std::vector<Paper> papers = papers_on_textures();
    papers.push_back({"notes-2008",
                      "Lagae, Kaplan, Fu, Ostromoukhov, Kopf and Deussen, <cite>Tile-Based Methods for Interactive "
                      "Applications</cite>, class notes (2008)",
                      claims_about_polyominoes()});
    return papers;
}

}
