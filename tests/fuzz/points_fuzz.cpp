// Point files: text, tables, PLY and NumPy. What is read is in [0, 1), and the same after it was written in any format.
#include "base/points/flat_points.hpp"
#include "base/points/point_file.hpp"
#include "tests/fuzz/fuzz_support.hpp"

#include <algorithm>

namespace poissonlab::fuzz {
namespace {

void check_set(const PointSet& points)
{
    require(points.dimension == 2 || points.dimension == 3, "points of a dimension other than 2 and 3");
    require(points.size() > 0, "an empty set");
    require(points.coordinates.size() % static_cast<std::size_t>(points.dimension) == 0, "a part of a point");
    require(std::ranges::all_of(points.coordinates, [](double x) { return x >= 0 && x < 1; }),
            "a coordinate outside of [0, 1)");
}

void check_round_trip(const PointSet& points, const char* name)
{
    const std::filesystem::path file = input_folder() / name;
    write_points(file, points, "a comment");
    const auto sets = read_points(file);
    require(sets.size() == 1 && sets.front() == points, "points that change when they are written and read");
}

}
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
    using namespace poissonlab;
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const auto file = fuzz::write_input("points", bytes);

    fuzz::accepts(file.native(), [&] { read_points(file, CoordinateRange{-1, 1024}); });
    std::vector<PointSet> sets;
    if (!fuzz::accepts(file.native(), [&] { sets = read_points(file); })) return 0;
    fuzz::require(!sets.empty(), "a file without sets");
    std::ranges::for_each(sets, fuzz::check_set);

    // One set and one format of each file: writing is what takes the time.
    const PointSet& set = sets[size % sets.size()];
    const char* const names[] = {"written.dat", "written.npy", "written.ply"};
    if (flat_axis({set})) return 0; // alone, it belongs to points in the plane
    fuzz::check_round_trip(set, names[size % 3]);
    return 0;
}
