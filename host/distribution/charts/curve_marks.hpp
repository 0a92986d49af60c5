// Curves as a picture of marks: axes with ticks, lines, and their names.
#pragma once

#include "results/pictures/mark_picture.hpp"

#include <array>
#include <string>
#include <vector>

namespace poissonlab {

struct MarkCurve
{
    std::string name;
    std::string color = "#000000";
    std::vector<std::array<double, 2>> places;
};

struct CurveAxis
{
    std::string name;
    double low = 0;
    double high = 1;
    double step = 1; ///< between ticks
};

/// Lines are cut where they leave the axes. `level` is a height with a thin line across.
MarkPicture curve_marks(const CurveAxis& x, const CurveAxis& y, double level, const std::vector<MarkCurve>& curves);

/// A colour of its own for each of a few classes, told apart by most eyes (Okabe and Ito); they come again after eight.
std::string class_color(std::size_t index);

}
