// Paths of SVG as lines: lib2geom reads them, and tells places on elliptic arcs.
//
// A chord of a curve is off by at most |second derivative| / 8 times the square of its share of the curve (Bezier
// curves: n (n - 1) times the largest second difference of control points), that of an arc by r (1 - cos of half its
// angle) where r is the larger radius: so many equal pieces keep the tolerance.
#pragma once

#include "base/regions/svg/svg_shapes.hpp"

#include <2geom/path-sink.h>

#include <utility>

namespace poissonlab {

/// A curve from where the one before ended: places on it from 0 to 1, and how many pieces keep a tolerance.
struct PathCurve
{
    std::function<Geom::Point(double)> at;
    std::function<double(double tolerance)> pieces;
};

/// Keeps what paths consist of, so that their extent is known before curves become lines.
class PathLines : public Geom::PathSink
{
public:
    void moveTo(const Geom::Point& p) override;
    void lineTo(const Geom::Point& p) override { add(p, {}); }
    void quadTo(const Geom::Point& c, const Geom::Point& p) override;
    void curveTo(const Geom::Point& c, const Geom::Point& d, const Geom::Point& p) override;
    void arcTo(double rx, double ry, double angle, bool is_large, bool sweeps, const Geom::Point& p) override;
    void closePath() override;
    void flush() override {}

    /// The box holds ends, control points and arcs; without any it is the origin.
    const RegionBox& box() const { return box_; }

    /// Returns the lines of paths; those that are closed end where they begin. Throws InputError where curves take too
    /// many lines.
    std::vector<RegionRing> lines(double tolerance, const std::string& name) const;

private:
    void add(const Geom::Point& end, PathCurve curve);
    void extend(const Geom::Point& p);

    struct Path
    {
        std::vector<std::pair<Geom::Point, PathCurve>> curves;
        bool is_closed = false;
    };

    std::vector<Path> paths_;
    Geom::Point begin_, end_;
    RegionBox box_;
    bool is_empty_ = true, is_closed_ = true;
};

/// Paths as the shape of an element.
SvgShape shape_of(PathLines paths, const std::string& place, bool is_even_odd);

}
