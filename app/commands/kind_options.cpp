#include "app/commands/kind_options.hpp"

#include "app/commands/point_target.hpp"
#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"
#include "host/config/toml_reader.hpp"
#include "host/device/device.hpp"
#include "host/run/progress.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>

namespace poissonlab {
namespace {

using ValueKind = ParameterSpec::Kind;

/// Keys whose words are taken as they were typed: others may be numbers or tables.
bool is_plain_text(const KeySpec& spec)
{
    return spec.value.kind == ValueKind::text || spec.value.kind == ValueKind::choice;
}

/// ".svg, .png or .csv"
std::string either(const std::vector<std::string>& words)
{
    if (words.size() < 2) return words.empty() ? "" : words.front();
    const std::vector<std::string> first(words.begin(), words.end() - 1);
    return fmt::format("{} or {}", fmt::join(first, ", "), words.back());
}

std::string in_capitals(std::string text)
{
    std::ranges::transform(text, text.begin(), [](unsigned char letter) { return std::toupper(letter); });
    return text;
}

std::string value_name_of(const KeySpec& spec)
{
    if (!spec.parts.empty()) {
        return in_capitals(fmt::format("{}", fmt::join(spec.parts, " ")));
    }
    if (spec.is_spread) return "NUMBER|LOW HIGH|TABLE";
    switch (spec.value.kind) {
    case ValueKind::number:
        return "NUMBER";
    case ValueKind::integer:
        return "N";
    case ValueKind::sampler:
        return "NAME|TABLE";
    default:
        return spec.is_formula ? "IMAGE|FORMULA" : spec.is_file ? "FILE" : "NAME";
    }
}

}

KindOptions::KindOptions(const Kind& kind, std::string placed) : kind_(kind), placed_(std::move(placed))
{
    for (KeySpec& spec : kind.keys()) {
        const std::string& key = spec.value.key;
        typed_.push_back({spec, key == placed_ ? in_capitals(key) : option_name(key), {}});
    }
}

std::vector<Option> KindOptions::options()
{
    std::vector<Option> all;
    for (Typed& typed : typed_) all.push_back(option_of(typed));
    const std::vector<Option> shared{
        {"--seed", &seed_, "Which of all results; default: 1", "S"},
        {"--engine", &engine_, "opencl (the default) or reference", "NAME"},
        {"--device", &device_, "The OpenCL device: part of its name, or its number", "NAME"},
        {"--quiet", &quiet_, "Do not show steps"}};
    return joined({all, shared});
}

Option KindOptions::option_of(Typed& typed) const
{
    const KeySpec& spec = typed.spec;
    const std::string help = key_help(spec);
    if (spec.value.kind == ValueKind::boolean) return {typed.name, &typed.is_set, help};
    Option option{typed.name, &typed.words, help, value_name_of(spec)}; // what is needed is said by whoever reads it
    option.most_values = static_cast<int>(spec.is_spread ? 2 : spec.count);
    if (!spec.excludes.empty()) option.excludes = option_name(spec.excludes);
    return option;
}

ConfigNode KindOptions::node_of(const Typed& typed) const
{
    const SourceLocation where{fmt::format("{}: {}", kind_.command, typed.name), 0, true};
    if (typed.is_set) return {true, where, "true"};
    const auto node = [&](const std::string& word) {
        ConfigNode parsed = is_plain_text(typed.spec) ? ConfigNode{word, where, word} : read_toml_value(word, where);
        parsed.text = shortened(printable(word)); // without the quotes that a file would have
        return parsed;
    };
    if (typed.spec.parts.empty() && typed.words.size() == 1) return node(typed.words.front());
    const std::string all = shortened(printable(fmt::format("{}", fmt::join(typed.words, " "))));
    ConfigNode list{ConfigList{}, where, all};
    for (const std::string& word : typed.words) list.get_if<ConfigList>()->push_back(node(word));
    if (!typed.spec.is_spread) return list;
    return {ConfigTable{{"uniform", std::move(list)}}, where, all}; // from one to the other
}

KindSettings KindOptions::settings() const
{
    if (!engines.find(engine_))
        throw InputError(fmt::format("{}: --engine {}: must be one of {}", kind_.command, printable(engine_),
                                     fmt::join(engines.all(), ", ")));
    ConfigTable table;
    for (const Typed& typed : typed_) {
        if (!typed.is_set && typed.words.empty()) continue;
        if (typed.words.size() > std::max<std::size_t>(typed.spec.count, typed.spec.is_spread ? 2 : 1))
            throw InputError(fmt::format("{}: {}: is given twice", kind_.command, typed.name));
        table.push_back({typed.spec.value.key, node_of(typed)});
    }
    return read_kind(kind_, table, {kind_.command, 0, true}, kind_.command);
}

DistributionPlace KindOptions::place(bool is_silent) const
{
    const auto device = std::make_shared<std::optional<Device>>();
    const auto progress = std::make_shared<Progress>(Progress::detect(quiet_ || is_silent));
    return {*engines.find(engine_),
            [device, name = device_]() -> Device& {
                if (!*device) *device = Device::open(name);
                return **device;
            },
            [progress](const std::string& what) {
                stop_if_interrupted();
                progress->step(what);
            }};
}

void KindOptions::say_note(const std::string& note) const
{
    if (!note.empty() && !quiet_) fmt::print(stderr, "poissonlab: note: {}\n", note);
}

Option OutputFiles::option()
{
    std::vector<std::string> ends = kinds;
    if (may_be_points) ends.push_back("a point file");
    return {"--out", &names, fmt::format("A file: {}; may be repeated", fmt::join(ends, ", ")), "FILE", required};
}

void OutputFiles::check(const std::string& command) const
{
    for (const std::filesystem::path file : names) {
        const std::string begin = fmt::format("{}: --out {}: ", command, printable(file.string()));
        const bool is_known = std::ranges::find(kinds, file.extension().string()) != kinds.end();
        if (!is_known && may_be_points)
            check_point_target(command, file, kinds.empty() ? "" : ", " + either(kinds));
        else if (!is_known)
            throw InputError(begin + fmt::format("must end in {}", either(kinds)));
        const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
        std::error_code unknown;
        if (!std::filesystem::is_directory(folder, unknown))
            throw InputError(begin + "there is no folder " + printable(folder.string()));
        if (std::filesystem::is_directory(file, unknown)) throw InputError(begin + "is a folder");
    }
}

Option pixels_option(std::uint32_t& pixels, std::uint32_t most, const std::string& otherwise)
{
    return allowing({"--pixels", &pixels, "The width of a .png; default: " + otherwise, "W"}, integers(1, most));
}

std::vector<Option> joined(std::vector<std::vector<Option>> lists)
{
    std::vector<Option> all;
    for (auto& list : lists) std::ranges::move(list, std::back_inserter(all));
    return all;
}

InputError KindOptions::of_command(const InputError& error) const
{
    const std::string message = error.what();
    return message.starts_with(kind_.command) ? error : InputError(fmt::format("{}: {}", kind_.command, message));
}

}
