// poissonlab run: the experiment of a config, or those of a collection, on as many processes as there are, and the
// report.
#include "app/commands/command.hpp"
#include "app/commands/core/finish_report.hpp"
#include "base/crew/thread_limit.hpp"
#include "base/files/file_lock.hpp"
#include "base/files/whole_file.hpp"
#include "base/programs/cache_folder.hpp"
#include "base/programs/interrupt.hpp"
#include "experiment/run/run_plan.hpp"
#include "experiment/run/runner.hpp"
#include "experiment/series/region_points.hpp"
#include "experiment/store/unit_store.hpp"
#include "results/collection_file.hpp"
#include "results/own_files.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <cstdlib>
#include <optional>
#include <utility>

namespace fs = std::filesystem;

namespace poissonlab {
namespace {

constexpr auto run_notes =
    R"(CONFIG is a TOML file; configs/quick.toml explains every key. `poissonlab samplers` lists the methods.
--set changes the config without editing it; keys have dots, methods count from 0:
  --set seed=2   --set analysis.points=4096   --set engine=reference
  --set method.0.label=White   --set "method.relative_radius=[0.6, 0.7]" (every method that has it)
  --set method.0.start.relative_radius=0.7 (in a table of the method)
Results are written to DIR when everything is done; see docs/output-folder.md. Until then a previous result in DIR stays
as it is, and so it does when nothing can be made. A series that fails is named, in the report as well, which has all
others; the exit status is then that of its failure. The last line of output is the path of the report.

Finished work is kept in DIR/.units: a run that was interrupted goes on where it was, and one with other settings makes
only what these change. Several processes share the work:
  mpirun -n 8 poissonlab run CONFIG --out DIR         on machines that share DIR
  poissonlab run CONFIG --out DIR --shard 1/3         and 2/3, 3/3, each anywhere; if DIR is shared, the last one writes
                                                      the results; if not, `poissonlab merge`, then run without
                                                      --shard)";

/// Throws InputError before any work is done if the results could not be written at the end.
void check_writable(const fs::path& out)
{
    std::error_code error;
    fs::path folder = fs::absolute(out, error).lexically_normal();
    while (!fs::exists(folder, error) && folder.has_relative_path()) folder = folder.parent_path();
    if (::access(folder.c_str(), W_OK | X_OK) != 0)
        throw StorageError(
            fmt::format("--out {}: cannot be written: {}", out.string(), std::generic_category().message(errno)));
}

/// Makes a file, and removes it in the end.
class Token
{
public:
    explicit Token(fs::path file) : file_(std::move(file))
    {
        std::error_code error;
        fs::create_directories(file_.parent_path(), error); // the lock says what is wrong
        const FileLock made(file_);
    }
    ~Token()
    {
        std::error_code error;
        fs::remove(file_, error);
    }
    Token(const Token&) = delete;
    Token& operator=(const Token&) = delete;

private:
    fs::path file_;
};

/// True if all processes keep their work in the same folder. If they do not, throws InputError in the one that leads.
bool share_a_folder(Crew& crew, const fs::path& units)
{
    if (crew.size() == 1) return true;
    const fs::path file = units / crew.from_leader(fmt::format("crew-{}", ::getpid()));
    std::optional<Token> token;
    const bool is_made = crew.together([&] {
        if (crew.leads()) token.emplace(file);
    });
    return is_made && crew.together([&] {
        if (!fs::exists(file))
            throw InputError(fmt::format("there is no {}: all machines need the same folder --out, on a file system "
                                         "that they share",
                                         file.string()));
    });
}

/// If nothing can be kept between runs (no HOME, or a read-only one), tile sets are kept with the other work of the
/// run.
void keep_tile_sets_near(const fs::path& units)
{
    const fs::path cache = cache_folder();
    std::error_code error;
    if (!cache.empty()) fs::create_directories(cache, error);
    if (cache.empty() || error || ::access(cache.c_str(), W_OK | X_OK) != 0)
        ::setenv("POISSONLAB_CACHE", (units / "tile-sets").c_str(), 1);
}

/// mpirun gives processes a terminal of their own, wherever their output goes in the end.
Progress::Style style_of(const RunOptions& options, const Crew& crew)
{
    if (!crew.leads()) return Progress::Style::quiet;
    const Progress::Style style = Progress::detect(options.quiet, options.json);
    return crew.size() > 1 && style == Progress::Style::terminal ? Progress::Style::plain : style;
}

std::string advice(const RunOptions& options, const fs::path& units)
{
    return fmt::format("finished work is kept in {}: the same command goes on from there ({})", units.string(),
                       options.command);
}

/// Says what the folder of a collection holds so far. An earlier report would show what is no longer there.
void note_run(const RunPlan& plan, CollectionFile& done, const PlannedRun& run)
{
    done.runs.push_back(run.out.filename().string());
    std::error_code error;
    fs::remove(plan.out / own_pages.front(), error);
    write_collection_file(plan.out, done);
}

void write_final_report(const RunPlan& plan, const CollectionFile& done, Progress& progress)
{
    const FileLock lock(plan.out / unit_folder_name / publish_lock_name); // nobody else writes there
    remove_stale_temporary_files(plan.out, std::chrono::seconds(0), unit_folder_name);
    if (plan.is_collection) write_collection_file(plan.out, done); // a second run may have listed less meanwhile
    finish_report({plan.out}, plan.out, progress);
}

void run(const RunOptions& options)
{
    const auto shard = parse_shard("run", options.shard);
    const auto crew = make_crew();
    const ThreadLimit limit(threads_of_process(options.threads, *crew));
    RunPlan plan;
    const bool is_planned = crew->together([&] {
        plan = plan_run(options, ThreadLimit::current());
        check_writable(plan.out);
    });
    if (!is_planned) return;

    RunSettings settings;
    settings.units = plan.out / unit_folder_name;
    settings.shard = shard;
    if (!share_a_folder(*crew, settings.units)) return;
    keep_tile_sets_near(settings.units);
    if (crew->leads()) {
        say_when_interrupted(advice(options, settings.units));
        remove_stale_temporary_files(settings.units, std::chrono::hours(1));
    } else {
        say_nothing_when_interrupted();
    }

    Progress progress(style_of(options, *crew));
    for (const PlannedRun& run : plan.runs) {
        for (const std::string& word : run.experiment.left_out) progress.note(word);
        for (const std::string& note : run.experiment.notes) progress.note(note);
        for (const std::string& note : region_notes(run.experiment)) progress.note(note);
    }
    CollectionFile done{plan.title, options.command, {}};
    settings.announces_runs = plan.is_collection;
    if (plan.is_collection) settings.on_published = [&](const PlannedRun& run) { note_run(plan, done, run); };
    const RunsOutcome outcome = run_experiments(plan.runs, settings, *crew, progress);
    if (!crew->leads()) return;
    if (!outcome.is_complete)
        return progress.message(fmt::format("shard {} is done, and kept in {}; others are not. When all are, the same "
                                            "command without --shard writes the results (`poissonlab merge` first, "
                                            "where shards have folders of their own)",
                                            options.shard, settings.units.string()));
    if (outcome.is_published) write_final_report(plan, done, progress);
    outcome.raise_failures();
}

}

Command run_command(const std::string& typed)
{
    const auto o = std::make_shared<RunOptions>();
    o->command = typed;
    return {
        "run",
        "Run the experiment of a config and write its report",
        {{"CONFIG", &o->config, "The experiment (.toml)"},
         {"--out", &o->out, "The output folder; default: out/ and the config's name", "DIR"},
         {"--device", &o->device, "The OpenCL device: part of its name, or its number in `poissonlab devices`", "NAME"},
         {"--set", &o->overrides, "Change a key of the config; may be repeated", "KEY=VALUE"},
         {"--threads", &o->threads, "Use so many threads, and compute units of a CPU device; default: all", "N"},
         {"--shard", &o->shard, "Only share i of n of the work, see below", "i/n"},
         {"--quiet", &o->quiet, "Print nothing but errors and the report's path"},
         {.name = "--json",
          .target = &o->json,
          .help = "Print progress as JSON objects, one a line",
          .excludes = "--quiet"}},
        run_notes,
        action_on(o, run)};
}

}
