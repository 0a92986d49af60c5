// The samples that the edges of Wang tiles show, centred on them: one a colour.
//
// Cohen and others 2003, sections 3.2 and 3.5. With marked corners, a colour has a window of each exemplar, and an edge
// four samples, by the marks of its ends: the window of the ends' exemplar, or halves of both, joined by a cut across
// the middle of the edge that is the same in all tiles. The article says no more than that both pictures "must fit
// together via the quilting algorithm".
#pragma once

#include "host/texture/piece_fitting.hpp"

#include <vector>

namespace poissonlab {

/// Windows of all colours, of horizontal edges, then of vertical ones; with two exemplars, one of each a colour, the
/// unmarked one first.
using SampleWindows = std::vector<ExemplarWindow>;

/// Draws and replaces windows of samples.
class SampleChoice
{
public:
    /// Throws InputError where the diversity that is asked for does not fit.
    SampleChoice(const PngPixels& exemplar, const TextureRequest& request);

    /// The windows of an attempt.
    SampleWindows draw(std::uint32_t attempt) const;

    /// Draws the window `which` anew, and leaves the others as they are.
    SampleWindows replaced(const SampleWindows& windows, std::size_t which, std::uint32_t attempt) const;

private:
    ExemplarWindow free_window(const UsedWindows& used, std::size_t number, RandomWords& words) const;

    const PngPixels& exemplar_;
    const TextureRequest& request_;
    std::size_t count_;
    int distance_;
};

/// The pictures across edges, by their colours as the set counts them (marked_tiles.hpp).
struct EdgeSamples
{
    std::vector<SourceCanvas> horizontal, vertical; ///< T x T
    std::int64_t cost = 0;                          ///< of all cuts across the middles of edges
};
EdgeSamples edge_samples(const PngPixels& exemplar, const TextureRequest& request, const SampleWindows& windows);

}
