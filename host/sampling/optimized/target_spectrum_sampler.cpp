// The sampler "target-spectrum": what the config can ask of it.
#include "base/files/number_table.hpp"
#include "base/files/whole_file.hpp"
#include "base/files/xxh64_bytes.hpp"
#include "host/sampling/classics/plain_spec.hpp"
#include "host/sampling/one_file.hpp"
#include "host/sampling/optimized/target_spectrum.hpp"
#include "host/sampling/started_sampler.hpp"
#include "results/curve_tables.hpp"

#include <cmath>
#include <filesystem>

namespace poissonlab {
namespace {

/// The rows of a table, with two columns as people draw curves, or as in radial.csv: frequency and power come first.
std::vector<std::vector<double>> curve_rows(const std::filesystem::path& file)
{
    constexpr const char* drawn = "frequency,power";
    const std::string text = read_whole_file(file);
    if (text.substr(0, text.find('\n')) == drawn) return read_number_table(file, drawn, "frequencies");
    std::vector<std::vector<double>> rows;
    for (const RadialBin& bin : read_radial_table(file)) rows.push_back({bin.frequency, bin.power});
    return rows;
}

TargetCurve curve_of(const std::filesystem::path& file, double points)
{
    std::vector<double> frequencies, power;
    double before = -1;
    int line = 1;
    for (const auto& row : curve_rows(file)) {
        ++line;
        if (!(std::isfinite(row[0]) && row[0] >= 0 && row[0] > before))
            throw InputError::at({file.string(), line}, "frequencies must ascend, and not be negative");
        if (!(std::isfinite(row[1]) && row[1] >= 0))
            throw InputError::at({file.string(), line}, "power must be a number that is not negative");
        before = row[0];
        frequencies.push_back(row[0] / std::sqrt(points));
        power.push_back(row[1]);
    }
    return {std::move(frequencies), std::move(power)};
}

TargetCurve target_of(const Parameters& parameters, std::size_t points)
{
    if (parameters.text("target") != "curve")
        return step_curve(parameters.number("frequency"),
                          parameters.text("target") == "single-peak" ? parameters.number("peak") : 0);
    const double of_points = parameters.is_given("curve_points")
                                 ? static_cast<double>(parameters.integer("curve_points"))
                                 : static_cast<double>(points);
    return curve_of(one_file(parameters, "curve"), of_points);
}

/// Buffers on a device: none.
DeviceMemory no_memory(const Parameters&, std::size_t, int) { return {}; }

class TargetSpectrumSampler final : public StartedSampler
{
public:
    TargetSpectrumSampler(const Parameters& parameters, const SampleRequest& request, Engine engine,
                          const DeviceProvider& device)
        : StartedSampler("following a spectrum", no_memory, parameters, request, engine, device)
    {}

    PointSet sample(std::uint32_t realization) override
    {
        const PointSet points = start(realization);
        LloydResult result = follow_curve(points, target_of(parameters_, points.size()),
                                          static_cast<std::size_t>(parameters_.integer("iterations")));
        iterations_ = std::move(result.iterations);
        return std::move(result.points);
    }
};

std::vector<ParameterSpec> target_parameters()
{
    using Kind = ParameterSpec::Kind;
    return {
        {.key = "target",
         .kind = Kind::choice,
         .help = "the radially averaged power: a step, a step with a peak behind it, or that of a table",
         .choices = {"step", "single-peak", "curve"},
         .otherwise = "step"},
        {.key = "frequency",
         .help = "where the step is; sets can have one at 0.564 at most, and a peak lets it be farther",
         .unit = "square roots of the number of points",
         .maximum = 1.5,
         .exclusive_minimum = true,
         .otherwise = 0.55},
        {.key = "peak", .help = "height of the peak above 1", .maximum = 100, .otherwise = 2.0},
        {.key = "curve",
         .kind = Kind::paths,
         .help = "a table such as radial.csv, or of frequency,power alone, relative to the folder of the config",
         .unless_given = "needed with target = \"curve\""},
        {.key = "curve_points",
         .kind = Kind::integer,
         .help = "points of the sets that the table is about",
         .minimum = 1,
         .maximum = 1 << 27,
         .unless_given = "as many as here"},
        {.key = "iterations",
         .kind = Kind::integer,
         .help = "steps that all points take, at most",
         .maximum = 1'000'000,
         .symbol = "i",
         .otherwise = std::int64_t{300}},
        start_parameter(),
    };
}

void check_target(const Parameters& parameters, const SampleRequest& request, const SourceLocation& where)
{
    const std::string& target = parameters.text("target");
    if (target == "curve" && !parameters.is_given("curve"))
        throw InputError::at(where, "sampler = \"target-spectrum\": target = \"curve\" needs curve, a table");
    for (const char* key : {"curve", "curve_points"})
        if (target != "curve" && parameters.is_given(key)) throw parameters.error(key, "needs target = \"curve\"");
    if (target == "curve" && parameters.is_given("frequency"))
        throw parameters.error("frequency", "cannot be combined with target = \"curve\"");
    if (target != "single-peak" && parameters.is_given("peak"))
        throw parameters.error("peak", "needs target = \"single-peak\"");
    target_of(parameters, request.points);
}

}

SamplerSpec target_spectrum_sampler()
{
    SamplerSpec spec = plain_spec("target-spectrum", "Target spectrum",
                                  "points whose radially averaged power follows a curve (after Heck and others 2013)",
                                  {2}, target_parameters());
    spec.check = check_target;
    describe_start(spec, no_memory);
    spec.memory_growth = MemoryGrowth::none;
    spec.outside_input = [](const Parameters& parameters) -> std::uint64_t {
        Xxh64 hash;
        if (parameters.is_given("curve")) hash.add(read_whole_file(one_file(parameters, "curve")));
        return hash.value();
    };
    spec.create = [](const Parameters& given, const SampleRequest& request, Engine engine,
                     const DeviceProvider& device) -> std::unique_ptr<Sampler> {
        return std::make_unique<TargetSpectrumSampler>(given, request, engine, device);
    };
    return spec;
}

}
