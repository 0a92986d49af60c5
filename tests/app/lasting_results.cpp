#include "tests/app/lasting_results.hpp"

#include <nlohmann/json.hpp>

namespace poissonlab {

std::map<std::string, std::string> lasting_results(const std::filesystem::path& out)
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
