#include "base/regions/svg/path_lines.hpp"

#include "base/errors/errors.hpp"

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

}

void PathLines::moveTo(const Geom::Point& p)
{
    begin_ = end_ = p;
    is_closed_ = true;
    add(p, {});
}

void PathLines::quadTo(const Geom::Point& c, const Geom::Point& p)
{
    extend(c);
    const Geom::Point a = end_;
    add(p, {[=](double t) { return (1 - t) * ((1 - t) * a + t * c) + t * ((1 - t) * c + t * p); },
            [=](double tolerance) { return std::sqrt(2 * (a - 2 * c + p).length() / (8 * tolerance)); }});
}

void PathLines::curveTo(const Geom::Point& c, const Geom::Point& d, const Geom::Point& p)
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

void PathLines::arcTo(double rx, double ry, double angle, bool is_large, bool sweeps, const Geom::Point& p)
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

void PathLines::closePath()
{
    end_ = begin_;
    if (!is_closed_ && !paths_.empty()) paths_.back().is_closed = true;
    is_closed_ = true;
}

std::vector<RegionRing> PathLines::lines(double tolerance, const std::string& name) const
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

void PathLines::add(const Geom::Point& end, PathCurve curve)
{
    // After a path was closed, the next one begins where that did, unless it moves.
    if (is_closed_) paths_.push_back({{{begin_, {}}}});
    is_closed_ = false;
    paths_.back().curves.emplace_back(end, std::move(curve));
    extend(end);
    end_ = end;
}

void PathLines::extend(const Geom::Point& p)
{
    for (unsigned k = 0; k < 2; ++k) {
        box_.low[k] = is_empty_ ? p[k] : std::min(box_.low[k], p[k]);
        box_.high[k] = is_empty_ ? p[k] : std::max(box_.high[k], p[k]);
    }
    is_empty_ = false;
}

SvgShape shape_of(PathLines paths, const std::string& place, bool is_even_odd)
{
    const RegionBox box = paths.box();
    return {place, is_even_odd, box,
            [paths = std::move(paths), place](double tolerance) { return paths.lines(tolerance, place); }};
}

}
