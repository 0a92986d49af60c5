#include "experiment/config_run.hpp"

#include "device/device.hpp"
#include "experiment/plan.hpp"
#include "experiment/plan_memory.hpp"
#include "experiment/thread_limit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <set>

namespace poissonlab {
namespace {

/// The device of a run, opened when it is first needed.
struct LazyDevice
{
    std::string selector;
    unsigned threads = 0;
    std::optional<Device> device;

    Device& get()
    {
        if (!device) device = Device::open(selector, threads);
        return *device;
    }
};

Machine machine_of(const LazyDevice& lazy)
{
    Machine machine;
    machine.threads = ThreadLimit::current();
    if (!lazy.device) return machine;
    const DeviceInfo& info = lazy.device->info();
    machine.device = info.name;
    machine.platform = info.platform;
    machine.driver = info.driver_version;
    machine.device_version = info.device_version;
    machine.compute_units = info.compute_units;
    return machine;
}

SeriesTask make_task(const SeriesPlan& series, Engine engine, const std::shared_ptr<LazyDevice>& device)
{
    SeriesTask task;
    task.name = series.name;
    task.label = series.label;
    task.sampler = series.sampler->name;
    task.parameters = series.parameters;
    task.deterministic = series.deterministic;
    task.realizations = series.realizations;
    task.is_timed = !series.sampler->has_own_points;
    task.place = series.place;
    task.create = [series, engine, device] {
        return series.sampler->create(series.parameters, series.request, engine,
                                      [device]() -> Device& { return device->get(); });
    };
    return task;
}

/// Where there is no usable device that is left to whoever needs one: everything may be stored already.
void check_memory_of_device(const std::vector<SeriesPlan>& plan, const std::string& selector)
{
    const bool needs_device = std::ranges::any_of(plan, [](const SeriesPlan& series) {
        return static_cast<bool>(series.sampler->device_memory);
    });
    if (!needs_device) return;
    const std::vector<DeviceInfo> devices = list_devices();
    if (devices.empty()) return;
    const DeviceInfo& device = devices[choose_device(devices, selector)];
    if (device.unusable.empty()) check_device_memory(plan, device);
}

/// The name of a folder that no other has.
std::string unused_name(const std::string& base, std::set<std::string>& names)
{
    std::string name = base;
    for (int number = 2; !names.insert(name).second; ++number) name = fmt::format("{}-{}", base, number);
    return name;
}

std::vector<TilingTask> tiling_tasks(const Config& config, std::set<std::string>& names)
{
    std::vector<TilingTask> tasks;
    for (const TilingConfig& tiling : config.tilings) {
        const std::string kind = tiling.request.kind == TileKind::wang     ? "wang"
                                 : tiling.request.kind == TileKind::corner ? "corner"
                                                                           : "cube";
        const std::string base = fmt::format("{}-{}-{}-C-{}", tiling.is_set() ? "tile-set" : "tiling", kind,
                                             tiling.is_set() ? tiling.set : tiling.request.algorithm,
                                             tiling.request.colors);
        tasks.push_back({unused_name(base, names), tiling});
    }
    return tasks;
}

std::vector<ConstructionTask> construction_tasks(const Config& config, std::set<std::string>& names)
{
    std::vector<ConstructionTask> tasks;
    for (const ConstructionConfig& construction : config.constructions) {
        const std::string base =
            fmt::format("construction-{}-{}", kind_name(construction.parameters), construction.show);
        tasks.push_back({unused_name(base, names), construction});
    }
    return tasks;
}

}

Experiment make_experiment(const Config& config, const std::string& device, unsigned threads)
{
    auto lazy = std::make_shared<LazyDevice>();
    lazy->selector = device;
    lazy->threads = threads;

    Experiment experiment;
    experiment.title = config.title;
    experiment.config = config.text;
    experiment.overrides = config.overrides;
    experiment.seed = config.seed;
    experiment.engine = config.engine == Engine::opencl ? "opencl" : "reference";
    experiment.dimension = config.dimension;
    experiment.analysis = config.analysis;
    experiment.realizations = static_cast<std::uint32_t>(config.realizations);
    experiment.timing_runs = static_cast<std::uint32_t>(config.timing_runs);
    experiment.methods = method_grids(config);
    const std::vector<SeriesPlan> plan = make_plan(config);
    if (config.engine == Engine::opencl) check_memory_of_device(plan, device);
    for (const SeriesPlan& series : plan)
        experiment.series.push_back(make_task(series, config.engine, lazy));
    std::set<std::string> names; // folders of the series come first
    for (const SeriesTask& task : experiment.series) names.insert(task.name);
    experiment.tilings = tiling_tasks(config, names);
    experiment.constructions = construction_tasks(config, names);
    experiment.make_filler = [lazy, engine = config.engine](const FillSettings& settings) {
        return engine == Engine::opencl ? make_tile_filler(settings, lazy->get())
                                        : reference::make_tile_filler(settings);
    };
    experiment.machine = [lazy] { return machine_of(*lazy); };
    if (config.engine == Engine::opencl && !device.empty()) lazy->get();
    return experiment;
}

}
