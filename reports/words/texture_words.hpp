// Measures of textures become sentences here: one for each texture, and a verdict over all textures of one exemplar.
#pragma once

#include "results/pictures/distribution_result.hpp"
#include "results/texture_measures.hpp"

#include <string>
#include <vector>

namespace poissonlab {

/// The gates that a texture fails, in their order. It fails none whose measure it does not have.
std::vector<const TextureGate*> failed_gates(const DistributionResult& texture);

/// "Edges kept; recurs every 64 pixels; shapes whole.": what it has values of; empty where that is nothing.
std::string texture_sentence(const DistributionResult& texture);

/// The numbers of textures in the order in which a person should look at them: those that pass all gates first, by
/// their shares of new patches, which no construction optimises; then those that fail none, but are not measured for
/// all; then the others, by how many gates they fail. Others keep their order.
std::vector<std::size_t> judged_order(const std::vector<const DistributionResult*>& textures);

/// The label of a texture without the name of its exemplar in front.
std::string label_of_method(const DistributionResult& texture);

/// Says which of several textures to take, which others pass, and what is wrong or not known of the rest; empty where
/// no texture has a value that a gate asks for. `textures` are in their judged_order().
std::string textures_verdict(const std::vector<const DistributionResult*>& textures);

}
