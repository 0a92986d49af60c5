// The pictures of a report that show the gallery of reference curves.
#pragma once

namespace poissonlab {

enum class Gallery
{
    offered,     ///< on the compare page, to be ticked
    laid_behind, ///< some ticked there and behind the curves of each run, with a table of the measures of all
};

}
