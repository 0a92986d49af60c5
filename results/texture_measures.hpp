// The catalogue of measures of texture tiles: what results.json, the ranking of textures, their pages, diff and
// docs/output-folder.md say of each follows from its row.
#pragma once

#include "results/measures.hpp"
#include "results/pictures/distribution_result.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace poissonlab {

/// All of them, in the order in which they are shown. They have no `get`: see texture_value().
const std::vector<Measure>& texture_measures();

/// The value that a texture has of a measure.
std::optional<MeasuredValue> texture_value(const Measure& measure, const DistributionResult& texture);

/// A limit on something that a person notices in a texture at 12 x 12 tiles. A value beyond it fails, and no other
/// number makes up for that. Limits are judgements; docs/texture-tiles.md says from which textures they come.
struct TextureGate
{
    std::string_view key; ///< of the measure
    double limit;         ///< the largest value that passes
    const char* fault;    ///< what a texture does that fails: "repeats"
    const char* judged;   ///< what it is about: "repetition"

    bool passes(double value) const { return value <= limit; }
};

/// The gates reject repetition, as of copies; lost edges, as of blurs; and added edges and new patches, as of shuffled
/// pieces.
const std::vector<TextureGate>& texture_gates();

/// The gate of a measure that has one. Throws std::out_of_range for others.
const TextureGate& texture_gate(std::string_view key);

/// A number as results hold it, by the key of its row. Throws std::out_of_range for others.
DistributionNumber texture_number(const std::string& key, double value, std::optional<double> standard_error);

/// The rows of the table of docs/output-folder.md, in Markdown.
std::string texture_measures_table();

}
