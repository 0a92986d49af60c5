#include "host/distribution/surface_spectra/mesh_set_charts.hpp"

#include "base/files/whole_file.hpp"
#include "base/images/png_file.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace poissonlab {
namespace {

/// The color of the curves of the points that are measured.
constexpr const char* own_color = "#2c728e";

using ChartPlaces = std::vector<std::array<double, 2>>;

/// Adds the curves of all sets, which `places(measures, rings of curves)` finds.
void add_sets(CurveChart& chart, const MeshSpectra& spectra, const std::string& name,
              const std::function<ChartPlaces(const MeshSetMeasures&, const std::vector<RadialBin>&)>& places)
{
    chart.curves.push_back({"random points", "#8a8f98", places(spectra.random, spectra.random_curve)});
    chart.curves.push_back({"dart throwing", "#c8553d", places(spectra.darts, spectra.darts_curve)});
    const std::vector<std::string> colors{"#6a4c93", "#588157", "#e09f3e"};
    for (std::size_t i = 0; i < spectra.methods.size(); ++i) {
        const MethodSpectrum& method = spectra.methods[i];
        chart.curves.push_back({method.name, colors[i % colors.size()], places(method.set, method.curve)});
    }
    chart.curves.push_back({name, own_color, places(spectra.set, spectra.set_curve)});
}

ChartPlaces places_of(const std::vector<PairCorrelationBin>& bins)
{
    ChartPlaces places;
    for (const PairCorrelationBin& bin : bins) places.push_back({bin.distance, bin.value});
    return places;
}

const ChartAxis distance_axis{"distance / that of the densest packing", 0, farthest_pair, 0.5};
const ChartAxis pair_axis{"pair correlation", 0, 4, 0.5};

CurveChart pair_chart(const MeshSpectra& spectra, const std::string& name)
{
    CurveChart chart{distance_axis, pair_axis, 1, {}};
    add_sets(chart, spectra, name,
             [](const MeshSetMeasures& set, const std::vector<RadialBin>&) { return places_of(set.pairs.along); });
    return chart;
}

/// Shows how distances and densities are taken: along the surface, through space, by local densities.
CurveChart pair_ways_chart(const MeshPairs& pairs)
{
    CurveChart chart{distance_axis, pair_axis, 1, {}};
    chart.curves.push_back({"through space", "#c8553d", places_of(pairs.in_space)});
    if (!pairs.localised.empty())
        chart.curves.push_back({"along the surface, localised", "#e09f3e", places_of(pairs.localised)});
    chart.curves.push_back({"along the surface", own_color, places_of(pairs.along)});
    return chart;
}

CurveChart difference_chart(const MeshSpectra& spectra, const std::string& name)
{
    CurveChart chart{distance_axis, {"anisotropy (dB)", -20, 40, 5}, 0, {}};
    add_sets(chart, spectra, name,
             [](const MeshSetMeasures& set, const std::vector<RadialBin>&) { return set.pairs.anisotropy; });
    return chart;
}

/// Grey is the density of random points, white twice that or more, and what lies out of reach. Squares are 4 x 4
/// pixels.
PngPixels difference_picture(const MeshPairs& pairs)
{
    constexpr int scale = 4, size = scale * static_cast<int>(difference_squares);
    PngPixels pixels{size, size, 1, {}};
    const double reach = (pairs.reach / farthest_pair * difference_squares / 2 - 2) * scale;
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column) {
            const bool is_reached = std::hypot(row + 0.5 - size / 2, column + 0.5 - size / 2) < reach;
            const std::size_t square =
                static_cast<std::size_t>(row / scale) * difference_squares + static_cast<std::size_t>(column / scale);
            const double value = is_reached ? pairs.differences[square] : 2;
            pixels.values.push_back(static_cast<std::uint8_t>(std::clamp(std::round(127.5 * value), 0.0, 255.0)));
        }
    return pixels;
}

}

CurveChart spectrum_chart(const MeshSpectra& spectra, const std::string& name, std::size_t points, const ChartAxis& y,
                          double level, double RadialBin::*value)
{
    const double unit = 1 / std::sqrt(static_cast<double>(points));
    CurveChart chart{{"frequency / √(N / area)", 0, std::max(0.1, spectra.reach), 0.25}, y, level, {}};
    add_sets(chart, spectra, name, [&](const MeshSetMeasures&, const std::vector<RadialBin>& rings) {
        ChartPlaces places;
        for (const RadialBin& ring : rings)
            if (ring.*value > least_anisotropy_db) places.push_back({ring.frequency * unit, ring.*value});
        return places;
    });
    return chart;
}

void add_pairs(const MeshSpectra& spectra, const std::string& name, DistributionFiles& files,
               DistributionResult& result)
{
    const MeshPairs& pairs = spectra.set.pairs;
    files.add_curves("pairs", pair_chart(spectra, name),
                     "Pair correlation along the surface: the number of pairs of points at a distance over that of "
                     "random points. Blue noise has none on the left, and a peak near 1.",
                     result);
    files.add_curves("pair-distances", pair_ways_chart(pairs),
                     "Pair correlation by distances through space and along the surface: the localised one counts "
                     "with the density around the points of each part of the surface instead of that of all.",
                     result);
    files.add_curves("difference-anisotropy", difference_chart(spectra, name),
                     "Anisotropy of differences: the variance of the numbers of pairs in 12 directions. Independent "
                     "pairs have 0 dB, and rows of points rise above it.",
                     result);
    write_png(files.add("differences.png"), difference_picture(pairs));
    result.pictures.push_back({"differences.png",
                               "Density of the differences of points in the tangent plane, up to 4 distances of the "
                               "densest packing each way: grey is that of random points, white twice that or more."});
    write_whole_file(files.add("pair-correlation.csv", result), mesh_pairs_csv(pairs));
}

}
