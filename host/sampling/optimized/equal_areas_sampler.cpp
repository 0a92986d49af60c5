// The sampler "equal-areas": what the config can ask of it.
#include "host/sampling/classics/plain_spec.hpp"
#include "host/sampling/optimized/equal_areas.hpp"
#include "host/sampling/started_sampler.hpp"

namespace poissonlab {
namespace {

DeviceMemory equal_areas_memory(const Parameters&, std::size_t points, int) { return PowerDiagram::memory(points); }

class EqualAreasSampler final : public StartedSampler
{
public:
    EqualAreasSampler(const Parameters& parameters, const SampleRequest& request, Engine engine,
                      const DeviceProvider& device)
        : StartedSampler("making areas equal", equal_areas_memory, parameters, request, engine, device),
          moves_(static_cast<std::size_t>(parameters.integer("iterations")))
    {}

    PointSet sample(std::uint32_t realization) override
    {
        const PointSet points = start(realization);
        PowerCellsOf cells_of = reference::power_cells;
        if (device_)
            cells_of = [diagram = PowerDiagram(*device_, points.size())](const PointSet& set,
                                                                         const std::vector<double>& weights) mutable {
                return diagram.cells(set, weights);
            };
        EqualAreas result = equalize_areas(points, moves_, cells_of);
        iterations_ = std::move(result.iterations);
        return std::move(result.points);
    }

private:
    std::size_t moves_;
};

}

SamplerSpec equal_areas_sampler()
{
    SamplerSpec spec =
        plain_spec("equal-areas", "Equal areas",
                   "points at the centroids of cells of a power diagram that all have the same area (de Goes and "
                   "others 2012)",
                   {2},
                   {
                       {.key = "iterations",
                        .kind = ParameterSpec::Kind::integer,
                        .help = "moves of all points to their centroids",
                        .maximum = 1'000'000,
                        .symbol = "i",
                        .otherwise = std::int64_t{100}},
                       start_parameter(),
                   });
    describe_start(spec, equal_areas_memory);
    spec.kernels = {"point_grid.cl", "power_cells.cl"};
    spec.create = [](const Parameters& given, const SampleRequest& request, Engine engine,
                     const DeviceProvider& device) -> std::unique_ptr<Sampler> {
        return std::make_unique<EqualAreasSampler>(given, request, engine, device);
    };
    return spec;
}

}
