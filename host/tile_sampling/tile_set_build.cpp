#include "host/tile_sampling/tile_set_build.hpp"

#include "base/files/whole_file.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace poissonlab {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* format_name = "poissonlab-tile-set-build";

}

std::filesystem::path build_record_file(const std::filesystem::path& tile_set_file)
{
    return tile_set_file.string() + ".json";
}

void write_build_record(const std::filesystem::path& tile_set_file, const TileSetBuild& build)
{
    const Json json = {{"format", format_name},
                       {"format_version", 1},
                       {"build_seconds", build.seconds},
                       {"device", build.device},
                       {"threads", build.threads}};
    write_whole_file(build_record_file(tile_set_file), json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::optional<TileSetBuild> read_build_record(const std::filesystem::path& tile_set_file)
{
    const std::filesystem::path file = build_record_file(tile_set_file);
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) return std::nullopt;
    try {
        const Json json = Json::parse(read_whole_file(file));
        if (json.at("format") != format_name || json.at("format_version") != 1) return std::nullopt;
        const TileSetBuild build{json.at("build_seconds"), json.at("device"), json.at("threads")};
        if (!std::isfinite(build.seconds) || build.seconds < 0 || build.threads < 1) return std::nullopt;
        return build;
    } catch (const nlohmann::json::exception&) {
        return std::nullopt;
    } catch (const InputError&) {
        return std::nullopt;
    }
}

}
