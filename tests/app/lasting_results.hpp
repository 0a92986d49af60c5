// The results that two runs of the same config have in common.
#pragma once

#include "tests/support/program.hpp"

#include <filesystem>
#include <map>
#include <string>

namespace poissonlab {

/// Every file of an output folder but the pages, which show times, and in results.json all but times and what they were
/// measured on.
std::map<std::string, std::string> lasting_results(const std::filesystem::path& out);

}
