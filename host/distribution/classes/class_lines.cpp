#include "host/distribution/classes/class_lines.hpp"

#include "base/errors/errors.hpp"
#include "base/regions/region_source.hpp"
#include "host/distribution/regions/line_darts.hpp"
#include "host/sampling/classes/class_cells.hpp"
#include "host/settings/sampler_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace poissonlab {
namespace {

/// Returns what obstacles leave of the lines. The least distance from them is that of the smallest distance of classes.
LinesLeft left_of(const ClassSettings& settings, const RegionLand& land, double least)
{
    DartSettings place = settings.place;
    if (!place.obstacle_distance) place.obstacle_distance = 0;
    return lines_among(land, obstacle_distances(place, least).lines);
}

double least_of(const ClassDistances& distances)
{
    double least = INFINITY;
    for (std::size_t i = 0; i < distances.classes(); ++i)
        for (std::size_t j = 0; j <= i; ++j) least = std::min(least, distances.at(i, j));
    return least;
}

double farthest_of(const ClassDistances& distances, std::size_t own)
{
    double farthest = 0;
    for (std::size_t i = 0; i < distances.classes(); ++i) farthest = std::max(farthest, distances.at(own, i));
    return farthest;
}

/// Throws darts of all classes onto lines.
class ClassesOnLines
{
public:
    ClassesOnLines(const ClassSettings& settings, const ClassWork& work)
        : settings_(settings), work_(work), left_(left_of(settings, *work.land, least_of(work.asked))),
          edges_(edges_of(left_.lines)), box_(box_around(lines_of(work.land->whole))),
          order_(work.request.shares, work.request.points)
    {}

    ClassedPoints run(std::vector<std::size_t>& lines)
    {
        begin();
        for (std::uint32_t i = 0; auto own = order_.next();) {
            LineDarts& darts = free_[*own];
            if (darts.is_full()) {
                if (!shrink()) order_.close(*own);
                continue;
            }
            const auto words = philox({i++, 0, 0, 0}, work_.request.stream);
            const auto [at, line] = darts.dart((std::uint64_t{words[0]} << 32) | words[1]);
            keep_away(at, *own);
            order_.add(*own);
            made_.points.coordinates.insert(made_.points.coordinates.end(), at.begin(), at.end());
            made_.classes.push_back(*own);
            lines.push_back(left_.numbers[line]);
        }
        for (std::uint32_t i = 0; i < free_.size(); ++i)
            made_.is_full.push_back(order_.is_closed(i) &&
                                    (work_.request.points.empty() || order_.counts()[i] < work_.request.points[i]));
        return std::move(made_);
    }

private:
    double apart(std::size_t i, std::size_t j) const
    {
        const double distance = made_.scale * work_.asked.at(i, j);
        return distance + line_margin(distance, box_);
    }

    /// All positions are free, but for those near obstacles and near points that are there.
    void begin()
    {
        const std::vector<LinePlace>& obstacles = work_.land->obstacles.points;
        const double away = settings_.place.obstacle_distance.value_or(0);
        free_.clear();
        for (std::size_t i = 0; i < work_.asked.classes(); ++i) {
            const double reach = farthest_of(work_.asked, i) * made_.scale,
                         from_points = std::max(away, reach / 1024) + line_margin(away, box_);
            free_.emplace_back(pieces_of(edges_, reach), box_,
                               std::max(reach + line_margin(reach, box_), obstacles.empty() ? 0 : from_points));
            for (const LinePlace& obstacle : obstacles) free_[i].keep_away(obstacle, from_points);
            if (!obstacles.empty() && away >= reach / 1024 && free_[i].is_full()) // no smaller reach makes room
                throw InputError("the lines have no room for a point among the obstacles");
        }
        for (std::size_t p = 0; p < made_.classes.size(); ++p)
            keep_away({made_.points[p][0], made_.points[p][1]}, made_.classes[p]);
    }

    void keep_away(const LinePlace& at, std::uint32_t own)
    {
        for (std::size_t i = 0; i < free_.size(); ++i) free_[i].keep_away(at, apart(i, own));
    }

    /// Makes all distances smaller. Returns whether they may be.
    bool shrink()
    {
        if (work_.request.points.empty() || work_.request.factor >= 1) return false;
        made_.scale *= work_.request.factor;
        begin();
        return true;
    }

    const ClassSettings& settings_;
    const ClassWork& work_;
    LinesLeft left_;
    std::vector<LinePiece> edges_;
    RegionBox box_;
    FillOrder order_;
    std::vector<LineDarts> free_; ///< of each class
    ClassedPoints made_{{2, {}}, {}, {}};
};

/// A place, and its length along a direction that hardly any line crosses at a right angle. The direction is a little
/// shorter than 1, so that keys of two places differ by less than their distance.
struct PlaceInOrder
{
    double key;
    LinePlace at;

    explicit PlaceInOrder(const LinePlace& place) : key(0.86 * place[0] + 0.51 * place[1]), at(place) {}

    auto operator<=>(const PlaceInOrder&) const = default;
};

/// The least distance from points of one class to those of another, or to others of the same, both in order. Keys are
/// off by less than `margin`.
double least_in_order(const std::vector<PlaceInOrder>& few, const std::vector<PlaceInOrder>& many, bool are_same,
                      double margin)
{
    double least = INFINITY;
    for (std::size_t i = 0; i < few.size(); ++i) {
        const auto look = [&](const PlaceInOrder& there) {
            if (std::abs(there.key - few[i].key) >= least + margin) return false;
            const double x = there.at[0] - few[i].at[0], y = there.at[1] - few[i].at[1];
            least = std::min(least, std::sqrt(x * x + y * y));
            return true;
        };
        const auto from =
            are_same ? many.begin() + static_cast<std::ptrdiff_t>(i) + 1 : std::ranges::lower_bound(many, few[i]);
        for (auto after = from; after != many.end() && look(*after);) ++after;
        for (auto before = from; !are_same && before != many.begin() && look(*std::prev(before));) --before;
    }
    return least;
}

}

std::vector<std::size_t> points_on_lines(const ClassSettings& settings)
{
    const double length = total_length(edges_of(left_of(settings, *region_land(settings.place), 0).lines));
    std::vector<std::size_t> points;
    for (std::size_t i = 0; i < settings.per_length.size(); ++i) {
        const double count = std::round(settings.per_length[i] * length);
        if (count < 1 || count > static_cast<double>(max_points))
            throw InputError(
                fmt::format("{:g} times the length of the lines, {:.6g}, gives class {} {:.6g} points: must "
                            "be from 1 to {}",
                            settings.per_length[i], length, i, count, max_points));
        points.push_back(static_cast<std::size_t>(count));
    }
    return points;
}

namespace {

/// Returns the distances of which relative radii are parts: the mean ones of points on the lines. Those that come from
/// numbers of points on a length are of what obstacles leave. Distances of points are no larger than the longest side.
std::vector<double> packed_distances(const ClassSettings& settings, const RegionLand& land, double whole,
                                     double longest)
{
    std::vector<double> packed;
    const double length =
        settings.per_length.empty() ? whole : total_length(edges_of(left_of(settings, land, 0).lines));
    if (length == 0) throw InputError("the lines have no room for a point among the obstacles");
    for (const std::size_t count : settings.points)
        packed.push_back(
            std::min(length / static_cast<double>(count), longest / settings.relative_radius * (1 - 0x1p-50)));
    return packed;
}

}

void place_on_lines(const ClassSettings& settings, ClassWork& work)
{
    work.land = region_land(settings.place);
    const std::vector<RegionRing>& lines = lines_of(work.land->whole);
    const double whole = total_length(edges_of(lines)), longest = box_around(lines).longest();
    const std::vector<double> packed = packed_distances(settings, *work.land, whole, longest);
    work.asked = asked_distances(settings, packed, 1);
    for (std::size_t i = 0; i < work.asked.classes(); ++i) {
        const double distance = farthest_of(work.asked, i);
        if (distance > longest)
            throw InputError(fmt::format("{:.6g} is more than the lines' longest side, {:.6g}: there is room for one "
                                         "point of class {}",
                                         distance, longest, i));
        check_line_pieces(whole, longest, distance);
        check_line_pieces(whole, longest, work.asked.at(i, i));
    }
    work.length = total_length(edges_of(left_of(settings, *work.land, least_of(work.asked)).lines));
    if (work.length == 0) throw InputError("the lines have no room for a point among the obstacles");
}

ClassSet throw_line_classes(const ClassSettings& settings, ClassWork work)
{
    ClassSet set{std::move(work), {}};
    std::vector<std::size_t> lines;
    set.points = ClassesOnLines(settings, set.work).run(lines);
    if (lines.empty()) throw InputError("the lines have no room for a point among the obstacles");
    const RegionSource& source = *set.work.land->whole.source;
    if (!source.feature_of_line.empty())
        for (const std::size_t line : lines)
            set.features_on_lines.push_back(source.features[source.feature_of_line[line]].id);
    return set;
}

ClassDistances least_in_plane(const ClassedPoints& points)
{
    const std::size_t classes = points.is_full.size();
    std::vector<std::vector<PlaceInOrder>> sorted(classes);
    double largest = 0;
    for (const double c : points.points.coordinates) largest = std::max(largest, std::abs(c));
    for (std::size_t i = 0; i < points.classes.size(); ++i)
        sorted[points.classes[i]].emplace_back(LinePlace{points.points[i][0], points.points[i][1]});
    for (std::vector<PlaceInOrder>& of_class : sorted) std::ranges::sort(of_class);
    ClassDistances least(classes);
    for (std::size_t i = 0; i < classes; ++i)
        for (std::size_t j = 0; j <= i; ++j) {
            const bool is_fewer = sorted[i].size() < sorted[j].size();
            least.set(i, j,
                      least_in_order(sorted[is_fewer ? i : j], sorted[is_fewer ? j : i], i == j, 0x1p-48 * largest));
        }
    return least;
}

}
