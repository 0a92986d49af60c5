#include "host/modules/laboratory.hpp"

#include "base/errors/missing_module.hpp"
#include "host/kinds/kinds.hpp"
#include "host/modules/manifest.hpp"
#include "host/settings/method_needs.hpp"
#include "host/settings/sampler_registry.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace poissonlab {
namespace {

/// The name of a kind in the manifest.
std::string manifest_name(const KindNames& kind) { return kind.table + " " + kind.word; }

SamplerSpec absent_sampler(const ManifestEntry& entry)
{
    SamplerSpec sampler;
    sampler.name = entry.name;
    sampler.title = entry.title;
    sampler.summary = entry.summary;
    sampler.absent_module = entry.module;
    return sampler;
}

Kind absent_kind(const ManifestEntry& entry)
{
    Kind kind;
    const std::size_t blank = entry.name.find(' ');
    kind.table = entry.name.substr(0, blank);
    kind.word = entry.name.substr(blank + 1);
    kind.command = entry.command;
    kind.title = entry.title;
    kind.summary = entry.summary;
    kind.absent_module = entry.module;
    return kind;
}

/// Sorts what modules have brought as the manifest lists it, and puts absent items where it names what they have not.
/// Items that it does not know come last.
template <class Item, class NameOf>
std::vector<Item> in_order(std::vector<Item> brought, ManifestWord word, NameOf name_of,
                           Item (*absent)(const ManifestEntry& entry))
{
    std::vector<Item> ordered;
    for (const ManifestEntry& entry : manifest()) {
        if (entry.word != word) continue;
        const auto found = std::ranges::find(brought, entry.name, name_of);
        if (found == brought.end()) {
            ordered.push_back(absent(entry));
        } else {
            ordered.push_back(std::move(*found));
            brought.erase(found);
        }
    }
    std::ranges::move(brought, std::back_inserter(ordered));
    return ordered;
}

/// All that modules bring.
Laboratory brought_laboratory()
{
    Laboratory brought;
    for (const Module& module : built_modules()) module.add(brought);
    for (SamplerRegistry* samplers : {&brought.samplers, &brought.region_samplers})
        for (SamplerSpec& sampler : *samplers) sampler = asking_for_needs(std::move(sampler));
    return brought;
}

Laboratory ordered_laboratory()
{
    Laboratory brought = brought_laboratory();
    Laboratory ordered;
    ordered.samplers = in_order(std::move(brought.samplers), ManifestWord::sampler, &SamplerSpec::name, absent_sampler);
    ordered.region_samplers =
        in_order(std::move(brought.region_samplers), ManifestWord::region_sampler, &SamplerSpec::name, absent_sampler);
    ordered.kinds = in_order(std::move(brought.kinds), ManifestWord::kind, manifest_name, absent_kind);
    return ordered;
}

void add_entries(std::vector<ManifestEntry>& entries, ManifestWord word, const std::string& module,
                 const SamplerRegistry& samplers)
{
    for (const SamplerSpec& sampler : samplers)
        entries.push_back({word, module, sampler.name, sampler.title, sampler.summary});
}

}

const Laboratory& laboratory()
{
    static const Laboratory all = ordered_laboratory();
    return all;
}

bool has_all_modules()
{
    const auto is_there = [](const auto& item) { return item.absent_module.empty(); };
    const Laboratory& all = laboratory();
    return std::ranges::all_of(all.samplers, is_there) && std::ranges::all_of(all.region_samplers, is_there) &&
           std::ranges::all_of(all.kinds, is_there);
}

void need_all_modules()
{
    if (!has_all_modules()) throw MissingModule("all");
}

std::vector<ManifestEntry> entries_of_laboratory()
{
    std::vector<ManifestEntry> entries;
    for (const Module& module : built_modules()) {
        Laboratory brought;
        module.add(brought);
        add_entries(entries, ManifestWord::sampler, module.name, brought.samplers);
        add_entries(entries, ManifestWord::region_sampler, module.name, brought.region_samplers);
        for (const Kind& kind : brought.kinds)
            entries.push_back(
                {ManifestWord::kind, module.name, manifest_name(kind), kind.title, kind.summary, kind.command});
    }
    sort_as_manifest(entries);
    return entries;
}

const SamplerRegistry& sampler_registry() { return laboratory().samplers; }

const SamplerRegistry& region_sampler_registry() { return laboratory().region_samplers; }

const std::vector<Kind>& all_kinds() { return laboratory().kinds; }

}
