// Configs that ship, at sizes that tests have time for.
#pragma once

#include <string>

namespace poissonlab::test {

/// A config's text with smaller numbers: fewer points, realizations, colours, moves, smaller tiles and pictures.
/// Methods and tables stay all as they are, so that reports have the same sections.
std::string small_config(const std::string& toml);

}
