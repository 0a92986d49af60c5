// Stored tables: radial.csv, pair-correlation.csv, number-variance.csv and zone-plate.csv, told apart by their headers,
// and tiles.txt.
#include "results/curve_tables.hpp"
#include "results/pictures/stored_tiles.hpp"
#include "tests/fuzz/fuzz_support.hpp"

#include <cmath>

namespace poissonlab::fuzz {
namespace {

void read_window_of_tiles()
{
    TilingResult tiling;
    tiling.kind = TileKind::corner;
    tiling.colors = 3;
    tiling.file = "table";
    tiling.size = {4, 2, 1};
    require(read_tiles(input_folder(), tiling).size() == tiling.shown(), "another number of tiles");
}

}
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
    using namespace poissonlab;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const auto file = fuzz::write_input("table", text);
    fuzz::accepts(file.native(), [&] {
        if (text.starts_with("frequency"))
            fuzz::require(std::isfinite(peak_power(read_radial_table(file)).power), "a peak that is no number");
        else if (text.starts_with("distance,p"))
            fuzz::require(!read_pair_correlation_table(file).empty(), "an empty table");
        else if (text.starts_with("radius"))
            fuzz::require(!read_number_variance_table(file).empty(), "an empty table");
        else if (text.starts_with("distance"))
            fuzz::require(!read_zone_plate_table(file).empty(), "an empty table");
        else
            fuzz::read_window_of_tiles();
    });
    return 0;
}
