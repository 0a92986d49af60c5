#include "base/regions/globe/globe_strip.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace poissonlab {
namespace {

using StripPlace = std::array<double, 2>;

void move(RegionRing& ring, double by)
{
    for (StripPlace& place : ring) place[0] += by;
}

class StripLayer
{
public:
    StripLayer(double turn, const std::string& name) : turn_(turn), name_(name) {}

    void check_line(const RegionRing& line) const
    {
        for (std::size_t i = 1; i < line.size(); ++i) check_edge(line[i - 1], line[i]);
    }

    void check_ring(const RegionRing& ring) const
    {
        check_line(ring);
        check_edge(ring.back(), ring.front());
    }

    /// The whole turns by which something between two longitudes must be moved to lie around the middle.
    double turns_to(double middle, const RegionBox& box) const
    {
        return turn_ * std::round((middle - (box.low[0] + box.high[0]) / 2) / turn_);
    }

    /// The middle of what lies within intervals of longitude: opposite to the widest gap between them.
    double middle_of(std::vector<RegionBox> boxes) const
    {
        for (RegionBox& box : boxes) {
            const double by = -turn_ * std::floor(box.low[0] / turn_);
            box.low[0] += by;
            box.high[0] += by;
        }
        std::ranges::sort(boxes, {}, [](const RegionBox& box) { return std::pair(box.low[0], box.high[0]); });
        double reached = boxes.front().high[0];
        for (const RegionBox& box : boxes) reached = std::max(reached, box.high[0]);
        double gap = boxes.front().low[0] + turn_ - reached, begin = boxes.front().low[0];
        double high = boxes.front().high[0];
        for (const RegionBox& box : boxes) {
            const double before = std::max(high, reached - turn_);
            if (box.low[0] - before > gap) {
                gap = box.low[0] - before;
                begin = box.low[0];
            }
            high = std::max(high, box.high[0]);
        }
        const double middle = begin + (turn_ - std::max(gap, 0.0)) / 2;
        return middle - turn_ * std::round(middle / turn_);
    }

private:
    /// Edges along a pole are in one place, and those that go around the whole Earth are drawn so on purpose. Others
    /// that are so long may be meant to go the other way.
    void check_edge(const StripPlace& a, const StripPlace& b) const
    {
        const double along = std::abs(a[0] - b[0]);
        if (!(along > turn_ / 2)) return;
        if (a[1] == b[1] && (std::abs(a[1]) == turn_ / 4 || along == turn_)) return;
        throw InputError(
            fmt::format("{}: the edge from ({:.6g}, {:.6g}) to ({:.6g}, {:.6g}) goes around more than half of "
                        "the Earth: what crosses the antimeridian is cut there, or goes on beyond {:g}",
                        name_, a[0], a[1], b[0], b[1], turn_ / 2));
    }

    double turn_;
    const std::string& name_;
};

RegionBox box_of_ring(const RegionRing& ring) { return box_of({{{ring}}}); }

}

Obstacles laid_in_strip(Obstacles shapes, double turn, const std::string& name)
{
    const StripLayer layer(turn, name);
    std::vector<RegionBox> boxes;
    for (RegionPolygon& polygon : shapes.polygons) {
        layer.check_ring(polygon.outline);
        boxes.push_back(box_of_ring(polygon.outline));
        const double middle = (boxes.back().low[0] + boxes.back().high[0]) / 2;
        for (RegionRing& hole : polygon.holes) {
            layer.check_ring(hole);
            move(hole, layer.turns_to(middle, box_of_ring(hole)));
        }
    }
    for (RegionRing& line : shapes.lines) {
        layer.check_line(line);
        boxes.push_back(box_of_ring(line));
    }
    for (const auto& point : shapes.points) boxes.push_back(box_of_ring({point}));
    if (boxes.empty()) return shapes;
    const double middle = layer.middle_of(boxes);
    std::size_t part = 0;
    for (RegionPolygon& polygon : shapes.polygons) {
        const double by = layer.turns_to(middle, boxes[part++]);
        move(polygon.outline, by);
        for (RegionRing& hole : polygon.holes) move(hole, by);
    }
    for (RegionRing& line : shapes.lines) move(line, layer.turns_to(middle, boxes[part++]));
    for (auto& point : shapes.points) point[0] += layer.turns_to(middle, boxes[part++]);
    return shapes;
}

}
