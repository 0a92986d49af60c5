// These functions stand in for results with tiles, pictures of these, and claims about them, where a program lacks
// them: a result that has tiles asks for the module.
#include "base/errors/missing_module.hpp"
#include "reports/claims/paper_claims.hpp"
#include "reports/drawings/construction_image.hpp"
#include "reports/layout/overlay_panels.hpp"
#include "reports/layout/tiling_pictures.hpp"
#include "reports/pages/page.hpp"
#include "reports/pages/page_endless.hpp"
#include "reports/pages/page_parts.hpp"

namespace poissonlab {
namespace {

constexpr auto module_of_tiles = "tilings";

}

std::vector<PaperClaim> claims_about_tiles()
{
    return {{"", "6.0", "", "", [](const ClaimSeries& report) -> std::optional<ClaimOutcome> {
                 if (report.has_tiles()) throw MissingModule(module_of_tiles);
                 return std::nullopt;
             }}};
}

std::vector<Paper> papers_on_tiles() { return {}; }

Paper paper_on_even_tilings() { return {}; }

void members(JsonMembers& /*m*/, const TilingResult& /*tiling*/) { throw MissingModule(module_of_tiles); }
void members(JsonMembers& /*m*/, TilingResult& /*tiling*/) { throw MissingModule(module_of_tiles); }

void members(JsonMembers& /*m*/, const ConstructionResult& /*construction*/) { throw MissingModule(module_of_tiles); }
void members(JsonMembers& /*m*/, ConstructionResult& /*construction*/) { throw MissingModule(module_of_tiles); }

bool has_steps(const ReportConstruction& /*construction*/) { throw MissingModule(module_of_tiles); }

std::filesystem::path steps_page_of(const ReportConstruction& /*construction*/)
{
    throw MissingModule(module_of_tiles);
}

void draw_construction_picture(const ReportConstruction& /*construction*/, PictureStore& /*store*/)
{
    throw MissingModule(module_of_tiles);
}

/// Claims ask for the module where sets are made of tiles.
std::vector<Panel> region_panels(const SeriesList& /*series*/) { return {}; }
std::vector<Panel> tile_radius_panels(const SeriesList& /*series*/) { return {}; }

Scene read_scene(const std::filesystem::path& /*file*/) { throw MissingModule(module_of_tiles); }

Drawing draw_construction(const Scene& /*scene*/) { throw MissingModule(module_of_tiles); }

void draw_tiling_pictures(const ReportTiling& /*tiling*/, PictureStore& /*store*/)
{
    throw MissingModule(module_of_tiles);
}

PageData tiling_section(const ReportTiling& /*tiling*/, std::size_t /*index*/, const std::filesystem::path& /*from*/)
{
    throw MissingModule(module_of_tiles);
}

PageData construction_section(const ReportConstruction& /*construction*/, std::size_t /*index*/,
                              const std::filesystem::path& /*from*/)
{
    throw MissingModule(module_of_tiles);
}

std::string render_endless_page(const Site& /*site*/, const ReportSeries& /*series*/)
{
    throw MissingModule(module_of_tiles);
}

std::string render_steps_page(const Site& /*site*/, const ReportRun& /*run*/,
                              const ReportConstruction& /*construction*/)
{
    throw MissingModule(module_of_tiles);
}

}
