// The outline around a piece, by Boost.Geometry.
#include "tiles/packing/puzzle_piece.hpp"

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>

#include <stdexcept>

namespace poissonlab {

std::vector<PiecePoint> grown_outline(const std::vector<PiecePoint>& outline, double distance)
{
    namespace bg = boost::geometry;
    using Point = bg::model::d2::point_xy<double>;
    using Counterclockwise = bg::model::polygon<Point, false>;
    Counterclockwise piece;
    for (const PiecePoint& point : outline) bg::append(piece.outer(), Point(point[0], point[1]));
    bg::correct(piece);

    bg::model::multi_polygon<Counterclockwise> grown;
    bg::buffer(piece, grown, bg::strategy::buffer::distance_symmetric<double>(distance),
               bg::strategy::buffer::side_straight(), bg::strategy::buffer::join_round(90),
               bg::strategy::buffer::end_flat(), bg::strategy::buffer::point_circle(90));
    if (grown.size() != 1) throw std::logic_error("a piece that falls apart as it grows");

    std::vector<PiecePoint> points;
    for (const Point& point : grown.front().outer()) points.push_back({point.x(), point.y()});
    points.pop_back(); // the first one again
    return points;
}

}
