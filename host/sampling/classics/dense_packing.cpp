#include "host/sampling/classics/dense_packing.hpp"

#include "base/geometry/relative_radius.hpp"
#include "host/sampling/classics/plain_spec.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace poissonlab {
namespace {

/// Rows and points in a row of a hexagonal lattice on the unit torus.
struct HexagonalRows
{
    std::uint64_t rows = 2; ///< even, so that the torus closes
    std::uint64_t columns = 1;
};

double relative_radius_of(const HexagonalRows& h)
{
    const double along = 1.0 / static_cast<double>(h.columns), up = 1.0 / static_cast<double>(h.rows);
    const double distance = std::min({along, std::hypot(along / 2, up), 2 * up});
    return relative_radius(distance, h.rows * h.columns, 2);
}

HexagonalRows best_rows(std::size_t points)
{
    HexagonalRows best;
    double best_radius = 0;
    const auto n = static_cast<double>(points);
    // Rows are 2 / sqrt 3 times as many as columns; numbers near that are tried.
    const auto middle = static_cast<std::uint64_t>(std::sqrt(n * 2 / std::sqrt(3.0)) / 2);
    for (std::uint64_t half = std::max<std::uint64_t>(1, middle - std::min<std::uint64_t>(middle, 8));
         half <= middle + 8; ++half) {
        const auto columns =
            std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::lround(n / (2.0 * static_cast<double>(half)))));
        const HexagonalRows rows{2 * half, columns};
        const double radius = relative_radius_of(rows);
        if (radius <= best_radius) continue;
        best = rows;
        best_radius = radius;
    }
    return best;
}

/// The quarter k of n quarters of the torus' side, in 2^-32.
double quarter(std::uint64_t k, std::uint64_t n)
{
    constexpr std::uint64_t side = std::uint64_t{1} << 32;
    return static_cast<double>(k * (side / 4) / n) / static_cast<double>(side);
}

PointSet hexagonal(std::size_t points)
{
    const HexagonalRows h = best_rows(points);
    PointSet set{2, {}};
    for (std::uint64_t row = 0; row < h.rows; ++row)
        for (std::uint64_t column = 0; column < h.columns; ++column) {
            set.coordinates.push_back(quarter(4 * column + 1 + 2 * (row % 2), h.columns));
            set.coordinates.push_back(quarter(4 * row + 2, h.rows));
        }
    return set;
}

/// Cubes of the face-centred cubic lattice along an axis.
std::uint64_t cubes(std::size_t points)
{
    return std::max<std::uint64_t>(1,
                                   static_cast<std::uint64_t>(std::lround(std::cbrt(static_cast<double>(points) / 4))));
}

PointSet face_centred(std::size_t points)
{
    constexpr std::array<std::array<std::uint64_t, 3>, 4> cube{{{1, 1, 1}, {3, 3, 1}, {3, 1, 3}, {1, 3, 3}}};
    const std::uint64_t n = cubes(points);
    PointSet set{3, {}};
    for (std::uint64_t i = 0; i < n * n * n; ++i)
        for (const auto& at : cube) {
            const std::array<std::uint64_t, 3> place{i % n, i / n % n, i / n / n};
            for (std::size_t k = 0; k < 3; ++k) set.coordinates.push_back(quarter(4 * place[k] + at[k], n));
        }
    return set;
}

class HexagonalSampler final : public Sampler
{
public:
    explicit HexagonalSampler(const SampleRequest& request) : request_(request) {}

    PointSet sample(std::uint32_t) override
    {
        return request_.dimension == 2 ? hexagonal(request_.points) : face_centred(request_.points);
    }

private:
    SampleRequest request_;
};

}

SamplerSpec hexagonal_sampler()
{
    SamplerSpec spec =
        plain_spec("hexagonal", "Hexagonal lattice",
                   "the densest packing, hexagonal (3D: face-centred cubic); of about as many points", {2, 3});
    spec.deterministic = true;
    spec.most_points = [](const Parameters&, const SampleRequest& request) -> std::size_t {
        if (request.dimension == 3) return 4 * cubes(request.points) * cubes(request.points) * cubes(request.points);
        const HexagonalRows h = best_rows(request.points);
        return h.rows * h.columns;
    };
    spec.create = [](const Parameters&, const SampleRequest& request, Engine, const DeviceProvider&) {
        return std::make_unique<HexagonalSampler>(request);
    };
    return spec;
}

}
