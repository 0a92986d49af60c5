#include "host/tile_sampling/dodecagonal/dodecagonal_sampler.hpp"

#include "base/errors/errors.hpp"
#include "base/random/random.hpp"
#include "host/sampling/classics/plain_spec.hpp"
#include "host/sampling/density_parameters.hpp"
#include "tiles/dodecagonal/dodecagonal_sequence.hpp"

#include <memory>

namespace poissonlab {
namespace {

/// The attempt of the stream that places squares; isohedral tiles and monotiles, which share the stream, use 1 and 2.
constexpr std::uint32_t square_attempt = 3;

DodecagonalMiddle middle_of(std::uint64_t seed, std::uint32_t realization)
{
    const StreamKey stream = stream_key(seed, Purpose::isohedral_points, realization, square_attempt);
    const auto place = philox({0, 0, 0, 0}, stream), shift = philox({1, 0, 0, 0}, stream);
    const auto coefficient = [](std::uint32_t word) { return std::int64_t{word >> 8} - (1 << 23); };
    return {place_with_vertices(coefficient(place[0]), coefficient(place[1])),
            {shift[0] * 0x1p-32, shift[1] * 0x1p-32}};
}

class DodecagonalSampler final : public Sampler
{
public:
    DodecagonalSampler(const Parameters& given, const SampleRequest& request)
        : points_(request.points), seed_(request.seed)
    {
        if (const auto density = given_density(given)) density_ = DensityBounds(*density);
    }

    PointSet sample(std::uint32_t realization) override
    {
        PointSet set;
        for (const DodecagonalPoint& point :
             DodecagonalSequence(middle_of(seed_, realization)).points(points_, density_))
            set.coordinates.insert(set.coordinates.end(), point.place.begin(), point.place.end());
        return set;
    }

    SetTraits traits() const override { return {.is_window = true, .is_progressive = true}; }

private:
    std::size_t points_;
    std::uint64_t seed_;
    DensityBounds density_;
};

}

SamplerSpec dodecagonal_sampler()
{
    SamplerSpec spec = plain_spec("dodecagonal", "Dodecagonal tiling",
                                  "a sequence of the vertices of a dodecagonal tiling, of any density; every prefix is "
                                  "well spread",
                                  {2}, density_parameters());
    spec.outside_input = density_hash;
    spec.check = [](const Parameters& given, const SampleRequest& request, const SourceLocation&) {
        const auto density = given_density(given);
        if (!density) return;
        try {
            check_dodecagonal_density(request.points, DensityBounds(*density));
        } catch (const InputError& error) {
            throw given.error("density", error.what());
        }
    };
    spec.create = [](const Parameters& given, const SampleRequest& request, Engine, const DeviceProvider&) {
        return std::make_unique<DodecagonalSampler>(given, request);
    };
    return spec;
}

}
