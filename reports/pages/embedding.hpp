// Files inside the page and links to files beside it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace poissonlab {

/// Base64 with padding, RFC 4648.
std::string base64(std::string_view bytes);

/// A picture (.png or .svg) as data:image/...;base64,... Throws InputError when it cannot be read.
std::string data_uri(const std::filesystem::path& picture);

/// The relative link from a folder to a file, with everything but unreserved characters percent-encoded.
std::string relative_link(const std::filesystem::path& from_folder, const std::filesystem::path& file);

}
