// The picture of a point set: a window of the torus, small enough that every dot is seen.
//
// Pictures of a 3D spectrum, of the planes that are stored of it. All have the tone mapping that they are given; a unit
// of the drawing is a pixel, which shows the mean of `block` x `block` frequencies, as for draw_spectrum.
#pragma once

#include "analysis/spectra/spectrum.hpp"
#include "base/geometry/periodic_box.hpp"
#include "base/geometry/point_set.hpp"
#include "reports/drawings/drawing.hpp"
#include "reports/images/tone_mapping.hpp"

#include <string>
#include <vector>

namespace poissonlab {

/// The part of a set that a picture shows: points with x and y in [0, window), and in 3D z in [0, depth).
struct PointsView
{
    double window = 1;
    double depth = 1;            ///< 3D only
    double dot_diameter = 0;     ///< in roots of the window's area
    double width = 1;            ///< of the window, in the same unit: one over its height
    std::size_t total = 0;       ///< points in the set
    std::vector<double> visible; ///< x0 y0 x1 y1 ..., in units of the window
    std::size_t shown() const { return visible.size() / 2; }
};

/// Sets of at most 2,000 points are shown whole, larger ones in a window that holds about 1,500.
/// 3D sets are shown as a slab as thick as the largest possible minimum distance, seen along z.
/// Dots have a third of the diameter of the largest disks that so many points could carry, whatever the
/// method, so that pictures of different methods compare.
/// Windows of a box have the proportion of its sides along x and y.
PointsView choose_points_view(const PointSet& points, const PeriodicBox& box = {});

/// Black dots on white. The origin is at the lower left.
Drawing draw_points(const PointsView& view);

/// The coordinate planes as two faces of a cube above a third: xz and yz in the upper row, z upwards in both;
/// xy below xz, with the same x. Each has its name above it. `planes` begin with these, as shown_planes()
/// does.
Drawing draw_spectrum_planes(const std::vector<Spectrum>& planes, const ToneMapping& tone_mapping, int block = 1);

/// Planes side by side, named. `planes` and `names` have the same size.
Drawing draw_plane_row(const std::vector<Spectrum>& planes, const std::vector<std::string>& names,
                       const ToneMapping& tone_mapping, int block = 1);

/// The middle of a 2D spectrum as a spectrum of its own, with five eighths of the frequencies along each axis
/// (an even number): the ring at the principal frequency and what is inside, for sets of the usual density.
Spectrum spectrum_close_up(const Spectrum& plane);

}
