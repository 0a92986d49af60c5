// results.json, in a folder that has files to name.
#include "results/run.hpp"
#include "tests/fuzz/fuzz_support.hpp"

namespace poissonlab::fuzz {
namespace {

/// Results name files that must be there: these, which the corpus names.
void make_files()
{
    for (const char* name : {"points.dat", "spectrum.exr", "radial.csv", "pairs.csv", "plate.exr", "tiles.txt"})
        write_input(name, "");
}

}
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
    using namespace poissonlab;
    static const bool has_files = (fuzz::make_files(), true);
    fuzz::require(has_files, "no files");
    const auto file = fuzz::write_input("results.json", {reinterpret_cast<const char*>(data), size});
    fuzz::accepts(file.native(), [&] {
        const Run run = read_run(fuzz::input_folder());
        fuzz::require(run.dimension == 2 || run.dimension == 3, "a run of another dimension");
        for (const Series& series : run.series) {
            fuzz::require(series.points > 0 && series.realizations > 0, "a series without points");
        }
    });
    return 0;
}
