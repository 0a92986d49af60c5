// Where a report shows the gallery of reference curves.
#pragma once

namespace poissonlab {

enum class Gallery
{
    offered,     ///< on the compare page, to be ticked
    laid_behind, ///< the curves of each run as well, ticked, with a table of measures
};

}
