// What two runs of the same config have in common.
#pragma once

#include "experiment/program.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <string>

namespace poissonlab {

/// Every file of an output folder but the pages, which show times, and in results.json all but times and what they were
/// measured on.
inline std::map<std::string, std::string> lasting_results(const std::filesystem::path& out)
{
    auto files = files_below(out);
    for (auto& [name, content] : files) {
        if (std::filesystem::path(name).filename() != "results.json") continue;
        auto json = nlohmann::json::parse(content);
        json.erase("machine");
        json.erase("command"); // names the folder
        for (auto& series : json["series"]) {
            series.erase("timing");
            series.erase("tile_set");
        }
        content = json.dump();
    }
    std::erase_if(files, [](const auto& file) { return file.first.ends_with(".html"); });
    return files;
}

}
