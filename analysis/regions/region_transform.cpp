#include "analysis/regions/region_transform.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace poissonlab {
namespace {

using Complex = std::complex<double>;

/// Places on the boundary that are transformed at once: more would take a GiB. Where there are more, the sum over edges
/// is taken where it has fewer waves than so many for each place.
constexpr std::size_t most_places_at_once = std::size_t{1} << 22;
constexpr double waves_a_place = 2;

/// Gauss's rule of eight places on [-1, 1], those above 0: exact to 1e-14 for waves that turn once.
constexpr std::array<double, 4> gauss_places{0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                             0.9602898564975363};
constexpr std::array<double, 4> gauss_weights{0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                              0.1012285362903763};

double sinc(double t) { return std::abs(t) < 1e-8 ? 1 : std::sin(std::numbers::pi * t) / (std::numbers::pi * t); }

Complex wave(double turns) { return std::polar(1.0, -2 * std::numbers::pi * (turns - std::round(turns))); }

/// Places with weights along the boundary, in roots of the region's area on a torus of one.
struct BoundaryPlaces
{
    PointSet places{2, {}};
    std::vector<double> along_x, along_y; ///< the parts of d that each stands for
};

std::size_t pieces_of(const RegionEdge& e, double unit, int reach)
{
    const double turns = std::numbers::sqrt2 * reach * std::hypot(e.to[0] - e.from[0], e.to[1] - e.from[1]) / unit;
    return static_cast<std::size_t>(std::max(1.0, std::ceil(turns)));
}

double count_places(const FramedRegion& region, int reach)
{
    double places = 0;
    for (const RegionEdge& e : region.boundary().edges())
        places += 8 * static_cast<double>(pieces_of(e, region.unit_length(), reach));
    return places;
}

/// Calls take() with some of the places after the other, about `most` at once.
template <typename Take>
void for_boundary_places(const FramedRegion& region, int reach, std::size_t most, const Take& take)
{
    BoundaryPlaces result;
    const auto add = [&](double x, double y, double dx, double dy) {
        for (const double coordinate : {x, y})
            result.places.coordinates.push_back(std::min(coordinate - std::floor(coordinate), 1 - 0x1p-53));
        result.along_x.push_back(dx);
        result.along_y.push_back(dy);
    };
    const double unit = region.unit_length();
    for (const RegionEdge& e : region.boundary().edges()) {
        const double dx = (e.to[0] - e.from[0]) / unit, dy = (e.to[1] - e.from[1]) / unit;
        const std::size_t pieces = pieces_of(e, unit, reach);
        for (std::size_t k = 0; k < pieces; ++k) {
            for (std::size_t g = 0; g < 8; ++g) {
                const double place = g < 4 ? gauss_places[g] : -gauss_places[g - 4];
                const double t = (static_cast<double>(k) + (1 + place) / 2) / static_cast<double>(pieces);
                const double share = gauss_weights[g % 4] / 2 / static_cast<double>(pieces);
                add(e.from[0] / unit + t * dx, e.from[1] / unit + t * dy, share * dx, share * dy);
            }
            if (result.along_x.size() < most) continue;
            take(result);
            result = {};
        }
    }
    if (!result.along_x.empty()) take(result);
}

/// Points of the frame on the torus whose side is the root of the region's area.
PointSet on_torus(const PointSet& points, double unit)
{
    PointSet result = points;
    for (double& coordinate : result.coordinates) {
        coordinate /= unit;
        coordinate = std::min(coordinate - std::floor(coordinate), 1 - 0x1p-53);
    }
    return result;
}

/// The sums over points, by rotation along x from a wave that is computed for each row. No weights: all are 1.
HalfPlane exact_sums(const PointSet& points, std::span<const double> weights, double unit, int reach)
{
    HalfPlane sums(reach);
    tbb::parallel_for(-reach, reach + 1, [&](int v) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double x = points[i][0] / unit, y = points[i][1] / unit;
            const Complex turn = wave(x);
            Complex value = wave(v * y) * (weights.empty() ? 1 : weights[i]);
            for (int u = 0; u <= reach; ++u, value *= turn) sums.at(u, v) += value;
        }
    });
    return sums;
}

/// Adds a part to a sum, which has no values before the first.
void add_to(HalfPlane& sum, HalfPlane part)
{
    if (sum.values.empty()) {
        sum = std::move(part);
        return;
    }
    for (std::size_t i = 0; i < sum.values.size(); ++i) sum.values[i] += part.values[i];
}

HalfPlane exact_window(const FramedRegion& region, int reach)
{
    HalfPlane window(reach);
    tbb::parallel_for(-reach, reach + 1, [&](int v) {
        for (int u = 0; u <= reach; ++u) window.at(u, v) = region_transform(region, u, v);
    });
    return window;
}

}

std::complex<double> region_transform(const FramedRegion& region, double x, double y)
{
    if (x == 0 && y == 0) return 1;
    const double unit = region.unit_length();
    Complex sum = 0;
    for (const RegionEdge& e : region.boundary().edges()) {
        const double dx = (e.to[0] - e.from[0]) / unit, dy = (e.to[1] - e.from[1]) / unit;
        const double middle = x * (e.from[0] / unit + dx / 2) + y * (e.from[1] / unit + dy / 2);
        sum += (x * dy - y * dx) * sinc(x * dx + y * dy) * wave(middle);
    }
    return sum * Complex(0, 1 / (2 * std::numbers::pi * (x * x + y * y)));
}

HalfPlane region_transforms(const FramedRegion& region, int reach, NonuniformTransform& transform)
{
    const double places = count_places(region, reach);
    const double waves = static_cast<double>(region.boundary().edges().size()) * (reach + 1.0) * (2.0 * reach + 1);
    if (places > most_places_at_once && waves < waves_a_place * places) return exact_window(region, reach);
    HalfPlane window(reach), along_x(reach);
    window.values.clear();
    along_x.values.clear();
    for_boundary_places(region, reach, most_places_at_once, [&](const BoundaryPlaces& boundary) {
        add_to(window, transform.forward(boundary.places, boundary.along_y));
        add_to(along_x, transform.forward(boundary.places, boundary.along_x));
    });
    for (int v = -reach; v <= reach; ++v)
        for (int u = 0; u <= reach; ++u) {
            const double squared = double{1} * u * u + double{1} * v * v;
            window.at(u, v) = squared == 0 ? Complex(1)
                                           : (double{1} * u * window.at(u, v) - double{1} * v * along_x.at(u, v)) *
                                                 Complex(0, 1 / (2 * std::numbers::pi * squared));
        }
    return window;
}

RegionPeriodogram::RegionPeriodogram(std::shared_ptr<const FramedRegion> region, int size, bool is_exact)
    : region_(std::move(region)), size_(size),
      fast_(is_exact ? nullptr : std::make_unique<NonuniformTransform>(size / 2)),
      window_(is_exact ? exact_window(*region_, size / 2) : region_transforms(*region_, size / 2, *fast_))
{}

RegionPeriodogram::~RegionPeriodogram() = default;

HalfPlane region_sums(const PointSet& points, std::span<const double> weights, double unit, int reach,
                      NonuniformTransform* fast)
{
    return fast ? fast->forward(on_torus(points, unit), weights) : exact_sums(points, weights, unit, reach);
}

void RegionPeriodogram::compute(const PointSet& points, HalfSpectrum& result)
{
    const HalfPlane sums = region_sums(points, {}, region_->unit_length(), size_ / 2, fast_.get());
    const auto n = static_cast<double>(points.size());
    fill_with_powers(result, size_, n, [&](int u, int v) { return sums.at(u, v) - n * window_.at(u, v); });
}

}
