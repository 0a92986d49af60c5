// JSON files, read with errors that say where they are wrong.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <string_view>

namespace poissonlab {

/// Reads a JSON file. Throws InputError for files that cannot be read and what parsed_json() throws.
nlohmann::json read_json_file(const std::filesystem::path& file);

/// The value of a JSON text; `name` is what messages call it. Throws InputError, `name:line: is not JSON: ...`, also
/// for values that are nested deeper than any that this program writes: what looks at values calls itself for each
/// level.
nlohmann::json parsed_json(std::string_view text, const std::string& name);

/// Does a text begin as one of GeoJSON does?
bool begins_as_geojson(std::string_view text);

/// The value of a text of GeoJSON. A sequence of values, one a line (RFC 8142, with or without its separators), becomes
/// a FeatureCollection. Throws InputError as parsed_json() does.
nlohmann::json parsed_geojson(std::string_view text, const std::string& name);

}
