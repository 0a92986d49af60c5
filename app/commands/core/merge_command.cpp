// poissonlab merge: finished work of several output folders, such as those of shards, into one.
#include "app/commands/work_options.hpp"
#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"
#include "base/text/noun.hpp"
#include "experiment/run/progress.hpp"
#include "experiment/store/unit_store.hpp"
#include "results/own_files.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace poissonlab {
namespace {

constexpr auto merge_notes =
    R"(Copies what is stored in DIR/.units and not in OUT/.units; what is damaged is left out. Then the same run writes
the results:
  poissonlab merge out/shard-1 out/shard-2 out/shard-3 --out out/all
  poissonlab run config.toml --out out/all)";

struct MergeOptions
{
    std::filesystem::path out;
    std::vector<std::filesystem::path> folders;
    bool quiet = false;
    bool as_json = false;
};

void merge(const MergeOptions& options)
{
    for (const std::filesystem::path& folder : options.folders)
        if (!std::filesystem::is_directory(folder / unit_folder_name))
            throw InputError(fmt::format("merge: {}: has no {} folder; output folders of `run --shard` are needed",
                                         folder.string(), unit_folder_name));
    check_output_folder(options.out, "merge: ");
    UnitStore store(options.out / unit_folder_name);
    auto merged = nlohmann::ordered_json::array();
    Progress progress(Progress::detect(options.quiet || options.as_json));
    for (const std::filesystem::path& folder : options.folders) {
        const std::size_t count = store.merge(UnitStore(folder / unit_folder_name), [&](std::size_t done) {
            stop_if_interrupted();
            progress.step(fmt::format("{}: {} {}", folder.string(), done, noun(done, "unit")));
        });
        progress.message(fmt::format("{}: {} {} taken over", folder.string(), count, noun(count, "unit")));
        merged.push_back({{"folder", printable(folder.string())}, {"units", count}});
    }
    if (options.as_json)
        fmt::print("{}\n",
                   nlohmann::ordered_json{{"out", printable(options.out.string())}, {"merged", merged}}.dump(2));
}

}

Command merge_command()
{
    const auto o = std::make_shared<MergeOptions>();
    return {"merge",
            "Take over finished work of other output folders, such as those of shards",
            {{"DIR", &o->folders, "Output folders of `run --shard`"},
             {"--out", &o->out, "The output folder that gets it", "OUT REQUIRED", required},
             quiet_option(o->quiet),
             json_option(o->as_json, "Print how many units were taken over as JSON")},
            merge_notes,
            action_on(o, merge)};
}

}
