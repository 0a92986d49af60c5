// Looking into an HTML page without a browser.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace poissonlab::test {

/// Empty, or the first place where tags are not properly nested or attributes not quoted.
/// The page's own dialect: void elements are closed (<img/>), everything else has an end tag.
std::string first_markup_error(const std::string& page);

/// The values of all attributes of that name, as written.
std::vector<std::string> attribute_values(const std::string& page, const std::string& name);

/// The page without the contents of data URIs, whose base64 may spell anything.
std::string without_data_uris(const std::string& page);

/// All pages of a site, by their paths below its folder.
std::map<std::string, std::string> pages_below(const std::filesystem::path& folder);

/// The faults of the pages, a line each: markup, ids that are there twice, links and sources that lead nowhere or
/// to the network, pictures without alternative text. Empty: nothing.
std::string site_errors(const std::filesystem::path& folder);

/// The number of times that a text is there.
std::size_t count_of(const std::string& text, const std::string& part);

}
