// Salience says how much the middle of a window stands out of the exemplar. What stands out in a patch of a corner is
// seen again and again in a tiling, since there are as few patches as colours.
//
// Means over squares of several sides are compared with the distribution of such means over the whole exemplar, as
// centre and surround are in models of attention (Itti, Koch and Niebur 1998), here without surround: the exemplar is
// taken for stationary.
#pragma once

#include "host/texture/window_choice.hpp"

#include <vector>

namespace poissonlab {

class Salience
{
public:
    /// Measures windows of a size within these columns; `reach` is half of the side of the middles that are looked at.
    Salience(const PngPixels& exemplar, ColumnRange columns, int size, int reach);

    /// The part of all windows whose middles stand out less.
    double rank(const ExemplarWindow& window) const;

private:
    ColumnRange columns_;
    int places_a_row_;
    std::vector<float> salience_; ///< by the place of the window's upper left corner, row by row
    std::vector<float> sorted_;
};

}
