#include "experiment/exhibits/exhibit.hpp"

#include "base/files/whole_file.hpp"
#include "experiment/config/plan.hpp"
#include "host/kinds/kinds.hpp"
#include "results/file_names.hpp"

#include <fmt/format.h>

#include <cmath>

namespace poissonlab {
namespace {

/// The kind that a table asks for.
const Kind& kind_of(const std::string& name, Keys& keys)
{
    if (const Kind* only = find_kind(name, "")) return *only;
    std::string word = kind_words(name).front();
    keys.word("kind", word, kind_words(name), "what is made");
    return *find_kind(name, word);
}

Exhibit read_exhibit(const std::string& name, const ConfigNode& node, std::uint64_t seed)
{
    const ConfigTable& table = *node.get_if<ConfigTable>();
    const std::string title = "[[" + name + "]]";
    Keys keys(table, node.location, title);
    const Kind& kind = kind_of(name, keys);
    std::vector<std::string> others{"label"};
    if (!kind.word.empty()) others.emplace_back("kind");
    Exhibit exhibit{&kind, read_kind(kind, table, node.location, title, others), {}, node.location, seed};
    exhibit.label = exhibit.settings.label;
    keys.text("label", exhibit.label, "what the report calls the result");
    exhibit.name = kind.folder         ? kind.folder(exhibit.settings)
                   : kind.word.empty() ? safe_name(name + "-" + exhibit.label)
                                       : fmt::format("{}-{}", name, kind.word);
    return exhibit;
}

/// Throws InputError for a number that results cannot hold: settings far out may lead there.
void check_numbers(const std::vector<DistributionNumber>& numbers)
{
    for (const DistributionNumber& number : numbers)
        if (!std::isfinite(number.value) || !std::isfinite(number.standard_error.value_or(0)))
            throw InputError(fmt::format("\"{}\" is {}, and must be a finite number", number.title, number.value));
}

std::string numbers_text(const std::vector<DistributionNumber>& numbers)
{
    std::string text = "key,value\n";
    for (const DistributionNumber& number : numbers) text += fmt::format("{},{}\n", number.key, number.value);
    return text;
}

}

std::string Exhibit::identity() const { return fmt::format("kind = {}, {}", kind->name(), settings.resolved); }

std::vector<Exhibit> read_exhibits(const Config& config)
{
    std::vector<Exhibit> exhibits;
    for (const auto& [name, node] : config.tables) exhibits.push_back(read_exhibit(name, node, config.seed));
    return exhibits;
}

Exhibited make_exhibit(const Exhibit& exhibit, const DistributionPlace& place, DistributionFiles& files)
{
    try {
        Exhibited made = exhibit.kind->make(exhibit.settings, exhibit.seed, place, files);
        if (auto* result = std::get_if<DistributionResult>(&made)) {
            check_numbers(result->numbers);
            write_whole_file(files.add(file_names::distribution_numbers), numbers_text(result->numbers));
            result->files.push_back(file_names::distribution_numbers);
        }
        return made;
    } catch (const InputError& error) {
        if (!error.place().file.empty()) throw;
        if (!error.key().empty()) throw error.moved_to(exhibit.where);
        throw InputError::at(exhibit.where, fmt::format("[[{}]]: {}", exhibit.kind->table, error.what()));
    }
}

void check_device_memory(const std::vector<Exhibit>& exhibits, const DeviceInfo& device)
{
    for (const Exhibit& exhibit : exhibits)
        if (exhibit.kind->device_memory)
            check_fits(to_string(exhibit.where) + ": " + exhibit.label,
                       exhibit.kind->device_memory(exhibit.settings, device), device);
}

}
