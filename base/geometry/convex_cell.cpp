#include "base/geometry/convex_cell.hpp"

#include <algorithm>

namespace poissonlab {

ConvexCell::ConvexCell(double reach) : vertices_{{-reach, -reach}, {reach, -reach}, {reach, reach}, {-reach, reach}}
{
    find_radius();
}

void ConvexCell::cut(double x, double y)
{
    const double squared = x * x + y * y;
    if (!is_reached_from(squared)) return;
    kept_.clear();
    const auto beyond = [&](const Vertex& v) { return v[0] * x + v[1] * y - squared / 2; };
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
        const Vertex &a = vertices_[i], &b = vertices_[(i + 1) % vertices_.size()];
        const double at_a = beyond(a), at_b = beyond(b);
        if (at_a <= 0) kept_.push_back(a);
        if ((at_a <= 0) != (at_b <= 0)) {
            const double part = at_a / (at_a - at_b);
            kept_.push_back({a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])});
        }
    }
    vertices_.swap(kept_);
    find_radius();
}

ConvexCell::Vertex ConvexCell::centroid() const
{
    double area = 0, x = 0, y = 0;
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
        const Vertex &a = vertices_[i], &b = vertices_[(i + 1) % vertices_.size()];
        const double cross = a[0] * b[1] - a[1] * b[0];
        area += cross;
        x += cross * (a[0] + b[0]);
        y += cross * (a[1] + b[1]);
    }
    if (!(area > 0)) return {0, 0};
    return {x / area / 3, y / area / 3};
}

void ConvexCell::find_radius()
{
    squared_radius_ = 0;
    for (const Vertex& v : vertices_) squared_radius_ = std::max(squared_radius_, v[0] * v[0] + v[1] * v[1]);
}

}
