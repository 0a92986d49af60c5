// Curves over axes, as results store them: reports make plots of them.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

struct ChartCurve
{
    std::string name;
    std::string color = "#000000"; ///< "#rrggbb"
    std::vector<std::array<double, 2>> places;

    bool operator==(const ChartCurve&) const = default;
};

struct ChartAxis
{
    std::string name;
    double low = 0;
    double high = 1; ///< of the vertical axis, at most: it ends at a tick above all curves
    double step = 1; ///< between ticks

    bool operator==(const ChartAxis&) const = default;
};

struct CurveChart
{
    ChartAxis x, y;
    double level = 0; ///< a height with a dashed line across
    std::vector<ChartCurve> curves;

    bool operator==(const CurveChart&) const = default;
};

/// A colour of its own for each of a few classes, told apart by most eyes (Okabe and Ito); they come again after eight.
std::string class_color(std::size_t index);

/// The text of its file.
std::string curve_chart_json(const CurveChart& chart);

/// Reads that file. Throws InputError that names the file and the member.
CurveChart read_curve_chart(const std::filesystem::path& file);

}
