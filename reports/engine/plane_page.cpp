#include "reports/engine/plane_page.hpp"

#include "reports/engine/look_up_texts.hpp"
#include "reports/layout/page_template.hpp"
#include "reports/pages/page_frame.hpp"
#include "reports/words/base64.hpp"
#include "tiles/texture/engine/engine_map.hpp"

#include <fmt/format.h>

namespace poissonlab {

std::string render_plane_page(const TextureSet& set, const std::string& name)
{
    PageData page;
    page.set("title", fmt::format("The endless plane of {}", name));
    page.set("facts", fmt::format("{} {} tiles of {} × {} texels.", set.tiles.size(), texture_kinds[set.kind], set.size,
                                  set.size));
    page.set("name", name);
    page.set("colors", fmt::format("{}", set.colors.horizontal));
    page.set("size", fmt::format("{}", set.size));
    page.set("channels", fmt::format("{}", set.exemplar.channels));
    page.set("style", std::string(page_template_file("templates/report.css")));
    page.set("look_up", glsl_look_up(set));
    PageData levels{PageData::type::list};
    EngineMap level = color_map(set);
    for (int left = tile_levels(set.size); left > 0; --left) {
        const RawPicture picture = encoded_level(level);
        levels << PageData(base64_of({reinterpret_cast<const char*>(picture.bytes.data()), picture.bytes.size()}));
        if (left > 1) level = halved(level);
    }
    page.set("levels", levels);
    PageData scripts{PageData::type::list};
    for (const char* script : {"webgl.js", "texture_plane_gl.js", "texture_plane.js"})
        scripts << PageData(std::string(page_template_file("templates/" + std::string(script))));
    page.set("scripts", scripts);
    return render_template("texture_plane", page);
}

}
