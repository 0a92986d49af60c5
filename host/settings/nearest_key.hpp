// "Did you mean ...": the known word that is nearest to a misspelt one.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace poissonlab {

/// The Damerau-Levenshtein distance (optimal string alignment): how many insertions, deletions, replacements
/// and swaps of neighbouring letters turn `a` into `b`. Letter case counts; bytes, not characters.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The known word at the smallest distance from `word`, the first of several; empty when none is near enough
/// to be what was meant (more than a third of its letters differ, and more than two).
std::string nearest_key(std::string_view word, const std::vector<std::string>& known);

/// `; did you mean "points"?`, or nothing when no known word is near.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& known);

}
