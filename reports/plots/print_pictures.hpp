// Which files a report draws of its curves.
#pragma once

namespace poissonlab {

/// True if plots are drawn as PNG as well. A PNG takes gnuplot ten times as long as an SVG.
enum class PrintPictures
{
    none, ///< those of earlier reports stay where they show the same, and go where they do not
    drawn,
};

}
