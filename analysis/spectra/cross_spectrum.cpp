#include "analysis/spectra/cross_spectrum.hpp"

#include <cmath>

namespace poissonlab {
namespace {

/// Adds what `value` says of each frequency of a half plane to its bin, and divides by their number.
template <typename Value>
std::vector<double> ring_means(int reach, const Value& value)
{
    std::vector<double> sums(static_cast<std::size_t>(reach)), counts(sums.size());
    for (int v = -reach; v <= reach; ++v)
        for (int u = 0; u <= reach; ++u) {
            const auto ring = std::lround(std::hypot(u, v));
            if (ring < 1 || ring > reach) continue;
            // The other half of the plane has the same; frequencies with u = 0 are in this one both.
            const double weight = u == 0 ? 1 : 2;
            sums[static_cast<std::size_t>(ring - 1)] += weight * value(u, v);
            counts[static_cast<std::size_t>(ring - 1)] += weight;
        }
    for (std::size_t k = 0; k < sums.size(); ++k) sums[k] /= counts[k];
    return sums;
}

}

CrossSpectra spectra_of_planes(const std::vector<HalfPlane>& planes, const std::vector<double>& counts)
{
    const int reach = planes.front().reach;
    HalfPlane all(reach);
    double points = 0;
    CrossSpectra spectra;
    for (std::size_t a = 0; a < planes.size(); ++a) {
        for (std::size_t i = 0; i < all.values.size(); ++i) all.values[i] += planes[a].values[i];
        points += counts[a];
        spectra.power.push_back(
            ring_means(reach, [&](int u, int v) { return std::norm(planes[a].at(u, v)) / counts[a]; }));
        for (std::size_t b = 0; b < a; ++b) {
            const double scale = 1 / std::sqrt(counts[a] * counts[b]);
            spectra.cross.push_back(ring_means(reach, [&](int u, int v) {
                return scale * (planes[a].at(u, v) * std::conj(planes[b].at(u, v))).real();
            }));
        }
    }
    spectra.power.push_back(ring_means(reach, [&](int u, int v) { return std::norm(all.at(u, v)) / points; }));
    return spectra;
}

CrossSpectra cross_spectra(const std::vector<PointSet>& sets, int reach)
{
    NonuniformTransform transform(reach);
    std::vector<HalfPlane> planes;
    std::vector<double> counts;
    for (const PointSet& set : sets) {
        planes.push_back(transform.forward(set));
        counts.push_back(static_cast<double>(set.size()));
    }
    return spectra_of_planes(planes, counts);
}

}
