#include "app/argument_errors.hpp"

#include "host/settings/nearest_key.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

namespace poissonlab {
namespace {

struct CalledCommand
{
    const CLI::App* app;
    std::string name; ///< "tiles build"; empty: none
};

CalledCommand called_command(const CLI::App& program)
{
    CalledCommand called{&program, ""};
    while (!called.app->get_subcommands().empty()) {
        called.app = called.app->get_subcommands().back();
        called.name += (called.name.empty() ? "" : " ") + called.app->get_name();
    }
    return called;
}

bool begins_option(const std::string& word) { return word.starts_with("-"); }

/// The arguments have an option that the command does not know: an option that seems to be missing may be misspelt.
bool has_unknown_option(const CLI::App& program) { return std::ranges::any_of(program.remaining(true), begins_option); }

/// "; did you mean ...?": "--distance" is a word of "--min-distance", and misspells "--distances", which is less likely
/// to be meant. Of several options with the word, the first one is the command's principal one.
std::string option_meant(const std::string& argument, const std::vector<std::string>& known)
{
    const std::string typed = argument.substr(0, argument.find('=')); // "--distance=4"
    const std::string ending = typed.starts_with("--") && typed.size() > 4 ? typed.substr(1) : "";
    const auto found = std::ranges::find_if(known, [&](const std::string& option) {
        return !ending.empty() && option.ends_with(ending) && option != typed;
    });
    return found == known.end() ? did_you_mean(typed, known) : "; did you mean \"" + *found + "\"?";
}

/// The first option that there is not, or the first argument too many.
std::string words_for_extras(const CLI::App& program, const CLI::App& command)
{
    const std::vector<std::string> extras = program.remaining(true);
    const auto option = std::ranges::find_if(extras, begins_option);
    if (option == extras.end())
        return fmt::format("{}: is one argument too many", shortened(printable(extras.front())));
    std::vector<std::string> known;
    for (const CLI::Option* each : command.get_options()) known.push_back(each->get_name());
    return fmt::format("{}: there is no such option{}", shortened(printable(*option)), option_meant(*option, known));
}

std::string words_for_missing(const CLI::App& command, const std::string& name_of_missing)
{
    if (name_of_missing != "A subcommand") return "needs " + name_of_missing;
    std::vector<std::string> names;
    for (const CLI::App* each : command.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(each->get_name());
    return fmt::format("needs one of {}", fmt::join(names, ", "));
}

/// The parser's own message, where `between` parts it into two, with `instead` between these.
std::string parted(std::string message, const std::string& between, const std::string& instead)
{
    if (const auto place = message.find(between); place != std::string::npos)
        message.replace(place, between.size(), instead);
    return message;
}

std::string words_for(const CLI::App& program, const CLI::App& command, const CLI::ParseError& error)
{
    const std::string message = error.what();
    const auto is = [&](CLI::ExitCodes code) { return error.get_exit_code() == static_cast<int>(code); };
    if (is(CLI::ExitCodes::ExtrasError)) return words_for_extras(program, command);
    if (is(CLI::ExitCodes::RequiredError) && has_unknown_option(program)) return words_for_extras(program, command);
    if (is(CLI::ExitCodes::RequiredError))
        return words_for_missing(command, message.substr(0, message.find(" is required")));
    if (is(CLI::ExitCodes::ExcludesError)) return parted(message, " excludes ", ": cannot be combined with ");
    if (is(CLI::ExitCodes::ValidationError)) return parted(message, ": ", " "); // "--seed: -1: must be an integer"
    if (is(CLI::ExitCodes::ArgumentMismatch) && message.ends_with(" missing"))
        return message.substr(0, message.find(':')) + ": has too few values";
    return message;
}

}

InputError argument_error(const CLI::App& app, const CLI::ParseError& error)
{
    const auto [command, name] = called_command(app);
    std::string message = words_for(app, *command, error);
    std::ranges::replace(message, '\n', ' ');
    const std::string begin = name.empty() ? "" : name + ": ", help = name.empty() ? "" : name + " ";
    return InputError(fmt::format("{}{} (see poissonlab {}--help)", begin, printable(message), help));
}

}
