#include "base/regions/globe/globe_strip.hpp"

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
    explicit StripLayer(double turn) : turn_(turn) {}

    /// Moves each place by whole turns to the side of the one before it.
    void straighten(RegionRing& line) const
    {
        double by = 0;
        for (std::size_t i = 1; i < line.size(); ++i) {
            line[i][0] += by;
            if (is_as_drawn(line[i - 1], line[i])) continue;
            const double more = turns_between(line[i - 1][0], line[i][0]);
            line[i][0] += more;
            by += more;
        }
    }

    /// A ring whose ends are a turn apart goes around a pole.
    void straighten_ring(RegionRing& ring) const
    {
        straighten(ring);
        const StripPlace first = ring.front(), last = ring.back();
        if (is_as_drawn(last, first)) return;
        const double left_over = turns_between(last[0], first[0]);
        if (left_over == 0) return;
        double latitudes = 0;
        for (const StripPlace& place : ring) latitudes += place[1];
        const double pole = latitudes < 0 ? -turn_ / 4 : turn_ / 4;
        const StripPlace end{first[0] + left_over, first[1]};
        ring.insert(ring.end(), {end, {end[0], pole}, {first[0], pole}});
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
    /// Edges along a pole are in one place, and those that go around the whole Earth are drawn so on purpose.
    bool is_as_drawn(const StripPlace& a, const StripPlace& b) const
    {
        return a[1] == b[1] && (std::abs(a[1]) == turn_ / 4 || std::abs(a[0] - b[0]) == turn_);
    }

    /// The whole turns by which `to` must be moved to lie within half a turn of `from`.
    double turns_between(double from, double to) const
    {
        const double along = to - from;
        return std::abs(along) <= turn_ / 2 ? 0 : -turn_ * std::round(along / turn_);
    }

    double turn_;
};

RegionBox box_of_ring(const RegionRing& ring) { return box_of({{{ring}}}); }

}

Obstacles laid_in_strip(Obstacles shapes, double turn)
{
    const StripLayer layer(turn);
    std::vector<RegionBox> boxes;
    for (RegionPolygon& polygon : shapes.polygons) {
        layer.straighten_ring(polygon.outline);
        boxes.push_back(box_of_ring(polygon.outline));
        const double middle = (boxes.back().low[0] + boxes.back().high[0]) / 2;
        for (RegionRing& hole : polygon.holes) {
            layer.straighten_ring(hole);
            move(hole, layer.turns_to(middle, box_of_ring(hole)));
        }
    }
    for (RegionRing& line : shapes.lines) {
        layer.straighten(line);
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
