#include "app/commands/large_sets/relaxed_points.hpp"

#include "base/crew/thread_limit.hpp"
#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"
#include "host/large_sets/slab_points.hpp"
#include "host/large_sets/slab_relaxation.hpp"
#include "host/sampling/optimized/gaussian_blue_noise.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace poissonlab {
namespace {

/// Points have numbers of 32 bits, and cells of grids, of which there may be as many, those of 31.
constexpr std::int64_t most_relaxed_points = std::int64_t{1} << 31;

/// The facts that are printed of the set.
struct MadeSet
{
    std::uint64_t points = 0;
    std::size_t iteration = 0; ///< that is kept
    double relative_radius = 0;
};

/// A start from files is read to know how many points it has.
SampleRequest request_of(const AskedRelaxation& asked, std::uint64_t seed)
{
    SampleRequest request{static_cast<std::size_t>(asked.points.value_or(0)), asked.dimension, seed};
    if (asked.points) return request;
    const SamplerChoice& start = asked.parameters.sampler("start");
    request.points = start.spec->create(start.parameters, request, Engine::reference, {})->sample(0).size();
    if (request.points > static_cast<std::size_t>(most_relaxed_points))
        throw InputError(
            fmt::format("--start: has {} points: must have at most {}", request.points, most_relaxed_points));
    return request;
}

/// The numbers of points of the method's levels; the start is asked for the first.
std::vector<std::size_t> levels_of(const SampleRequest& request, const Parameters& parameters,
                                   const RelaxedMethod& method)
{
    return level_points(request.points, request.dimension, method.coarser_levels(parameters));
}

/// Throws InputError where a start has no such sets, as the value of --start.
void check_start(const SamplerChoice& start, const SampleRequest& request)
{
    const SourceLocation place{"--start", 0, true};
    try {
        if (std::ranges::find(start.spec->dimensions, request.dimension) == start.spec->dimensions.end())
            throw InputError::at(place, fmt::format("{}: has no {}D sets", start.spec->name, request.dimension));
        if (start.spec->check) start.spec->check(start.parameters, request, place);
    } catch (const InputError& error) { // its keys are not those of the command; files have places of their own
        const bool is_of_file = !error.place().file.empty() && !error.place().is_argument;
        throw InputError(is_of_file ? fmt::format("--start: {}", error.what()) : error.moved_to(place).what());
    }
}

/// Asks the start and the method whether they can make the set. Throws InputError, which may name a key.
void check_methods(const AskedRelaxation& asked, const RelaxedMethod& method)
{
    SampleRequest request{static_cast<std::size_t>(asked.points.value_or(0)), asked.dimension, 1};
    request.points = levels_of(request, asked.parameters, method).front();
    check_start(asked.parameters.sampler("start"), request);
    method.spec.check(asked.parameters, request_of(asked, 1), {});
}

/// The work of a command in one process of the crew.
class RelaxationWork
{
public:
    RelaxationWork(const KindOptions& options, const RelaxedMethod& method, Crew& crew)
        : options_(options), method_(method), crew_(crew)
    {}

    /// Reads and checks what is asked for. False where a process failed.
    bool prepare()
    {
        const bool is_planned = crew_.together([&] {
            asked_ = options_.read<AskedRelaxation>();
            checked_output(options_.command(), "--out", options_.out, point_formats());
            place_.emplace(options_.place(!crew_.leads()));
            request_ = request_of(asked_, options_.seed());
            head_ = {.dimension = asked_.dimension, .points = request_.points};
            check_head(options_.out, head_);
            check_room(options_.out, head_);
            if (place_->engine == Engine::opencl) plan(1);
        });
        return is_planned && (place_->engine == Engine::reference || agree_on_slabs());
    }

    /// Makes the set and writes it.
    void work()
    {
        if (place_->engine == Engine::reference ? !make_plainly() : !make_in_slabs()) return;
        if (!crew_.leads()) return;
        options_.say_written(fmt::format("{} points of relative radius {:.4f}", made_.points, made_.relative_radius));
        if (options_.prints_json())
            fmt::print("{}\n", nlohmann::ordered_json{{"file", printable(options_.out.string())},
                                                      {"points", made_.points},
                                                      {"dimension", asked_.dimension},
                                                      {"slabs", slabs()},
                                                      {"planned_bytes", plan_.process_bytes},
                                                      {"iteration", made_.iteration},
                                                      {"relative_radius", made_.relative_radius}}
                                   .dump(2));
    }

private:
    /// The plain program makes the set as a whole.
    std::uint32_t slabs() const
    {
        return place_->engine == Engine::reference ? 1 : plan_.slabs * static_cast<std::uint32_t>(crew_.size());
    }

    const SamplerChoice& start_choice() const { return asked_.parameters.sampler("start"); }

    std::vector<std::size_t> levels() const { return levels_of(request_, asked_.parameters, method_); }

    SampleRequest start_request() const
    {
        return {levels().front(), asked_.dimension, options_.seed(), place_->on_step};
    }

    /// The plan of the finest level, which takes the most.
    void plan(std::uint32_t least_slabs)
    {
        const SlabTask task{.dimension = asked_.dimension,
                            .points = request_.points,
                            .processes = static_cast<std::uint32_t>(crew_.size()),
                            .processes_here = static_cast<std::uint32_t>(crew_processes_here()),
                            .least_slabs = least_slabs,
                            .most_slab_bytes = static_cast<std::uint64_t>(asked_.memory * 1e9),
                            .keeps_best = method_.request(asked_.parameters).keep_best,
                            .shares_start = SlabStart::is_shared(start_choice())};
        const DeviceInfo& device = place_->device().info();
        const SamplerSpec& start = *start_choice().spec;
        if (start.device_memory)
            check_fits("--start: \"" + start.name + "\"",
                       start.device_memory(start_choice().parameters, start_request(), device), device);
        plan_ = plan_slabs(*method_.in_slabs(asked_.parameters, asked_.dimension, request_.points), task, device);
    }

    /// Machines may have other devices, and other numbers of processes that share one: all processes have as many slabs
    /// as the one that needs the most. False where one of them failed.
    bool agree_on_slabs()
    {
        std::vector<std::uint64_t> needed(static_cast<std::size_t>(crew_.size()));
        needed[static_cast<std::size_t>(crew_.rank())] = plan_.slabs;
        const auto most = static_cast<std::uint32_t>(std::ranges::max(crew_.sum(needed)));
        return crew_.together([&] {
            if (most != plan_.slabs) plan(most);
            if (place_->on_step) place_->on_step(plan_text());
        });
    }

    std::string plan_text() const
    {
        const int processes = crew_.size();
        return fmt::format("{}: {} slab{}, at most {} in each of {} process{}", method_.spec.name, slabs(),
                           slabs() == 1 ? "" : "s", bytes_text(plan_.process_bytes), processes,
                           processes == 1 ? "" : "es");
    }

    std::string comment() const
    {
        return options_.command_comment(fmt::format("iterate {}, relative radius {:.6g}, coordinates in [0, 1)",
                                                    made_.iteration, made_.relative_radius));
    }

    /// The plain program makes the set as a whole, in the process that leads.
    bool make_plainly()
    {
        return crew_.together([&] {
            if (!crew_.leads()) return;
            const auto sampler = method_.spec.create(asked_.parameters, request_, place_->engine, place_->device);
            const PointSet set = sampler->sample(0);
            const auto iterations = sampler->traits().iterations;
            const auto best = std::ranges::max_element(iterations, {}, &IterationRecord::relative_radius);
            const auto kept = method_.request(asked_.parameters).keep_best ? best : iterations.end() - 1;
            const std::size_t of_coarser_levels =
                (levels().size() - 1) * (method_.request(asked_.parameters).iterations + 1);
            made_ = {set.size(), static_cast<std::size_t>(kept - iterations.begin()) - of_coarser_levels,
                     kept->relative_radius};
            write_points(options_.out, set, comment());
        });
    }

    /// Null where a process failed.
    std::unique_ptr<SlabRelaxation> level(std::uint64_t points)
    {
        std::unique_ptr<SlabRelaxation> relaxation;
        const bool is_made = crew_.together([&] {
            relaxation = std::make_unique<SlabRelaxation>(place_->device(), asked_.dimension, points,
                                                          method_.in_slabs(asked_.parameters, asked_.dimension, points),
                                                          plan_.slabs, crew_);
        });
        return is_made ? std::move(relaxation) : nullptr;
    }

    bool iterate(SlabRelaxation& relaxation, std::uint64_t points)
    {
        const LloydRequest request = method_.request(asked_.parameters);
        return relaxation.run(request, [&](std::size_t iteration, double radius) {
            if (place_->on_step)
                place_->on_step(fmt::format("{} of {} points: iteration {} of {}, relative radius {:.4f}",
                                            method_.spec.name, points, iteration, request.iterations, radius));
        });
    }

    bool make_in_slabs()
    {
        SlabStart start(start_choice(), start_request(), *place_, crew_);
        if (!start.make()) return false;
        std::uint64_t points = start.points();
        auto relaxation = level(points);
        if (!relaxation || !start.put_into(relaxation->points()) || !iterate(*relaxation, points)) return false;
        const auto counts = levels();
        for (std::size_t number = 1; number < counts.size(); ++number) {
            const std::uint64_t coarse_points = points;
            points = std::min<std::uint64_t>(counts[number], coarse_points << asked_.dimension);
            auto finer = level(points);
            if (!finer ||
                !put_parts(relaxation->points(), coarse_points, finer->points(), points, asked_.dimension, crew_))
                return false;
            relaxation = std::move(finer);
            if (!iterate(*relaxation, points)) return false;
        }
        made_ = {points, relaxation->kept(), relaxation->relative_radius()};
        head_.points = points;
        head_.comment = comment();
        return write_scattered_points(options_.out, head_, relaxation->points(), crew_);
    }

    const KindOptions& options_;
    const RelaxedMethod& method_;
    Crew& crew_;
    AskedRelaxation asked_;
    SampleRequest request_;
    std::optional<DistributionPlace> place_;
    PointFileHead head_;
    SlabPlan plan_;
    MadeSet made_;
};

}

void say_what_interruption_keeps(const Crew& crew)
{
    if (!crew.leads()) return say_nothing_when_interrupted();
    say_when_interrupted("nothing of the set is kept: the same command makes it from the beginning");
}

void relaxation_keys(Keys& keys, AskedRelaxation& asked, const RelaxedMethod& method)
{
    keys.integer("points", asked.points, 1, most_relaxed_points, "how many points").otherwise("those of the start");
    keys.integer("dimension", asked.dimension, 2, 3, "of the torus");
    asked.parameters = Parameters(method.spec.parameters);
    for (const ParameterSpec& spec : method.spec.parameters) {
        if (std::ranges::find(method.left_out, spec.key) != method.left_out.end()) continue;
        Keys::Said said = keys.parameter(spec, asked.parameters);
        if (!spec.otherwise && spec.unless_given.empty()) said.required();
    }
    keys.number("memory", asked.memory, {0.001, 1e6}, "what a slab may take at most on the device").unit("GB");
    if (!keys.is_read()) return;
    const bool has_own_points = asked.parameters.sampler("start").spec->has_own_points;
    if (has_own_points && asked.points)
        throw keys.invalid("points",
                           "cannot be combined with a start whose sets have their own number of points; leave it out");
    if (!has_own_points && !asked.points) throw keys.problem("needs " + keys.name_of("points"));
    keys.check([&] { check_methods(asked, method); });
}

Command relaxation_command(const Kind& kind, std::string notes, void (*work)(const KindOptions&))
{
    const auto o = std::make_shared<KindOptions>(kind);
    return kind_command(o, {{"--out", &o->out, "The point file", "FILE", required}}, std::move(notes), work);
}

void write_relaxed_points(const KindOptions& options, const RelaxedMethod& method)
{
    const auto crew = make_crew();
    const ThreadLimit limit(threads_of_process(0, *crew));
    say_what_interruption_keeps(*crew);
    RelaxationWork work(options, method, *crew);
    if (work.prepare()) work.work();
}

}
