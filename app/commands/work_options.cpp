#include "app/commands/work_options.hpp"

#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"
#include "base/programs/shell_words.hpp"
#include "experiment/run/progress.hpp"
#include "host/device/device.hpp"
#include "host/settings/nearest_key.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

namespace poissonlab {

InputError unknown_word(const std::string& command, const std::string& option, const std::string& word,
                        const std::vector<std::string>& known)
{
    return InputError(fmt::format("{}: {} {}: must be one of \"{}\"{}", command, option, shortened(printable(word)),
                                  fmt::join(known, "\", \""), did_you_mean(word, known)));
}

Option seed_option(std::uint64_t& seed) { return {"--seed", &seed, "The seed of random numbers; default: 1", "S"}; }
Option seed_option(std::uint32_t& seed) { return {"--seed", &seed, "The seed of random numbers; default: 1", "S"}; }
Option quiet_option(bool& is_quiet) { return {"--quiet", &is_quiet, "Print nothing but errors"}; }
Option json_option(bool& as_json, const std::string& help) { return {"--json", &as_json, help}; }

std::vector<Option> WorkOptions::options() { return joined({{seed_option(seed_)}, options_without_seed()}); }

std::vector<Option> WorkOptions::options_without_seed()
{
    return {{.name = "--engine",
             .target = &engine_,
             .help = "opencl (the default) or reference",
             .value_name = "NAME",
             .words = engines.all()},
            {"--device", &device_, "The OpenCL device: part of its name, or its number", "NAME"},
            quiet_option(quiet_)};
}

Engine WorkOptions::engine(const std::string& command) const
{
    return value_of_word(command, "--engine", engine_, engines);
}

DistributionPlace WorkOptions::place(const std::string& command, bool is_silent) const
{
    const auto device = std::make_shared<std::optional<Device>>();
    const auto progress = std::make_shared<Progress>(Progress::detect(quiet_ || is_silent));
    return {engine(command),
            [device, name = device_]() -> Device& {
                if (!*device) *device = Device::open(name);
                return **device;
            },
            [progress](const std::string& what) {
                stop_if_interrupted();
                progress->step(what);
            }};
}

std::string file_word(const std::string& file) { return (file.starts_with('-') ? "./" : "") + file; }

std::string command_comment(const std::string& command, const std::vector<std::string>& words, std::uint64_t seed,
                            const std::string& what)
{
    constexpr std::size_t longest = 800; // programs that read PLY take no lines of more than 1,023 characters
    std::string text = "poissonlab " + command;
    for (const std::string& word : words) text += " " + shell_word(word);
    if (text.size() > longest || printable(text) != text)
        return fmt::format("poissonlab {} with words that a comment cannot hold, --seed {}: {}", command, seed, what);
    return fmt::format("{} --seed {} --out FILE # {}", text, seed, what);
}

std::vector<Option> joined(std::vector<std::vector<Option>> lists)
{
    std::vector<Option> all;
    for (auto& list : lists) std::ranges::move(list, std::back_inserter(all));
    return all;
}

}
