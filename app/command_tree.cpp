#include "app/command_tree.hpp"

#include "app/commands/modules.hpp"
#include "base/errors/missing_module.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace poissonlab {
namespace {

/// The groups of commands: what `help` says of them.
constexpr std::array<std::pair<const char*, const char*>, 6> groups{
    {{"tiles", "Poisson disk tile sets"},
     {"points", "Sets of any size, written to a file"},
     {"aperiodic", "Aperiodic tile sets"},
     {"distribute", "Points and objects that follow densities, and points in regions"},
     {"isohedral", "Isohedral tilings"},
     {"texture", "Texture tile sets, and other endless textures"}}};

/// "tiles build": the name of a command in the manifest.
std::string path_of(const GroupedCommand& each)
{
    return each.group.empty() ? each.command.name : each.group + " " + each.command.name;
}

GroupedCommand absent_command(const ManifestEntry& entry)
{
    const std::size_t blank = entry.name.find(' ');
    GroupedCommand absent;
    if (blank != std::string::npos) absent.group = entry.name.substr(0, blank);
    absent.command.name = blank == std::string::npos ? entry.name : entry.name.substr(blank + 1);
    absent.command.summary = entry.summary;
    absent.command.absent_module = entry.module;
    return absent;
}

ProgramContext context_of(const std::string& typed)
{
    return {typed, [] { return all_commands(""); }};
}

std::vector<GroupedCommand> ordered_commands(const std::string& typed)
{
    std::vector<GroupedCommand> brought, ordered;
    for (const CommandModule& module : built_command_modules())
        std::ranges::move(module.commands(context_of(typed)), std::back_inserter(brought));
    for (const ManifestEntry& entry : manifest()) {
        if (entry.word != ManifestWord::command) continue;
        const auto found = std::ranges::find(brought, entry.name, path_of);
        if (found == brought.end()) {
            ordered.push_back(absent_command(entry));
        } else {
            ordered.push_back(std::move(*found));
            brought.erase(found);
        }
    }
    std::ranges::move(brought, std::back_inserter(ordered)); // what the manifest does not know yet
    return ordered;
}

/// The group in a list of commands, which it joins when it is asked for first.
Command& group_in(std::vector<Command>& commands, const std::string& name)
{
    const auto there = std::ranges::find(commands, name, &Command::name);
    if (there != commands.end()) return *there;
    const auto* const group = std::ranges::find(groups, name, [](const auto& each) { return std::string(each.first); });
    return commands.emplace_back(Command{name, group == groups.end() ? "" : group->second, {}, "", {}});
}

}

std::vector<Command> all_commands(const std::string& typed)
{
    std::vector<Command> all;
    for (GroupedCommand& each : ordered_commands(typed))
        (each.group.empty() ? all : group_in(all, each.group).commands).push_back(std::move(each.command));
    return all;
}

void check_is_built(const std::vector<Command>& commands, std::span<const char* const> words)
{
    if (words.empty()) return;
    const auto found = std::ranges::find(commands, std::string(words.front()), &Command::name);
    if (found == commands.end()) return;
    if (!found->absent_module.empty()) throw MissingModule(found->absent_module);
    check_is_built(found->commands, words.subspan(1));
}

std::vector<ManifestEntry> entries_of_commands()
{
    std::vector<ManifestEntry> entries;
    for (const CommandModule& module : built_command_modules())
        for (const GroupedCommand& each : module.commands(context_of("")))
            entries.push_back({ManifestWord::command, module.name, path_of(each), "", each.command.summary});
    sort_as_manifest(entries);
    return entries;
}

}
