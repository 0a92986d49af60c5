// Looking into an HTML page without a browser.
#pragma once

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

/// The bytes of a "data:...;base64,..." URI.
std::string decode_data_uri(const std::string& uri);

}
