// The frame of every page of the site: head, navigation, and what the page says.
//
// Links from pages to files beside them.
#pragma once

#include "reports/layout/site.hpp"
#include "reports/pages/page_parts.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

struct PageFrame
{
    std::filesystem::path file;       ///< where the page will lie; links are relative to its folder
    std::string title;                ///< of the window
    std::vector<std::string> scripts; ///< more of them, by their names in asset_folder
};

/// The whole page: the frame around reports/templates/<name>.mustache, rendered with `data`. Templates may use the
/// partials panel, overlay, guide, provenance, endless_view and distribution. Throws std::logic_error
/// for a field that a template names and `data` has not.
std::string render_in_frame(const Site& site, const PageFrame& frame, const std::string& name, PageData& data);

/// The page of the template alone, for parts of pages.
std::string render_template(const std::string& name, PageData& data);

/// The relative link from a folder to a file, with everything but unreserved characters percent-encoded.
std::string relative_link(const std::filesystem::path& from_folder, const std::filesystem::path& file);

}
