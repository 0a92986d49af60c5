#include "host/tile_sampling/penrose/penrose_table_cache.hpp"

#include "code_hashes.hpp"
#include "host/tile_sampling/penrose/penrose_relaxation.hpp"

#include <fmt/format.h>

namespace poissonlab {

std::string penrose_table_name() { return fmt::format("penrose-{}.table", POISSONLAB_SAMPLING_VERSION); }

BuiltOnce<PenroseTable> cached_penrose_table(const std::filesystem::path& folder,
                                             const std::function<void(const std::string& what)>& on_step)
{
    return built_once(
        folder.empty() ? folder : folder / penrose_table_name(), on_step, read_penrose_table,
        [&] { return relaxed_penrose_table({}, on_step); }, write_penrose_table);
}

}
