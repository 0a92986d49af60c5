// Coordinates are 32-bit fixed point: whole multiples of 2^-32. In these units the torus has side 2^32, and
// the cell k of n along an axis holds the coordinates u with floor(u n / 2^32) = k, exactly.
#include "host/sampling/baselines.hpp"

#include "base/geometry/lattice.hpp"
#include "base/random/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace poissonlab {

namespace {

constexpr std::uint64_t torus_side = std::uint64_t{1} << 32;

double coordinate(std::uint64_t u) { return static_cast<double>(u) / static_cast<double>(torus_side); }

/// The words for a point: a function of its stream and index alone.
std::array<std::uint32_t, 4> words_of_point(std::size_t index, const StreamKey& stream)
{
    const auto i = static_cast<std::uint64_t>(index);
    return philox({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i >> 32), 0, 0}, stream);
}

/// The first coordinate of cell k of n.
std::uint64_t cell_begin(std::uint64_t k, std::uint64_t n) { return (k * torus_side + n - 1) / n; }

/// A point for each cell of the lattice, x fastest. `place(index, axis, k)` gives the coordinate in [0, 2^32)
/// along an axis, in the column, row or slice k.
template <class Place>
PointSet one_point_a_cell(std::uint32_t side, int dimension, const Place& place)
{
    const std::size_t cells = static_cast<std::size_t>(std::pow(side, dimension));
    PointSet points{dimension, {}};
    points.coordinates.reserve(cells * static_cast<std::size_t>(dimension));
    for (std::size_t index = 0; index < cells; ++index) {
        std::size_t remaining = index;
        for (int axis = 0; axis < dimension; ++axis) {
            points.coordinates.push_back(coordinate(place(index, axis, remaining % side)));
            remaining /= side;
        }
    }
    return points;
}

class RandomSampler : public Sampler
{
public:
    explicit RandomSampler(const SampleRequest& request) : request_(request) {}

    PointSet sample(std::uint32_t realization) override
    {
        return {request_.dimension,
                random_points_from(0, request_.points, request_.dimension, request_.seed, realization)};
    }

private:
    SampleRequest request_;
};

class RegularSampler : public Sampler
{
public:
    explicit RegularSampler(const SampleRequest& request)
        : side_(lattice_side(request.points, request.dimension)), dimension_(request.dimension)
    {}

    PointSet sample(std::uint32_t) override
    {
        // The centre (k + 1/2) / n, rounded down to fixed point.
        return one_point_a_cell(side_, dimension_, [this](std::size_t, int, std::uint64_t k) {
            return (2 * k + 1) * (torus_side / 2) / side_;
        });
    }

private:
    std::uint32_t side_;
    int dimension_;
};

class JitteredSampler : public Sampler
{
public:
    explicit JitteredSampler(const SampleRequest& request)
        : side_(lattice_side(request.points, request.dimension)), dimension_(request.dimension), seed_(request.seed)
    {}

    PointSet sample(std::uint32_t realization) override
    {
        const StreamKey stream = stream_key(seed_, Purpose::jittered_points, realization);
        std::array<std::uint32_t, 4> words{};
        return one_point_a_cell(side_, dimension_, [&](std::size_t index, int axis, std::uint64_t k) {
            if (axis == 0) words = words_of_point(index, stream);
            const std::uint64_t begin = cell_begin(k, side_);
            const std::uint64_t width = cell_begin(k + 1, side_) - begin;
            return begin + (words[static_cast<std::size_t>(axis)] * width >> 32);
        });
    }

private:
    std::uint32_t side_;
    int dimension_;
    std::uint64_t seed_;
};

/// The description that the three share: no parameters, nothing to check.
template <class BaselineSampler>
SamplerSpec describe(std::string name, std::string title, std::string summary)
{
    SamplerSpec spec;
    spec.name = std::move(name);
    spec.title = std::move(title);
    spec.summary = std::move(summary);
    spec.dimensions = {2, 3};
    spec.check = [](const Parameters&, const SampleRequest&, const SourceLocation&) {};
    spec.create = [](const Parameters&, const SampleRequest& request, Engine, const DeviceProvider&) {
        return std::make_unique<BaselineSampler>(request);
    };
    return spec;
}

}

std::uint32_t lattice_side(std::size_t points, int dimension)
{
    const auto n = static_cast<double>(points);
    const double root = std::floor(dimension == 2 ? std::sqrt(n) : std::cbrt(n));
    const double below = std::max(1.0, root);
    // No tie: side^dimension and (side + 1)^dimension have an odd sum.
    const bool above_is_nearer = std::pow(below + 1, dimension) - n < n - std::pow(below, dimension);
    return static_cast<std::uint32_t>(above_is_nearer ? below + 1 : below);
}

std::size_t lattice_points(const Parameters&, const SampleRequest& request)
{
    return lattice_cells(lattice_side(request.points, request.dimension), request.dimension);
}

std::vector<double> random_points_from(std::uint64_t first, std::size_t count, int dimension, std::uint64_t seed,
                                       std::uint32_t realization)
{
    const StreamKey stream = stream_key(seed, Purpose::random_points, realization);
    const auto axes = static_cast<std::size_t>(dimension);
    std::vector<double> coordinates;
    coordinates.reserve(count * axes);
    for (std::size_t i = 0; i < count; ++i) {
        const auto words = words_of_point(first + i, stream);
        for (std::size_t axis = 0; axis < axes; ++axis) coordinates.push_back(coordinate(words[axis]));
    }
    return coordinates;
}

SamplerSpec random_sampler()
{
    return describe<RandomSampler>("random", "Random", "independent uniform points (a Poisson process)");
}

SamplerSpec regular_sampler()
{
    SamplerSpec spec = describe<RegularSampler>(
        "regular", "Regular", "a square (3D: cubic) lattice; of as many points as the nearest square (cube) number");
    spec.deterministic = true;
    spec.most_points = lattice_points;
    return spec;
}

SamplerSpec jittered_sampler()
{
    SamplerSpec spec = describe<JitteredSampler>(
        "jittered", "Jittered",
        "one uniform point in each cell of a lattice; of as many points as the nearest square (cube) number");
    spec.most_points = lattice_points;
    return spec;
}

}
