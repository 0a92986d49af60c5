// poissonlab tiles page: a page that shows the endless tiling of a tile set.
#include "app/commands/command.hpp"
#include "app/commands/output_file.hpp"
#include "app/commands/tiles/monotile_work.hpp"
#include "base/files/whole_file.hpp"
#include "reports/pages/page_endless.hpp"

namespace poissonlab {
namespace {

constexpr auto tiles_page_notes =
    R"help(The page needs nothing but itself: it opens from the disk, in any browser. It shows the same points as
`tiles points` for the same seed, at any place of the plane. Of hats and spectres it shows the tiles as well.
  poissonlab tiles page ranked.ptiles --out ranked.html)help";

struct TilesPageOptions
{
    std::filesystem::path file, out;
};

void write_tiles_page(const TilesPageOptions& options)
{
    const std::filesystem::path out = checked_output("tiles page", "--out", options.out, {{".html"}});
    const std::string bytes = read_whole_file(options.file), name = options.file.filename().string();
    write_whole_file(out, is_monotile_points(bytes) ? monotile_page(bytes, name) : render_endless_page(bytes, name));
}

}

Command tiles_page_command()
{
    const auto o = std::make_shared<TilesPageOptions>();
    return {"page",
            "Write a page that shows the endless tiling, live",
            {{"FILE", &o->file, "The tile set (.ptiles, .json), in the plane"},
             {"--out", &o->out, "The page", "FILE.html", required}},
            tiles_page_notes,
            action_on(o, write_tiles_page)};
}

}
