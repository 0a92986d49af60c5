#include "app/commands/manual/manual.hpp"

#include "base/files/whole_file.hpp"
#include "host/settings/sampler_registry.hpp"
#include "reports/gallery/gallery.hpp"
#include "reports/plots/gnuplot.hpp"
#include "reports/plots/gnuplot_text.hpp"

namespace poissonlab {
namespace {

namespace fs = std::filesystem;

/// The gallery's curves of a method, of the first dimension that it has any in, over cycles per mean spacing.
std::vector<NumberedCurve> curves_of(const std::string& sampler)
{
    std::vector<NumberedCurve> curves;
    for (const GalleryMethod& method : reference_gallery())
        if (method.sampler == sampler && (curves.empty() || curves.front().curve->dimension == method.curve.dimension))
            curves.push_back({curves.size(), method.label, &method.curve});
    return curves;
}

void draw_curves(const fs::path& folder)
{
    std::vector<GnuplotPicture> pictures;
    for (const SamplerSpec& spec : sampler_registry()) {
        const auto curves = curves_of(spec.name);
        if (curves.empty()) continue;
        pictures.push_back(
            gnuplot_picture(together(power_plot(curves, LengthUnit::spacing)), folder / "methods" / spec.name));
    }
    draw_with_gnuplot(pictures, PrintPictures::none);
}

}

void write_manual(const fs::path& folder, const std::vector<Command>& commands)
{
    for (const char* part : {"methods", "kinds"}) fs::create_directories(folder / part);
    ManualPages pages = method_pages();
    pages.merge(kind_pages());
    pages["measures.md"] = measure_page();
    pages["commands.md"] = command_page(commands);
    for (const auto& [name, text] : pages) write_whole_file(folder / name, text);
    draw_curves(folder);
}

}
