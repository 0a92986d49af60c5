// poissonlab texture advise: which texture tiles fit a picture, and whether it is a texture at all.
#include "app/commands/command.hpp"
#include "app/commands/work_options.hpp"
#include "base/errors/errors.hpp"
#include "host/texture/advice/advice_words.hpp"

#include <fmt/format.h>

namespace poissonlab {
namespace {

constexpr auto texture_advise_notes =
    R"(The command measures the picture alone and writes no file. It says how large the features of the picture are,
whether they are regular, whether the light is even, and whether all parts of the picture look alike. A tile should be
larger than the features, and the picture at least twice as wide as a tile.
texture build takes --colors and --size from this advice where they are not given.
docs/texture-tiles.md says how often the advice is right.
  poissonlab texture advise gravel.png)";

struct TextureAdviseOptions
{
    std::filesystem::path picture;
    bool json = false;
};

void print_advice(const TextureAdviseOptions& options)
{
    const TextureAdvice advice = advise_file(options.picture);
    if (options.json) {
        fmt::print("{}\n", advice_json(advice));
        return;
    }
    fmt::print("{}: {} x {} pixels\n", printable(options.picture.string()), advice.width, advice.height);
    for (const std::string& line : advice_lines(advice)) fmt::print("{}\n", line);
    if (advice.is_texture())
        fmt::print("  poissonlab texture build corner --colors {} --exemplar {} --size {}{} --out DIR\n", advice.colors,
                   file_word(options.picture.string()), advice.size, advice.is_straightened ? " --straighten" : "");
}

}

Command texture_advise_command()
{
    const auto o = std::make_shared<TextureAdviseOptions>();
    return {"advise",
            "Say which texture tiles fit a picture, and whether it is a texture",
            {{"PICTURE", &o->picture, "The picture, of any kind that OpenImageIO reads"}, json_option(o->json)},
            texture_advise_notes,
            action_on(o, print_advice)};
}

}
