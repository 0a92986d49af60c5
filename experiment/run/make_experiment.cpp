#include "experiment/run/make_experiment.hpp"

#include "analysis/regions/framed_region.hpp"
#include "base/crew/crew.hpp"
#include "base/crew/thread_limit.hpp"
#include "experiment/config/plan.hpp"
#include "host/device/device.hpp"
#include "host/sampling/reference/reference_engine.hpp"
#include "host/settings/method_needs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <set>

namespace poissonlab {
namespace {

/// The device of a run, opened when it is first needed.
class LazyDevice
{
public:
    LazyDevice(std::string selector, unsigned threads, Engine engine)
        : selector_(std::move(selector)), threads_(threads), engine_(engine)
    {
        if (!selector_.empty()) Device::find(selector_, needs_); // a device that was named must be there
    }

    /// The default device is one that meets these needs, if there is one. Before the device is used.
    void look_for(const KernelNeeds& needs) { needs_ = needs; }

    bool is_open() const { return device_.has_value(); }

    Device& get()
    {
        if (!device_) device_ = Device::open(selector_, threads_, needs_);
        return *device_;
    }

    std::string identity()
    {
        const auto info = described();
        return info ? info->identity() : "none";
    }

    std::string name()
    {
        const auto info = described();
        return info ? info->platform + ", " + info->name : "none";
    }

private:
    /// The device, or std::nullopt if none is needed or none is there.
    const std::optional<DeviceInfo>& described()
    {
        if (is_described_ || engine_ != Engine::opencl) return info_;
        is_described_ = true;
        try {
            info_ = Device::find(selector_, needs_);
        } catch (const DeviceError&) {
            // A missing device is an error only for work that needs one, which will say so.
        }
        return info_;
    }

    std::string selector_;
    unsigned threads_;
    Engine engine_;
    KernelNeeds needs_ = all_kernel_needs();
    std::optional<Device> device_;
    std::optional<DeviceInfo> info_;
    bool is_described_ = false;
};

Machine machine_of(LazyDevice& lazy, bool with_device)
{
    Machine machine;
    machine.threads = ThreadLimit::current();
    if (!with_device) return machine;
    const DeviceInfo& info = lazy.get().info();
    machine.device = info.name;
    machine.platform = info.platform;
    machine.driver = info.driver_version;
    machine.device_version = info.device_version;
    machine.compute_units = info.compute_units;
    return machine;
}

/// Adds the files and programs on which the sets of a method depend, and those of the sets that it starts from.
void add_outside_input(UnitKey& key, const SamplerSpec& sampler, const Parameters& parameters)
{
    if (sampler.outside_input) key.add("input", sampler.outside_input(parameters));
    for (const auto& [name, entry] : parameters.given())
        if (const SamplerChoice* start = as_sampler(entry.value))
            add_outside_input(key, *start->spec, start->parameters);
}

UnitKey identity_of(const SeriesPlan& series, Engine engine, LazyDevice& device)
{
    UnitKey key("sets");
    key.add("sampler", series.sampler->name);
    for (const auto& [name, entry] : series.parameters.given()) key.add(name, to_string(entry.value));
    add_outside_input(key, *series.sampler, series.parameters);
    if (series.request.region) key.add("region", series.request.region->hash());
    return key.add("points", series.request.points)
        .add("dimension", series.request.dimension)
        .add("seed", series.request.seed)
        .add("engine", engines[engine])
        .add("device", device.identity());
}

SeriesTask make_task(const SeriesPlan& series, Engine engine, const std::shared_ptr<LazyDevice>& device,
                     const std::shared_ptr<Workplace>& workplace)
{
    SeriesTask task{series};
    task.identity = [series, engine, device] { return identity_of(series, engine, *device); };
    task.create = [series, engine, device, workplace = std::weak_ptr(workplace)] {
        SampleRequest request = series.request;
        request.on_step = [workplace](const std::string& what) {
            const auto there = workplace.lock();
            if (there && there->on_step) there->on_step(what);
        };
        return series.sampler->create(series.parameters, request, engine,
                                      [device]() -> Device& { return device->get(); });
    };
    return task;
}

/// The needs of a plan's methods. Tables beside them may take any kernel.
KernelNeeds needs_of_plan(const std::vector<SeriesPlan>& plan, const std::vector<Exhibit>& exhibits)
{
    if (std::ranges::any_of(exhibits, [](const Exhibit& exhibit) { return exhibit.kind->uses_device; }))
        return all_kernel_needs();
    KernelNeeds needs;
    for (const SeriesPlan& series : plan)
        needs |= needs_of(*series.sampler, series.parameters, series.request.dimension);
    return needs;
}

/// The device that a plan will work on, if it needs one. A missing device is no error here, as everything may be stored
/// already.
std::optional<DeviceInfo> device_of_plan(const std::vector<SeriesPlan>& plan, const std::vector<Exhibit>& exhibits,
                                         Engine engine, const std::string& selector, const KernelNeeds& needs)
{
    const bool needs_device = std::ranges::any_of(
        plan, [](const SeriesPlan& series) { return static_cast<bool>(series.sampler->device_memory); });
    const bool shows_device = std::ranges::any_of(
        exhibits, [](const Exhibit& exhibit) { return static_cast<bool>(exhibit.kind->device_memory); });
    if (engine != Engine::opencl || (!needs_device && !shows_device)) return std::nullopt;
    const std::vector<DeviceInfo> devices = list_devices();
    if (devices.empty()) return std::nullopt;
    const DeviceInfo& device = devices[choose_device(devices, selector, needs)];
    return device.unusable.empty() ? std::optional(device) : std::nullopt;
}

/// Checks that the device has memory for the plan.
void check_memory_of_device(const DeviceInfo& device, const std::vector<SeriesPlan>& plan,
                            const std::vector<Exhibit>& exhibits)
{
    const DeviceInfo share = share_of(device, crew_processes_here());
    check_device_memory(plan, share);
    check_device_memory(exhibits, share);
}

/// Takes the series out of a plan that cannot be made on this machine; says which, and why. Throws InputError where
/// the experiment has nothing else.
std::vector<std::string> leave_out(std::vector<SeriesPlan>& plan, const Config& config)
{
    std::vector<std::string> left_out;
    std::erase_if(plan, [&](const SeriesPlan& series) {
        const auto why = series.sampler->absence ? series.sampler->absence(series.parameters) : std::nullopt;
        if (why) left_out.push_back(fmt::format("{}: left out: {}", series.label, *why));
        return why.has_value();
    });
    if (plan.empty() && !left_out.empty() && config.tables.empty())
        throw InputError::at({config.file}, "no series is left. " + left_out.front());
    return left_out;
}

/// The name of a folder that no other has.
std::string unused_name(const std::string& base, std::set<std::string>& names)
{
    std::string name = base;
    for (int number = 2; !names.insert(name).second; ++number) name = fmt::format("{}-{}", base, number);
    return name;
}

/// The exhibits that the tables ask for, each in a folder of its own.
std::vector<Exhibit> exhibits_of(const Config& config, std::set<std::string>& names)
{
    std::vector<Exhibit> exhibits = read_exhibits(config);
    for (Exhibit& exhibit : exhibits) exhibit.name = unused_name(exhibit.name, names);
    return exhibits;
}

/// Returns the sentences that the samplers of a plan say of their sets, each once.
std::vector<std::string> notes_of(const std::vector<SeriesPlan>& plan)
{
    std::vector<std::string> notes;
    for (const SeriesPlan& series : plan) {
        if (!series.sampler->notes) continue;
        for (std::string& note : series.sampler->notes(series.parameters, series.request))
            if (std::ranges::find(notes, note) == notes.end()) notes.push_back(std::move(note));
    }
    return notes;
}

}

Experiment make_experiment(const Config& config, const std::string& device, unsigned threads)
{
    if (config.engine == Engine::reference) need_reference_engine();
    const auto lazy = std::make_shared<LazyDevice>(device, threads, config.engine);

    Experiment experiment;
    experiment.title = config.title;
    experiment.config = config.text;
    experiment.overrides = config.overrides;
    experiment.seed = config.seed;
    experiment.engine = engines[config.engine];
    experiment.dimension = config.dimension;
    experiment.analysis = config.analysis;
    experiment.realizations = static_cast<std::uint32_t>(config.realizations);
    experiment.timing_runs = static_cast<std::uint32_t>(config.timing_runs);
    experiment.methods = method_grids(config);
    std::vector<SeriesPlan> plan = make_plan(config);
    experiment.left_out = leave_out(plan, config);
    experiment.notes = notes_of(plan);
    std::set<std::string> names; // folders of the series come first
    for (const SeriesPlan& series : plan) names.insert(series.name);
    experiment.exhibits = exhibits_of(config, names);
    const KernelNeeds needs = needs_of_plan(plan, experiment.exhibits);
    lazy->look_for(needs);
    const std::optional<DeviceInfo> info = device_of_plan(plan, experiment.exhibits, config.engine, device, needs);
    if (info) check_memory_of_device(*info, plan, experiment.exhibits);
    for (const SeriesPlan& series : plan) {
        experiment.series.push_back(make_task(series, config.engine, lazy, experiment.workplace));
        if (info && series.sampler->device_memory)
            experiment.series.back().device_bytes =
                series.sampler->device_memory(series.parameters, series.request, *info).total;
    }
    experiment.place = {config.engine, [lazy]() -> Device& { return lazy->get(); }};
    Workplace& workplace = *experiment.workplace;
    workplace.identity = [lazy] { return lazy->identity(); };
    workplace.machine_conditions = [lazy] {
        return fmt::format("device: {}; threads: {}", lazy->name(), ThreadLimit::current());
    };
    workplace.is_device_open = [lazy] { return lazy->is_open(); };
    workplace.machine = [lazy](bool with_device) { return machine_of(*lazy, with_device); };
    if (config.engine == Engine::opencl && !device.empty()) lazy->get();
    return experiment;
}

}
