// OpenEXR images: spectra, their planes, pictures of the zone plate.
#include "analysis/spectra/spectrum_file.hpp"
#include "base/images/square_image.hpp"
#include "tests/fuzz/fuzz_support.hpp"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
    using namespace poissonlab;
    const auto file = fuzz::write_input("spectrum.exr", {reinterpret_cast<const char*>(data), size});
    const auto pixels_of = [](int side) { return static_cast<std::size_t>(side) * static_cast<std::size_t>(side); };

    fuzz::accepts(file.native(), [&] {
        const auto planes = read_spectrum_planes(file);
        fuzz::require(!planes.empty(), "a spectrum without planes");
        for (const Spectrum& plane : planes) {
            fuzz::require(plane.power.size() == pixels_of(plane.size), "a spectrum with another number of pixels");
            fuzz::require(plane.variance.empty() || plane.variance.size() == plane.power.size(),
                          "a part of a variance");
        }
    });
    fuzz::accepts(file.native(), [&] {
        const SquareImage image = read_square_image(file);
        fuzz::require(image.pixels.size() == pixels_of(image.size), "a picture with another number of pixels");
    });
    return 0;
}
