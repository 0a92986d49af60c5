#include "analysis/surfaces/surface_rings.hpp"

#include "analysis/surfaces/mesh_eigenfunctions.hpp"

#include <boost/math/special_functions/gamma.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace poissonlab {
namespace {

/// Returns the ring of eigenfunctions that have these powers.
RadialBin ring_of(double frequency, std::span<const double> powers)
{
    const auto count = static_cast<double>(powers.size());
    RadialBin ring{.frequency = frequency, .samples = powers.size()};
    ring.power = std::accumulate(powers.begin(), powers.end(), 0.0) / count;
    ring.power_error = ring.power * std::sqrt(2 / count);
    double mean = 0, squares = 0;
    const std::size_t pairs = powers.size() / 2;
    for (std::size_t i = 0; i < pairs; ++i)
        mean += (powers[2 * i] + powers[2 * i + 1]) / (2 * static_cast<double>(pairs));
    for (std::size_t i = 0; i < pairs; ++i) squares += 2 * std::pow((powers[2 * i] + powers[2 * i + 1]) / 2 - mean, 2);
    const double ratio = pairs > 0 && mean > 0 ? squares / static_cast<double>(2 * pairs - 1) / (mean * mean) : 0;
    ring.anisotropy_db = ratio > 0 ? std::max(10 * std::log10(ratio), least_anisotropy_db) : least_anisotropy_db;
    return ring;
}

/// Halves the triangles of a mesh again and again, by area, and counts the points on the parts.
class SurfaceHalves
{
public:
    SurfaceHalves(const TriangleMesh& mesh, const std::vector<MeshPosition>& points)
        : mesh_(mesh), counts_(mesh.triangles.size()), areas_(mesh.triangles.size()), order_(mesh.triangles.size())
    {
        for (const MeshPosition& p : points) ++counts_[p.triangle];
        std::ranges::transform(mesh.triangles, areas_.begin(), [&](const MeshTriangle& t) { return area_of(mesh, t); });
        std::iota(order_.begin(), order_.end(), 0u);
        expected_ = static_cast<double>(points.size()) / std::accumulate(areas_.begin(), areas_.end(), 0.0);
    }

    /// Finds the sum of (count - expected)^2 / expected over `most` parts. There are fewer if single triangles have the
    /// area of several.
    CountsOverParts counts(std::size_t most)
    {
        CountsOverParts counts;
        counts.part_of.resize(order_.size());
        counts.chi_square = chi_square(order_, most, counts);
        return counts;
    }

private:
    double chi_square(std::span<std::uint32_t> triangles, std::size_t most, CountsOverParts& counts)
    {
        double area = 0, count = 0;
        for (const std::uint32_t t : triangles) area += areas_[t], count += static_cast<double>(counts_[t]);
        if (most == 1 || triangles.size() == 1) {
            for (const std::uint32_t t : triangles) counts.part_of[t] = static_cast<std::uint32_t>(counts.parts);
            ++counts.parts;
            return std::pow(count - expected_ * area, 2) / (expected_ * area);
        }
        sort_along_longest(triangles);
        double first = 0;
        std::size_t middle = 0;
        while (first < area / 2 && middle + 1 < triangles.size()) first += areas_[triangles[middle++]];
        return chi_square(triangles.first(middle), most / 2, counts) +
               chi_square(triangles.subspan(middle), most / 2, counts);
    }

    double middle_of(std::uint32_t triangle, std::size_t axis) const
    {
        double sum = 0;
        for (const std::uint32_t corner : mesh_.triangles[triangle]) sum += mesh_.vertices[corner][axis];
        return sum;
    }

    void sort_along_longest(std::span<std::uint32_t> triangles) const
    {
        std::size_t longest = 0;
        double length = -1;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            double low = INFINITY, high = -INFINITY;
            for (const std::uint32_t t : triangles)
                low = std::min(low, middle_of(t, axis)), high = std::max(high, middle_of(t, axis));
            if (high - low > length) longest = axis, length = high - low;
        }
        std::ranges::sort(triangles, [&](std::uint32_t a, std::uint32_t b) {
            const double at_a = middle_of(a, longest), at_b = middle_of(b, longest);
            return at_a != at_b ? at_a < at_b : a < b;
        });
    }

    const TriangleMesh& mesh_;
    std::vector<std::size_t> counts_;
    std::vector<double> areas_;
    std::vector<std::uint32_t> order_;
    double expected_ = 0; ///< points for each area of 1
};

}

std::vector<RadialBin> eigenfunction_rings(const std::vector<double>& eigenvalues, const std::vector<double>& powers,
                                           double area, double highest, double width)
{
    std::vector<RadialBin> rings;
    const double root = std::sqrt(area);
    std::size_t begin = 0;
    for (double outer = 0.5 + width; outer <= frequency_of(highest) * root; outer += width) {
        std::size_t end = begin;
        while (end < eigenvalues.size() && frequency_of(eigenvalues[end]) * root <= outer) ++end;
        if (end > begin) rings.push_back(ring_of(outer - width / 2, std::span(powers).subspan(begin, end - begin)));
        begin = end;
    }
    return rings;
}

CountsOverParts counts_over_parts(const TriangleMesh& mesh, const std::vector<MeshPosition>& points, double least,
                                  std::size_t most)
{
    std::size_t parts = 1;
    while (parts < most && static_cast<double>(points.size()) >= 2 * least * static_cast<double>(parts) &&
           mesh.triangles.size() >= 64 * parts)
        parts *= 2;
    if (parts < 2) return {};
    CountsOverParts counts = SurfaceHalves(mesh, points).counts(parts);
    counts.p_value = boost::math::gamma_q(0.5 * static_cast<double>(counts.parts - 1), 0.5 * counts.chi_square);
    return counts;
}

}
