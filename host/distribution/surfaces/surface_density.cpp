#include "host/distribution/surfaces/surface_density.hpp"

#include "base/densities/density_text.hpp"
#include "base/errors/errors.hpp"
#include "base/files/file_kind.hpp"
#include "base/programs/interrupt.hpp"
#include "host/distribution/surfaces/surface_files.hpp"
#include "host/distribution/surfaces/surface_neighbours.hpp"
#include "host/sampling/optimized/sample_elimination.hpp"
#include "host/sampling/surfaces/surface_darts.hpp"
#include "kernels/common/surfaces/surface_elimination.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace poissonlab {
namespace {

/// The number of places that estimate the largest density and its mean.
constexpr std::uint64_t density_places = 1 << 17;

/// Random places for each candidate at most, between the limits of all.
constexpr std::uint64_t darts_a_candidate = 10'000, least_dart_limit = 10'000'000, most_dart_limit = 1'000'000'000;

/// Places between two looks at signals.
constexpr std::uint64_t darts_a_step = 1 << 18;

/// Returns the pairs of points that have a weight. `distances` has the distance of each point, in units of the grid; a
/// pair has the smaller one of its two. Pairs nearer than the part `least` of it have the largest weight.
std::vector<std::vector<reference::Partner>> density_partners(const FixedSurface& surface,
                                                              const std::vector<SurfacePoint>& points,
                                                              const std::vector<double>& distances, double least,
                                                              std::int32_t cosine)
{
    std::vector<std::vector<reference::Partner>> partners(points.size());
    // Points are in classes by octaves of their distances. Points of a class look only at their class and at classes of
    // larger distances, so that the pair's distance is within the octave.
    const double smallest = std::ranges::min(distances);
    std::vector<int> classes;
    for (const double d : distances) classes.push_back(std::ilogb(d / smallest));
    for (int octave = 0; octave <= std::ranges::max(classes); ++octave) {
        std::vector<SurfacePoint> seen;
        std::vector<std::uint32_t> numbers;
        for (std::uint32_t i = 0; i < points.size(); ++i)
            if (classes[i] >= octave) {
                seen.push_back(points[i]);
                numbers.push_back(i);
            }
        const double reach = std::min(std::ldexp(smallest, octave + 1), 0x1p31);
        const SurfaceNeighbours near(surface, seen, static_cast<std::uint64_t>(reach) + 1);
        for (const std::uint32_t i : numbers) {
            if (classes[i] != octave) continue;
            near.for_each_around(place_of(points[i]), [&](std::size_t other) {
                const std::uint32_t j = numbers[other];
                if (j == i || cosine_between(surface.triangles[points[i].triangle],
                                             surface.triangles[points[j].triangle]) < cosine)
                    return;
                const double part =
                    std::sqrt(static_cast<double>(squared_distance(place_of(points[i]), place_of(points[j])))) /
                    std::min(distances[i], distances[j]);
                if (part >= 1) return;
                const double rest = 1 - std::max(part, least), fourth = (rest * rest) * (rest * rest);
                const auto weight =
                    static_cast<std::uint64_t>(fourth * fourth * contract::surface_elimination::WEIGHT_UNITS + 0.5);
                partners[i].push_back({j, weight});
                if (classes[j] > octave) partners[j].push_back({i, weight});
            });
        }
    }
    return partners;
}

}

SurfaceDensity::SurfaceDensity(const std::string& text, const std::string& from, const TriangleMesh& mesh)
    : name_(text), mesh_(mesh), column_(mesh.columns.names.size())
{
    if (is_file_name(text)) {
        if (mesh.texture_triangles.empty())
            throw InputError(text + ": a picture needs texture coordinates, and the mesh has none");
        picture_ = density_of_text(text, from, 1, 1);
        return;
    }
    if (from != "light")
        throw InputError(fmt::format("{}: \"{}\" is for pictures, and this is not a picture", text, from));
    const auto found = std::ranges::find(mesh.columns.names, text);
    column_ = static_cast<std::size_t>(found - mesh.columns.names.begin());
    if (found != mesh.columns.names.end()) return;
    try {
        formula_ = std::make_unique<SpaceFormula>(text);
    } catch (const InputError& error) {
        throw InputError(
            fmt::format("{}; numbers of the mesh's vertices: {}", error.what(),
                        mesh.columns.names.empty() ? "none" : fmt::format("{}", fmt::join(mesh.columns.names, ", "))));
    }
}

double SurfaceDensity::value_at(const FixedSurface& surface, const SurfacePoint& point)
{
    if (formula_)
        return formula_->at(surface.origin[0] + point.place[0] * surface.unit,
                            surface.origin[1] + point.place[1] * surface.unit,
                            surface.origin[2] + point.place[2] * surface.unit);
    const std::uint32_t face = surface.faces[point.triangle];
    const MeshPoint shares = barycentrics_of(point);
    if (picture_.weights.empty()) {
        double sum = 0;
        for (std::size_t k = 0; k < 3; ++k)
            if (shares[k] > 0) sum += shares[k] * mesh_.columns.at(mesh_.triangles[face][k], column_);
        return sum;
    }
    TexturePoint at{};
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t corner = mesh_.texture_triangles[face][k];
        if (corner == no_texture_point) return 0; // faces without texture have no points
        for (std::size_t i = 0; i < 2; ++i) at[i] += shares[k] * mesh_.texture_points[corner][i];
    }
    for (double& c : at) c = std::min(c - std::floor(c), 1 - 0x1p-53);
    return static_cast<double>(picture_.at(at[0], at[1]));
}

double SurfaceDensity::at(const FixedSurface& surface, const SurfacePoint& point)
{
    const double value = value_at(surface, point);
    if (!(value >= 0) || std::isinf(value))
        throw InputError(fmt::format("{}: is {} at ({:.6g}, {:.6g}, {:.6g}): must be a finite number of at least 0",
                                     name_, value, surface.origin[0] + point.place[0] * surface.unit,
                                     surface.origin[1] + point.place[1] * surface.unit,
                                     surface.origin[2] + point.place[2] * surface.unit));
    return value;
}

namespace {

/// Returns the number of corners of triangles where a density is larger than a limit; a vertex counts for each
/// triangle.
std::uint64_t larger_corners(const FixedSurface& surface, SurfaceDensity& density, double limit)
{
    constexpr auto whole = std::uint32_t{1} << contract::surface::BARYCENTRIC_BITS;
    std::uint64_t count = 0;
    for (std::uint32_t triangle = 0; triangle < surface.triangles.size(); ++triangle)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            SurfacePoint point{};
            point.triangle = triangle;
            if (corner > 0) point.shares[corner - 1] = whole;
            std::ranges::copy(place_on(surface.triangles[triangle], point.shares[0], point.shares[1]), point.place);
            count += density.value_at(surface, point) > limit ? 1 : 0;
        }
    return count;
}

}

DensityCandidates density_candidates(const FixedSurface& surface, SurfaceDensity& density, std::size_t count,
                                     const StreamKey& stream,
                                     const std::function<void(const std::string& what)>& on_step)
{
    const std::vector<SurfacePiece> pieces = whole_pieces(surface);
    const SurfacePieceChoice choice = surface_piece_choice(surface, pieces);
    const auto dart = [&](std::uint64_t i) { return reference::surface_dart(surface, pieces, choice, stream, i); };
    std::vector<double> values;
    for (std::uint64_t i = 0; i < density_places; ++i) values.push_back(density.at(surface, dart(i)));
    const double largest = std::ranges::max(values);
    if (largest == 0) throw InputError(density.name() + ": is 0 everywhere on the mesh, or nearly");
    double sum = 0; // of parts of the largest value, as the values may be too large or too small for a sum
    for (const double value : values) sum += value / largest;
    DensityCandidates candidates;
    candidates.larger_corners = larger_corners(surface, density, 1.1 * largest);
    candidates.integral = sum / density_places * surface.area;
    const std::uint64_t most = std::clamp(darts_a_candidate * count, least_dart_limit, most_dart_limit);
    for (std::uint64_t& i = candidates.darts; candidates.points.size() < count; ++i) {
        if (i == most)
            throw InputError(fmt::format("{}: is large in too small a part of the mesh: {} random places gave {} of {} "
                                         "candidates",
                                         density.name(), most, candidates.points.size(), count));
        if (i % darts_a_step == 0) {
            stop_if_interrupted();
            if (on_step) on_step(fmt::format("{} of {} candidates", candidates.points.size(), count));
        }
        const SurfacePoint point = dart(i);
        const double value = density.at(surface, point), part = std::min(value / largest, 1.0);
        if (value > largest) ++candidates.larger;
        const auto words = philox({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i >> 32), 1, 0}, stream);
        if (!(words[0] * 0x1p-32 < part)) continue;
        candidates.points.push_back(point);
        candidates.densities.push_back(std::max(part, 0x1p-32)); // the least chance of a word
    }
    return candidates;
}

std::vector<SurfacePoint> eliminate_by_density(const FixedSurface& surface, const DensityCandidates& candidates,
                                               std::size_t kept, double angle)
{
    const auto removed_of = [&](const std::vector<std::uint32_t>& left, std::size_t to, double least) {
        std::vector<SurfacePoint> points;
        std::vector<double> distances;
        for (const std::uint32_t i : left) {
            points.push_back(candidates.points[i]);
            distances.push_back(surface.units_of(std::sqrt(2 / std::numbers::sqrt3 * candidates.integral /
                                                           (static_cast<double>(to) * candidates.densities[i]))));
        }
        return reference::heaviest_first(density_partners(surface, points, distances, least, least_cosine(angle)),
                                         left.size() - to, {});
    };
    const auto without = [](const std::vector<std::uint32_t>& left, const std::vector<std::uint32_t>& removed) {
        std::vector<bool> is_removed(left.size());
        for (const std::uint32_t number : removed) is_removed[number] = true;
        std::vector<std::uint32_t> rest;
        for (std::size_t i = 0; i < left.size(); ++i)
            if (!is_removed[i]) rest.push_back(left[i]);
        return rest;
    };
    std::vector<std::uint32_t> left(candidates.points.size());
    std::iota(left.begin(), left.end(), 0u);
    if (kept < left.size()) {
        const double share = static_cast<double>(kept) / static_cast<double>(left.size());
        left = without(left, removed_of(left, kept, (1 - share * std::sqrt(share)) * 0.65));
    }
    std::vector<std::uint32_t> ordered = left;
    while (left.size() >= 3) {
        const auto removed = removed_of(left, left.size() / 2, 0);
        for (std::size_t i = 0; i < removed.size(); ++i) ordered[left.size() - 1 - i] = left[removed[i]];
        left = without(left, removed);
        std::ranges::copy(left, ordered.begin());
    }
    std::vector<SurfacePoint> points;
    for (const std::uint32_t i : ordered) points.push_back(candidates.points[i]);
    return points;
}

}
