#include "base/regions/svg/path_rings.hpp"

#include "base/errors/errors.hpp"
#include "base/regions/region_raster.hpp"

#include <2geom/elliptical-arc.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

constexpr double most_pieces = 1e6; ///< of all curves

void append_corner(RegionRing& ring, const Geom::Point& p)
{
    const std::array corner{p[0], p[1]};
    if (ring.empty() || ring.back() != corner) ring.push_back(corner);
}

/// The number of times that each ring goes round a place just inside it, and just outside. Rings do not cross.
struct RingWinding
{
    int outside = 0, inside = 0;
};

std::vector<RingWinding> windings_of(const std::vector<RegionRing>& rings)
{
    std::vector<RingWinding> windings(rings.size());
    for (std::size_t i = 0; i < rings.size(); ++i) {
        const std::array<double, 2> middle{(rings[i][0][0] + rings[i][1][0]) / 2,
                                           (rings[i][0][1] + rings[i][1][1]) / 2};
        for (std::size_t j = 0; j < rings.size(); ++j)
            if (j != i && encloses(rings[j], middle)) windings[i].outside += signed_area_of(rings[j]) > 0 ? 1 : -1;
        windings[i].inside = windings[i].outside + (signed_area_of(rings[i]) > 0 ? 1 : -1);
    }
    return windings;
}

/// The rings between what is filled and what is not, outlines to the left and holes to the right.
std::vector<RegionRing> filled_rings(std::vector<RegionRing> rings, bool is_even_odd)
{
    const std::vector<RingWinding> windings = windings_of(rings);
    const auto is_filled = [&](int winding) { return is_even_odd ? winding % 2 != 0 : winding != 0; };
    std::vector<RegionRing> kept;
    for (std::size_t i = 0; i < rings.size(); ++i) {
        const bool is_outline = is_filled(windings[i].inside);
        if (is_outline == is_filled(windings[i].outside)) continue;
        if ((signed_area_of(rings[i]) > 0) != is_outline) std::ranges::reverse(rings[i]);
        kept.push_back(std::move(rings[i]));
    }
    return kept;
}

}

void PathRings::moveTo(const Geom::Point& p)
{
    begin_ = end_ = p;
    is_closed_ = true;
    add(p, {});
}

void PathRings::quadTo(const Geom::Point& c, const Geom::Point& p)
{
    extend(c);
    const Geom::Point a = end_;
    add(p, {[=](double t) { return (1 - t) * ((1 - t) * a + t * c) + t * ((1 - t) * c + t * p); },
            [=](double tolerance) { return std::sqrt(2 * (a - 2 * c + p).length() / (8 * tolerance)); }});
}

void PathRings::curveTo(const Geom::Point& c, const Geom::Point& d, const Geom::Point& p)
{
    extend(c);
    extend(d);
    const Geom::Point a = end_;
    const double bend = std::max((a - 2 * c + d).length(), (c - 2 * d + p).length());
    add(p, {[=](double t) {
                const double s = 1 - t;
                return s * s * s * a + 3 * s * s * t * c + 3 * s * t * t * d + t * t * t * p;
            },
            [=](double tolerance) { return std::sqrt(6 * bend / (8 * tolerance)); }});
}

void PathRings::arcTo(double rx, double ry, double angle, bool is_large, bool sweeps, const Geom::Point& p)
{
    const Geom::EllipticalArc arc(end_, rx, ry, angle, is_large, sweeps, p);
    if (arc.isChord()) return lineTo(p);
    const double radius = std::max(arc.rays()[0], arc.rays()[1]), turn = std::abs(arc.sweepAngle());
    const Geom::Rect bounds = arc.boundsExact();
    extend(bounds.min());
    extend(bounds.max());
    add(p,
        {[=](double t) { return arc.pointAt(t); },
         [=](double tolerance) { return turn / (2 * std::acos(std::clamp(1 - tolerance / radius, 0.0, 1 - 1e-15))); }});
}

void PathRings::closePath()
{
    end_ = begin_;
    if (!is_closed_ && !paths_.empty()) paths_.back().is_closed = true;
    is_closed_ = true;
}

std::vector<RegionRing> PathRings::rings(double tolerance, const std::string& name) const
{
    std::vector<RegionRing> rings = lines(tolerance, name);
    for (RegionRing& ring : rings)
        while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    std::erase_if(rings, [](const RegionRing& ring) { return ring.size() < 3; });
    return rings;
}

std::vector<RegionRing> PathRings::lines(double tolerance, const std::string& name) const
{
    std::vector<RegionRing> lines;
    double all_pieces = 0;
    for (const Path& path : paths_) {
        RegionRing line;
        for (const auto& [end, curve] : path.curves) {
            const double pieces = curve.at ? std::max(1.0, std::ceil(curve.pieces(tolerance))) : 1;
            if (curve.at) all_pieces += pieces;
            if (!(all_pieces <= most_pieces))
                throw InputError(fmt::format("{}: a tolerance of {:.3g} is too small: curves would have more than "
                                             "{:g} pieces",
                                             name, tolerance, most_pieces));
            for (double piece = 1; piece < pieces; ++piece) append_corner(line, curve.at(piece / pieces));
            append_corner(line, end);
        }
        if (path.is_closed) append_corner(line, path.curves.front().first);
        if (line.size() > 1) lines.push_back(std::move(line));
    }
    return lines;
}

void PathRings::add(const Geom::Point& end, PathCurve curve)
{
    // After a path was closed, the next one begins where that did, unless it moves.
    if (is_closed_) paths_.push_back({{{begin_, {}}}});
    is_closed_ = false;
    paths_.back().curves.emplace_back(end, std::move(curve));
    extend(end);
    end_ = end;
}

void PathRings::extend(const Geom::Point& p)
{
    for (unsigned k = 0; k < 2; ++k) {
        box_.low[k] = is_empty_ ? p[k] : std::min(box_.low[k], p[k]);
        box_.high[k] = is_empty_ ? p[k] : std::max(box_.high[k], p[k]);
    }
    is_empty_ = false;
}

PlaneRegion filled_region(std::vector<RegionRing> rings, bool is_even_odd, const std::string& name)
{
    // Lines that cross, and coordinates that are no numbers, are said as of other regions.
    for (const RegionRing& ring : rings) check_region({{{ring}}}, name);
    check_rings(rings, name);
    return region_of_rings(filled_rings(std::move(rings), is_even_odd));
}

}
