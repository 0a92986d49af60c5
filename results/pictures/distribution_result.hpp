// Points and objects that follow a density, texture tiles and tile packings, and schemes of tilings, as results: the
// members "distributions" and "schemes" of results.json. Kinds differ in what they measure and show, so all are lists,
// which reports print as they are.
#pragma once

#include <optional>
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
    std::string meaning;                       ///< in a few words, with the unit
    std::optional<double> standard_error = {}; ///< over several sets
    bool is_in_table = false;                  ///< of the same result: pages say it there
    bool is_time = false;                      ///< of this machine, or computed from such: it differs from run to run

    bool operator==(const DistributionNumber&) const = default;
};

using DistributionNumbers = std::vector<DistributionNumber>;

/// Names of files of curves end in this way, see curve_chart.hpp.
inline constexpr auto curves_ending = "-curves.json";

/// A picture: pixels as they are (.png), or what reports draw, marks (.json, see mark_picture.hpp) or curves.
struct DistributionPicture
{
    std::string file; ///< relative to the run's folder
    std::string caption;

    bool operator==(const DistributionPicture&) const = default;

    bool has_curves() const { return file.ends_with(curves_ending); }
    bool has_marks() const { return file.ends_with(".json") && !has_curves(); }
};

/// Words in rows and columns.
struct DistributionTable
{
    std::string title;
    std::vector<std::string> columns;           ///< their heads
    std::vector<std::vector<std::string>> rows; ///< each has as many cells

    bool operator==(const DistributionTable&) const = default;
};

/// A word by which results are told apart, such as kind = corner.
struct DistributionParameter
{
    std::string key;
    std::string value;

    bool operator==(const DistributionParameter&) const = default;
};

struct DistributionResult
{
    std::string name; ///< its folder
    std::string label;
    std::string kind;               ///< the word in the config
    std::vector<std::string> facts; ///< from which it was made
    std::vector<DistributionParameter> parameters;
    std::vector<DistributionNumber> numbers;
    std::vector<DistributionPicture> pictures;
    std::vector<std::string> files; ///< others, such as points; relative to the run's folder
    std::vector<DistributionTable> tables{};

    bool operator==(const DistributionResult&) const = default;

    /// Texture tiles, whose numbers are those of texture_measures().
    bool is_texture() const { return kind == "texture"; }

    /// The value of a parameter; empty where there is none.
    std::string parameter(const std::string& key) const;
};

void members(JsonMembers& m, const DistributionResult& distribution);
void members(JsonMembers& m, DistributionResult& distribution);

}
