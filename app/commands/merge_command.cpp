// poissonlab merge: finished work of several output folders, such as those of shards, into one.
#include "app/commands/commands.hpp"
#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"
#include "host/store/unit_store.hpp"

#include <fmt/format.h>

namespace poissonlab {

void merge_command(const MergeOptions& options)
{
    for (const std::filesystem::path& folder : options.folders)
        if (!std::filesystem::is_directory(folder / unit_folder_name))
            throw InputError(fmt::format("merge: {}: has no {} folder; output folders of `run --shard` are needed",
                                         folder.string(), unit_folder_name));
    UnitStore store(options.out / unit_folder_name);
    Progress progress(Progress::detect(options.quiet));
    for (const std::filesystem::path& folder : options.folders) {
        const std::size_t count = store.merge(UnitStore(folder / unit_folder_name), [&](std::size_t done) {
            stop_if_interrupted();
            progress.step(fmt::format("{}: {} units", folder.string(), done));
        });
        progress.message(fmt::format("{}: {} units taken over", folder.string(), count));
    }
}

}
