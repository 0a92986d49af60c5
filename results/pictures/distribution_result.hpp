// Points and objects that follow a density, as a result: the member "distributions" of results.json. Kinds differ in
// what they measure and show, so both are lists, which reports print as they are.
#pragma once

#include <string>
#include <vector>

namespace poissonlab {

class JsonMembers;

/// A number that was measured.
struct DistributionNumber
{
    std::string key;
    std::string title;
    double value = 0;
    std::string meaning; ///< in a few words, with the unit

    bool operator==(const DistributionNumber&) const = default;
};

/// A picture: pixels as they are (.png), or marks that reports draw (.json, see mark_picture.hpp).
struct DistributionPicture
{
    std::string file; ///< relative to the run's folder
    std::string caption;

    bool operator==(const DistributionPicture&) const = default;

    bool has_marks() const { return file.ends_with(".json"); }
};

struct DistributionResult
{
    std::string name; ///< its folder
    std::string label;
    std::string kind;               ///< the word in the config
    std::vector<std::string> facts; ///< from which it was made
    std::vector<DistributionNumber> numbers;
    std::vector<DistributionPicture> pictures; ///< at least one
    std::vector<std::string> files;            ///< others, such as points; relative to the run's folder

    bool operator==(const DistributionResult&) const = default;
};

void members(JsonMembers& m, const DistributionResult& distribution);
void members(JsonMembers& m, DistributionResult& distribution);

}
