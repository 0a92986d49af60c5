// Texts for engines: which tile of a texture set is where, and its colours, in the languages of shaders and as a node
// of MaterialX. They are the files of runtime/ with the numbers of the set before them.
#pragma once

#include "tiles/texture/texture_set.hpp"

#include <string>

namespace poissonlab {

/// Look-ups of a set with has_places(), as a file that a shader includes.
std::string glsl_look_up(const TextureSet& set);
std::string hlsl_look_up(const TextureSet& set);
std::string wgsl_look_up(const TextureSet& set);

/// A document of MaterialX with a node that shows the packed atlas `atlas_file` at every place of the plane, and a
/// material with it. The node's function is in `function_file`, which has the text of materialx_function().
std::string materialx_document(const TextureSet& set, const std::string& atlas_file, const std::string& function_file);
std::string materialx_function(const TextureSet& set);

}
