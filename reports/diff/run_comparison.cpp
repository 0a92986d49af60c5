#include "reports/diff/run_comparison.hpp"

#include "base/programs/side_by_side.hpp"
#include "results/collection_file.hpp"

#include <algorithm>
#include <map>

namespace poissonlab {

namespace {

std::string joined(const std::string& run, const std::string& series)
{
    return run.empty() ? series : run + "/" + series;
}

std::vector<Run> read_runs(const std::filesystem::path& folder)
{
    std::vector<Run> runs;
    for (const auto& run : output_folders(folder)) runs.push_back(read_run(run));
    return runs;
}

/// The runs by name: the folder's in a collection. One run on either side is matched whatever its folder is called.
std::map<std::string, const Run*> by_name(const std::vector<Run>& runs)
{
    std::map<std::string, const Run*> named;
    for (const auto& run : runs) named[runs.size() == 1 ? "" : run.folder.filename().string()] = &run;
    return named;
}

/// The entry of that name; nullptr where there is none.
template <class Entry>
const Entry* find_named(const std::vector<Entry>& entries, const std::string& name)
{
    const auto found = std::ranges::find(entries, name, &Entry::name);
    return found == entries.end() ? nullptr : &*found;
}

/// Adds remarks that a reader of two runs needs before their numbers.
void add_remarks(const std::string& name, const Run& before, const Run& after, std::vector<std::string>& remarks)
{
    const auto add = [&](const std::string& what, const std::string& a, const std::string& b) {
        if (a == b) return;
        const auto shown = [](const std::string& text) { return text.empty() ? "none" : text; };
        const auto remark = what + ": " + shown(a) + " → " + shown(b);
        // A remark that is true of several runs of a collection is made once.
        if (std::ranges::find(remarks, remark) == remarks.end()) remarks.push_back(remark);
    };
    add("version", before.version, after.version);
    add("device", before.machine.text("device"), after.machine.text("device"));
    add("threads", before.machine.text("threads"), after.machine.text("threads"));
    add("engine", before.engine, after.engine);
    add("seed", before.seed, after.seed);
    // The seed has been said.
    const auto overrides = [](std::vector<std::string> texts) {
        std::erase_if(texts, [](const std::string& text) { return text.starts_with("seed="); });
        return texts;
    };
    if (before.config != after.config || overrides(before.overrides) != overrides(after.overrides))
        remarks.push_back((name.empty() ? "the configs" : name + ": the configs") + " differ");
}

/// Pairs the entries of two runs, series, distributions or schemes, by their names. `entries` is the list of a run,
/// `first` and `second` are the members of a pair that hold them.
template <class Entry>
void match_entries(const std::string& name, const Run& before, const Run& after, std::vector<Entry> Run::*entries,
                   const Entry* SeriesComparison::*first, const Entry* SeriesComparison::*second,
                   RunComparison& comparison)
{
    for (const Entry& entry : before.*entries) {
        const Entry* other = find_named(after.*entries, entry.name);
        if (other == nullptr) {
            comparison.missing.push_back(joined(name, entry.name));
            continue;
        }
        SeriesComparison& pair = comparison.series.emplace_back();
        pair.run = name;
        pair.series = entry.name;
        pair.run_before = &before;
        pair.run_after = &after;
        pair.*first = &entry;
        pair.*second = other;
    }
    for (const Entry& entry : after.*entries)
        if (find_named(before.*entries, entry.name) == nullptr) comparison.added.push_back(joined(name, entry.name));
}

void match_runs(RunComparison& comparison)
{
    const auto before = by_name(comparison.before);
    const auto after = by_name(comparison.after);
    for (const auto& [name, run] : before) {
        const auto other = after.find(name);
        if (other == after.end()) {
            comparison.missing.push_back(joined(name, "(all of it)"));
            continue;
        }
        add_remarks(name, *run, *other->second, comparison.remarks);
        match_entries(name, *run, *other->second, &Run::series, &SeriesComparison::before, &SeriesComparison::after,
                      comparison);
        for (const auto entries : {&Run::distributions, &Run::schemes})
            match_entries(name, *run, *other->second, entries, &SeriesComparison::distribution_before,
                          &SeriesComparison::distribution_after, comparison);
    }
    for (const auto& [name, run] : after)
        if (!before.contains(name)) comparison.added.push_back(joined(name, "(all of it)"));
}

}

std::string SeriesComparison::name() const { return joined(run, series); }

bool SeriesComparison::changed() const
{
    return std::ranges::any_of(numbers, [](const auto& number) { return number.verdict == Verdict::changed; });
}

bool RunComparison::changed() const
{
    return !missing.empty() || !added.empty() ||
           std::ranges::any_of(series, [](const auto& entry) { return entry.changed(); });
}

std::size_t RunComparison::count(Verdict verdict) const
{
    std::size_t count = 0;
    for (const auto& entry : series)
        count += static_cast<std::size_t>(
            std::ranges::count(entry.numbers, verdict, [](const auto& number) { return number.verdict; }));
    return count;
}

RunComparison compare_results(const std::filesystem::path& before, const std::filesystem::path& after)
{
    RunComparison comparison;
    comparison.before = read_runs(before);
    comparison.after = read_runs(after);
    match_runs(comparison);
    for_each_side_by_side(comparison.series, [](SeriesComparison& pair) {
        pair.numbers = pair.before ? compare_series(pair) : compare_distributions(pair);
    });
    std::vector<NumberComparison*> numbers;
    for (auto& pair : comparison.series)
        for (auto& number : pair.numbers) numbers.push_back(&number);
    settle_verdicts(numbers);
    return comparison;
}

}
