#include "analysis/regions/framed_region.hpp"

#include "base/regions/region_source.hpp"

#include "base/errors/errors.hpp"
#include "base/files/xxh64_bytes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace poissonlab {
namespace {

constexpr double positions = 0x1p31;

/// The last coordinate below 1.
constexpr double most_framed = 1 - 0x1p-53;

double signed_area(const RegionRing& ring)
{
    double twice = 0;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i)
        twice += (ring[i][0] - ring[0][0]) * (ring[i + 1][1] - ring[0][1]) -
                 (ring[i + 1][0] - ring[0][0]) * (ring[i][1] - ring[0][1]);
    return twice / 2;
}

RegionRing framed_ring(RegionRing ring, const std::array<double, 2>& low, double side, bool is_hole)
{
    for (auto& corner : ring)
        for (std::size_t k = 0; k < 2; ++k) corner[k] = (corner[k] - low[k]) / side;
    if ((signed_area(ring) < 0) != is_hole) std::ranges::reverse(ring);
    return ring;
}

PlaneRegion framed_polygons(const PlaneRegion& region, const std::array<double, 2>& low, double side)
{
    PlaneRegion framed;
    for (const RegionPolygon& polygon : region.polygons) {
        RegionPolygon& added = framed.polygons.emplace_back();
        added.outline = framed_ring(polygon.outline, low, side, false);
        for (const RegionRing& hole : polygon.holes) added.holes.push_back(framed_ring(hole, low, side, true));
    }
    return framed;
}

void add_ring_to(Xxh64& hash, const RegionRing& ring)
{
    hash.add(fmt::format("{} ", ring.size()));
    hash.add({reinterpret_cast<const char*>(ring.data()), ring.size() * sizeof(ring[0])});
}

std::uint64_t hash_of(const PlaneRegion& region)
{
    Xxh64 hash;
    for (const RegionPolygon& polygon : region.polygons) {
        hash.add(fmt::format("{} holes ", polygon.holes.size()));
        add_ring_to(hash, polygon.outline);
        for (const RegionRing& hole : polygon.holes) add_ring_to(hash, hole);
    }
    if (is_mapped(region)) hash.add(fmt::format("{}", fmt::join(region.source->map->middle(), " ")));
    return hash.value();
}

}

FramedRegion::FramedRegion(const PlaneRegion& region, std::string name)
    : name_(std::move(name)), fixed_(region), low_(fixed_.box().low), side_(fixed_.unit() * positions),
      own_polygons_(region), polygons_(framed_polygons(region, low_, side_)), boundary_(polygons_),
      hash_(hash_of(region)), area_(area_of(polygons_)), unit_length_(std::sqrt(area_))
{}

bool FramedRegion::contains(const std::array<double, 2>& place) const
{
    if (!(place[0] >= 0 && place[1] >= 0 && place[0] < 1 && place[1] < 1)) return false;
    return fixed_.contains({static_cast<std::uint32_t>(std::lround(place[0] * positions)),
                            static_cast<std::uint32_t>(std::lround(place[1] * positions))});
}

PointSet FramedRegion::framed(const PointSet& points, const std::string& name) const
{
    if (points.dimension != 2) throw InputError(name + ": points in space have no region of the plane");
    const PointSet own = as_in_plane(own_polygons_, points);
    PointSet framed;
    framed.coordinates.reserve(points.coordinates.size());
    std::size_t outside = 0, first = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        std::array<double, 2> place{};
        for (std::size_t k = 0; k < 2; ++k) place[k] = (own[i][k] - low_[k]) / side_;
        if (!contains(place) && !(boundary_.distance(place, 2 * tolerance) <= tolerance) && outside++ == 0) first = i;
        for (const double coordinate : place) framed.coordinates.push_back(std::clamp(coordinate, 0.0, most_framed));
    }
    if (outside > 0)
        throw InputError(fmt::format("{}: {} of {} points {} outside the region {}: the first is point {}, ({}, {})",
                                     name, outside, points.size(), outside == 1 ? "lies" : "lie", name_, first + 1,
                                     points[first][0], points[first][1]));
    return framed;
}

}
