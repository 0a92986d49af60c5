#include "reports/engine/look_up_texts.hpp"

#include "reports/layout/page_template.hpp"
#include "reports/pages/page_frame.hpp"
#include "tiles/texture/engine/engine_map.hpp"

#include <fmt/format.h>

namespace poissonlab {
namespace {

std::string runtime_text(const std::string& name) { return std::string(page_template_file("../runtime/" + name)); }

std::string what_it_is_of(const TextureSet& set)
{
    return fmt::format("// Written by poissonlab texture export: a set of {} {} tiles, ring of {} texels.\n",
                       set.tiles.size(), texture_kinds[set.kind], set.ring);
}

/// The numbers of the set as the preprocessor has them; `language` chooses that of texture_tiles.h.
std::string defined_numbers(const TextureSet& set, const std::string& language)
{
    return fmt::format(
        "#define TTILES_{}\n#define TTILES_COLORS {}u\n#define TTILES_SIZE {}\n#define TTILES_LEVELS {}\n"
        "#define TTILES_WANG {}\n",
        language, set.colors.horizontal, set.size, tile_levels(set.size), set.has_corners() ? 0 : 1);
}

}

std::string glsl_look_up(const TextureSet& set)
{
    // Integers of GLSL ES have 16 bits where nothing else is said.
    return what_it_is_of(set) + "#ifdef GL_ES\nprecision highp float;\nprecision highp int;\n#endif\n" +
           defined_numbers(set, "GLSL") + runtime_text("texture_tiles.h") + runtime_text("texture_look_up.glsl");
}

std::string hlsl_look_up(const TextureSet& set)
{
    return what_it_is_of(set) + defined_numbers(set, "HLSL") + runtime_text("texture_tiles.h") +
           runtime_text("texture_look_up.hlsl");
}

std::string wgsl_look_up(const TextureSet& set)
{
    return what_it_is_of(set) +
           fmt::format("const ttiles_colors = {}u;\nconst ttiles_size = {};\nconst ttiles_levels = {};\n"
                       "const ttiles_wang = {};\n",
                       set.colors.horizontal, set.size, tile_levels(set.size), !set.has_corners()) +
           runtime_text("texture_look_up.wgsl");
}

std::string materialx_function(const TextureSet& set)
{
    return glsl_look_up(set) + R"(
// The function of the node: hardware filters, at levels that the ring allows.
void ttiles_color3(sampler2D atlas, vec2 texcoord, int seed, out vec3 result)
{
    vec2 tile = floor(texcoord);
    result = ttiles_packed(atlas, uint(seed), ivec2(tile), texcoord - tile, dFdx(texcoord), dFdy(texcoord)).rgb;
}
)";
}

std::string materialx_document(const TextureSet& set, const std::string& atlas_file, const std::string& function_file)
{
    PageData document;
    document.set("about", fmt::format("{} {} tiles of {} x {} texels", set.tiles.size(), texture_kinds[set.kind],
                                      set.size, set.size));
    document.set("atlas", atlas_file);
    document.set("function", function_file);
    return render_template("texture_tiles_mtlx", document);
}

}
