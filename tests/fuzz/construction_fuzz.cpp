// construction.json: the panels of a picture of how tile sets come into being.
#include "results/pictures/construction_result.hpp"
#include "tests/fuzz/fuzz_support.hpp"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
    using namespace poissonlab;
    const auto file = fuzz::write_input("construction.json", {reinterpret_cast<const char*>(data), size});
    fuzz::accepts(file.native(), [&] {
        const Scene scene = read_scene(file);
        fuzz::require(!scene.panels.empty(), "a picture without panels");
    });
    return 0;
}
