// Regions, lines and obstacles: each input as GeoJSON or WKT, as a drawing of SVG, and as it would be typed. What is
// read is a region by the rules of those that are typed.
#include "base/regions/obstacles.hpp"
#include "base/regions/region_text.hpp"
#include "tests/fuzz/fuzz_support.hpp"

namespace poissonlab::fuzz {
namespace {

void check(const std::string& text)
{
    const PlaneRegion region = read_region(text, {.is_planar = true});
    require(!region.polygons.empty() && area_of(region) > 0, "a region without an area");
    check_region(region, text);
}

}
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
    using namespace poissonlab;
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    for (const char* name : {"region.geojson", "region.svg"}) {
        const auto file = fuzz::write_input(name, bytes);
        fuzz::accepts(file.native(), [&] { fuzz::check(file.string()); });
        fuzz::accepts(file.native(), [&] { read_region(file.string()); });
        fuzz::accepts(file.native(), [&] { read_region(file.string(), {.is_planar = true, .is_along = true}); });
        fuzz::accepts(file.native(), [&] { read_obstacles(file.string(), {.is_planar = true}); });
    }
    fuzz::accepts("", [&] { fuzz::check(std::string(bytes)); });
    return 0;
}
