// Are polygons what they should be? CGAL's exact predicates say so; its boxes find the pairs of edges that are near.
#include "base/errors/errors.hpp"
#include "base/regions/plane_region.hpp"

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/box_intersection_d.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace poissonlab {
namespace {

using CheckKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CheckPoint = CheckKernel::Point_2;

/// Extents below this part of the largest coordinate leave too few digits of a double.
constexpr double least_extent = 1e-9;

/// The area of a region with larger coordinates may be infinite as a double.
constexpr double largest_coordinate = 1e150;

/// Areas below this part of the squared extent are lost where corners are rounded to 32 bits.
constexpr double least_area = 1e-8;

struct CheckedRing
{
    std::vector<CheckPoint> corners;
    std::size_t polygon = 0;
    std::size_t hole = 0; ///< 0: the outline
    std::string name;
    CGAL::Bbox_2 box{};

    const CheckPoint& corner(std::size_t i) const { return corners[i % corners.size()]; }
};

/// An edge of a ring, from a corner to the next.
struct CheckedEdge
{
    std::size_t ring = 0;
    std::size_t number = 0;

    auto operator<=>(const CheckedEdge&) const = default;
};

enum class Meeting
{
    none,
    touch, ///< in one point, which is an end of at least one of them
    cross,
    overlap
};

Meeting meeting_of(const CheckPoint& p, const CheckPoint& q, const CheckPoint& r, const CheckPoint& s)
{
    const int first = CGAL::orientation(p, q, r) * CGAL::orientation(p, q, s);
    const int second = CGAL::orientation(r, s, p) * CGAL::orientation(r, s, q);
    if (first < 0 && second < 0) return Meeting::cross;
    if (CGAL::collinear(p, q, r) && CGAL::collinear(p, q, s)) {
        const auto& low = std::max(std::min(p, q), std::min(r, s));
        const auto& high = std::min(std::max(p, q), std::max(r, s));
        return low < high ? Meeting::overlap : low == high ? Meeting::touch : Meeting::none;
    }
    return first <= 0 && second <= 0 ? Meeting::touch : Meeting::none;
}

class RegionChecks
{
public:
    RegionChecks(const PlaneRegion& region, const std::string& name) : name_(name)
    {
        for (std::size_t p = 0; p < region.polygons.size(); ++p) {
            const std::string polygon = region.polygons.size() == 1 ? "" : fmt::format("polygon {}: ", p + 1);
            add(region.polygons[p].outline, p, 0, polygon + "the outline");
            for (std::size_t h = 0; h < region.polygons[p].holes.size(); ++h)
                add(region.polygons[p].holes[h], p, h + 1, fmt::format("{}hole {}", polygon, h + 1));
        }
    }

    void check()
    {
        find_meetings();
        for (std::size_t i = 0; i < rings_.size(); ++i)
            for (std::size_t j = 0; j < rings_.size(); ++j)
                if (i != j) check_place(i, j);
    }

    void check_meetings()
    {
        find_meetings();
        for (std::size_t i = 0; i < rings_.size(); ++i) {
            if (!touching_[i]) continue; // all of it is on one side of any other
            for (std::size_t j = 0; j < rings_.size(); ++j)
                if (i != j && touching_[j]) check_side(i, j);
        }
    }

private:
    InputError problem(const std::string& what) const { return InputError(name_ + ": " + what); }

    static std::string place(const CheckPoint& p) { return fmt::format("({:.10g}, {:.10g})", p.x(), p.y()); }

    void add(const RegionRing& ring, std::size_t polygon, std::size_t hole, const std::string& name)
    {
        CheckedRing checked{{}, polygon, hole, name};
        for (const auto& [x, y] : ring) {
            if (!std::isfinite(x) || !std::isfinite(y)) throw problem(name + " has a coordinate that is not a number");
            const CheckPoint corner(x, y);
            if (checked.corners.empty() || corner != checked.corners.back()) checked.corners.push_back(corner);
        }
        while (checked.corners.size() > 1 && checked.corners.front() == checked.corners.back())
            checked.corners.pop_back();
        if (checked.corners.size() < 3) throw problem(name + " has fewer than three corners");
        checked.box = CGAL::bbox_2(checked.corners.begin(), checked.corners.end());
        rings_.push_back(std::move(checked));
    }

    Meeting meeting(const CheckedEdge& a, const CheckedEdge& b) const
    {
        const CheckedRing &first = rings_[a.ring], &second = rings_[b.ring];
        return meeting_of(first.corner(a.number), first.corner(a.number + 1), second.corner(b.number),
                          second.corner(b.number + 1));
    }

    /// Edges of the same ring may meet where one ends and the next begins, those of others in single points.
    bool may_meet(const CheckedEdge& a, const CheckedEdge& b, Meeting meeting) const
    {
        if (meeting == Meeting::none) return true;
        if (meeting != Meeting::touch) return false;
        if (a.ring != b.ring) return true;
        const std::size_t count = rings_[a.ring].corners.size();
        return (a.number + 1) % count == b.number || (b.number + 1) % count == a.number;
    }

    void find_meetings()
    {
        using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 2, CheckedEdge>;
        std::vector<Box> boxes;
        for (std::size_t r = 0; r < rings_.size(); ++r)
            for (std::size_t e = 0; e < rings_[r].corners.size(); ++e)
                boxes.emplace_back(rings_[r].corner(e).bbox() + rings_[r].corner(e + 1).bbox(), CheckedEdge{r, e});
        touching_.assign(rings_.size(), false);
        std::optional<std::pair<CheckedEdge, CheckedEdge>> wrong; // the first one, in whatever order they are found
        CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& one, const Box& other) {
            const CheckedEdge a = std::min(one.info(), other.info()), b = std::max(one.info(), other.info());
            const Meeting found = meeting(a, b);
            if (found == Meeting::touch && a.ring != b.ring) touching_[a.ring] = touching_[b.ring] = true;
            if (!may_meet(a, b, found) && (!wrong || std::pair(a, b) < *wrong)) wrong = {a, b};
        });
        if (wrong) throw crossing(wrong->first, wrong->second);
    }

    InputError crossing(const CheckedEdge& a, const CheckedEdge& b) const
    {
        const CheckedRing &first = rings_[a.ring], &second = rings_[b.ring];
        const std::string at =
            fmt::format("the edges from {} and from {}", place(first.corner(a.number)), place(second.corner(b.number)));
        if (a.ring == b.ring) return problem(fmt::format("{} crosses or touches itself: {} meet", first.name, at));
        return problem(fmt::format("{} and {} {}: {} meet", first.name, second.name,
                                   meeting(a, b) == Meeting::overlap ? "share a piece of a line" : "cross", at));
    }

    /// Says on which side of ring `j` ring `i` lies, by one of its corners that does not lie on ring `j`. Rings that
    /// touch others may have gone through there, so all of their corners are looked at. Where all corners lie on ring
    /// `j`, the middle of an edge decides.
    CGAL::Bounded_side side(std::size_t i, std::size_t j, bool& is_mixed) const
    {
        const std::vector<CheckPoint>& corners = rings_[j].corners;
        CGAL::Bounded_side side = CGAL::ON_BOUNDARY;
        is_mixed = false;
        for (const CheckPoint& corner : rings_[i].corners) {
            const auto found = CGAL::bounded_side_2(corners.begin(), corners.end(), corner, CheckKernel());
            if (found == CGAL::ON_BOUNDARY) continue;
            if (side != CGAL::ON_BOUNDARY && found != side) is_mixed = true;
            side = found;
            if (!touching_[i] || is_mixed) break;
        }
        const auto& own = rings_[i].corners;
        for (std::size_t k = 0; k < own.size() && side == CGAL::ON_BOUNDARY; ++k)
            side = CGAL::bounded_side_2(corners.begin(), corners.end(),
                                        CGAL::midpoint(own[k], own[(k + 1) % own.size()]), CheckKernel());
        return side;
    }

    /// The side of ring `i` that side() finds, for rings that do not cross. Throws where they do.
    CGAL::Bounded_side check_side(std::size_t i, std::size_t j) const
    {
        if (!CGAL::do_overlap(rings_[i].box, rings_[j].box)) return CGAL::ON_UNBOUNDED_SIDE;
        bool is_mixed = false;
        const CGAL::Bounded_side found = side(i, j, is_mixed);
        if (is_mixed) throw problem(fmt::format("{} and {} cross", rings_[i].name, rings_[j].name));
        return found;
    }

    void check_place(std::size_t i, std::size_t j) const
    {
        const CheckedRing &ring = rings_[i], &other = rings_[j];
        const bool is_hole = ring.hole > 0;
        if (is_hole && ring.polygon != other.polygon) return;
        if (!is_hole && other.hole > 0) return; // holes of its own lie inside, those of others in their outlines
        const CGAL::Bounded_side found = check_side(i, j);
        if (is_hole && other.hole == 0 && found != CGAL::ON_BOUNDED_SIDE)
            throw problem(ring.name + " lies outside the outline");
        if (is_hole && other.hole > 0 && found == CGAL::ON_BOUNDED_SIDE)
            throw problem(fmt::format("{} lies inside {}", ring.name, other.name));
        if (!is_hole && found == CGAL::ON_BOUNDED_SIDE && !is_in_hole_of(i, other.polygon))
            throw problem(fmt::format("{} lies inside {}", ring.name, other.name));
    }

    bool is_in_hole_of(std::size_t i, std::size_t polygon) const
    {
        bool is_mixed = false;
        for (std::size_t j = 0; j < rings_.size(); ++j)
            if (rings_[j].polygon == polygon && rings_[j].hole > 0 && side(i, j, is_mixed) == CGAL::ON_BOUNDED_SIDE)
                return true;
        return false;
    }

    const std::string& name_;
    std::vector<CheckedRing> rings_;
    std::vector<bool> touching_; ///< which rings touch others
};

}

namespace {

double perimeter_of(const PlaneRegion& region)
{
    double perimeter = 0;
    const auto add = [&](const RegionRing& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const auto &from = ring[i], &to = ring[(i + 1) % ring.size()];
            perimeter += std::hypot(to[0] - from[0], to[1] - from[1]);
        }
    };
    for (const RegionPolygon& polygon : region.polygons) {
        add(polygon.outline);
        for (const RegionRing& hole : polygon.holes) add(hole);
    }
    return perimeter;
}

/// Strips are about as wide as twice their area over their perimeter, and so are islands, however far apart.
bool has_area(const PlaneRegion& region, double longest)
{
    const double area = area_of(region);
    return area > least_area * longest * longest || 2 * area > least_area * longest * perimeter_of(region);
}

}

void check_region(const PlaneRegion& region, const std::string& name)
{
    if (region.polygons.empty()) throw InputError(name + ": has no polygon: the region is empty");
    RegionChecks checks(region, name);
    const RegionBox box = box_of(region);
    double largest = 0;
    for (std::size_t k = 0; k < 2; ++k) largest = std::max({largest, std::abs(box.low[k]), std::abs(box.high[k])});
    if (!(largest < largest_coordinate))
        throw InputError(fmt::format("{}: has coordinates of up to {:.3g}: must be less than {:.3g}, "
                                     "because the region's area would exceed the largest double",
                                     name, largest, largest_coordinate));
    if (!(box.longest() > least_extent * largest))
        throw InputError(fmt::format("{}: is {:.3g} large at coordinates of {:.3g}, which doubles cannot resolve", name,
                                     box.longest(), largest));
    checks.check();
    if (!has_area(region, box.longest()))
        throw InputError(fmt::format("{}: its area, {:.3g}, is nothing beside its extent, {:.3g}", name,
                                     area_of(region), box.longest()));
}

void check_rings(const std::vector<RegionRing>& rings, const std::string& name)
{
    PlaneRegion each;
    for (const RegionRing& ring : rings) each.polygons.push_back({ring});
    RegionChecks(each, name).check_meetings();
}

}
