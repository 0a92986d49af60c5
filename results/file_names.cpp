#include "results/file_names.hpp"

#include <fmt/format.h>

namespace poissonlab::file_names {

std::string realization(std::uint32_t number) { return fmt::format("realization-{:03}.dat", number); }

}
