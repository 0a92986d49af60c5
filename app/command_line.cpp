#include "app/command_line.hpp"

#include "app/argument_errors.hpp"
#include "app/command_tree.hpp"
#include "app/help_lines.hpp"
#include "app/man_page.hpp"
#include "base/errors/errors.hpp"
#include "base/files/text_lines.hpp"
#include "base/programs/shell_words.hpp"
#include "base/text/decimal_commas.hpp"
#include "host/device/device.hpp"
#include "host/settings/nearest_key.hpp"
#include "version.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>
#include <span>
#include <type_traits>

namespace poissonlab {
namespace {

// The opening words are printed when the program is called without a command.

const char* const opening_words =
    R"(poissonlab makes Poisson disk point sets and tiles, measures them, and writes reports.

  run configs/quick.toml                       make point sets, measure them, write a report: out/quick/index.html
  analyze points.csv --gallery                 measure your own points, beside every method of the laboratory
  report out/quick out/mine --out both         one report over several results
  diff before after                            which numbers changed beyond their error
  tiles build corner --colors 4 --points 64 --border chain --ranked --out endless.ptiles
                                               points without end, at the cost of a look-up
  tiles page endless.ptiles --out page.html    see them, paint densities, in a browser
  distribute stipple --image photo.jpg --points 40000 --out dots.svg
                                               a picture in dots
  texture build corner --colors 3 --exemplar photo.jpg --size 64 --out tiles
                                               an endless texture from a photograph
  export out/quick --out for-the-paper         plots for LaTeX, points for other programs
  samplers                                     every method of making points, and its parameters

`poissonlab help` lists all commands, `poissonlab help COMMAND` explains one.
)";

constexpr auto main_summary = "makes Poisson disk point sets on OpenCL devices, analyses them, and reports";

constexpr auto main_notes = R"(Examples:
  poissonlab run configs/quick.toml                       an experiment and its report, in out/quick
  poissonlab run configs/quick.toml --set seed=2 --out a  the same experiment with another seed, in a
  poissonlab analyze points-*.dat --label "My method" --out mine
  poissonlab report out/quick mine --out both             one report over both
  poissonlab diff before after                            which numbers changed beyond their error
  poissonlab help samplers                                every method of making point sets

Exit status: 0 everything asked for is there; 2 the config, a file or an argument is wrong;
3 OpenCL failed; 4 diff found changes; 130 interrupted; 1 anything else.)";

constexpr int most_threads = 4096;

/// The digits without zeros before them, which CLI11 would take for the mark of an octal number.
std::string without_leading_zeros(const std::string& digits)
{
    const std::size_t sign = digits.starts_with('-') ? 1 : 0;
    const std::size_t first = std::min(digits.find_first_not_of('0', sign), digits.size() - 1);
    return digits.substr(0, sign) + digits.substr(first);
}

/// Accepts what is an integer of this type within these ends, which are `allowed`, and nothing else: no overflow, no
/// sign for numbers that have none.
template <class Integer>
CLI::Validator integer(Integer least, Integer most, const std::string& allowed)
{
    return CLI::Validator(
        [=](std::string& text) -> std::string {
            Integer value{};
            const char* const end = text.data() + text.size();
            const auto [stop, error] = std::from_chars(text.data(), end, value);
            if (error == std::errc() && stop == end && value >= least && value <= most) {
                text = without_leading_zeros(text);
                return {};
            }
            return fmt::format("{}: must be {}", text, allowed);
        },
        "");
}

/// Accepts integers of the option's range; those with a sign have that of their type.
template <class Integer>
CLI::Validator integer(const Option& option)
{
    constexpr Integer least = std::numeric_limits<Integer>::min(), most = std::numeric_limits<Integer>::max();
    const std::string allowed =
        option.allowed.empty() ? fmt::format("an integer from {} to {}", least, most) : option.allowed;
    if constexpr (std::is_signed_v<Integer>) return integer(least, most, allowed);
    return integer(static_cast<Integer>(option.least), static_cast<Integer>(std::min<std::uint64_t>(option.most, most)),
                   allowed);
}

/// Accepts numbers. Not-a-number and infinities pass where the command can tell them from an option that was not
/// given: its own message names the range.
CLI::Validator number(bool only_finite)
{
    return CLI::Validator(
        [only_finite](const std::string& text) -> std::string {
            double value = 0;
            if (parse_number(text, value) && (!only_finite || std::isfinite(value))) return {};
            return fmt::format("{}: must be a number{}", text, decimal_comma_words(text));
        },
        "");
}

/// Accepts texts that are not empty, which are `allowed`: a script whose variable is empty would write where nobody
/// looks.
CLI::Validator not_empty(const std::string& allowed)
{
    return CLI::Validator(
        [allowed](const std::string& text) -> std::string { return text.empty() ? ": must be " + allowed : ""; }, "");
}

template <class Value>
CLI::Option* add_option(CLI::App& app, const Option& option, Value& value)
{
    CLI::Option* const added = app.add_option(option.name, value, option.help);
    if constexpr (std::is_same_v<Value, int>)
        added->transform(integer(1, most_threads, Integers{1, most_threads}.words()));
    if constexpr (std::is_unsigned_v<Value>) added->transform(integer<Value>(option));
    if constexpr (std::is_floating_point_v<Value>) added->check(number(std::isnan(value)));
    if constexpr (std::is_same_v<Value, std::vector<std::int64_t>>)
        added->expected(1, option.most_values)->transform(integer<std::int64_t>(option));
    if (option.name == "--out") added->check(not_empty("the name of a file or a folder"));
    if constexpr (std::is_same_v<Value, std::string>)
        if (!option.allowed.empty()) added->check(not_empty(option.allowed));
    const bool has_place = !option.name.starts_with('-');
    // An option with a text takes one word: the word after it is not one more text of a list.
    if constexpr (std::is_same_v<Value, std::vector<std::string>>) {
        added->allow_extra_args(has_place);
        if (option.most_values > 1) added->expected(1, option.most_values)->allow_extra_args(false)->delimiter(',');
        if (!option.alone.empty()) // words that come twice are refused by the command
            added->expected(0, 1)->default_str(option.alone)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    }
    if ((has_place && !option.may_be_left_out) || option.is_required) added->required();
    if (!option.value_name.empty()) added->option_text(option.value_name);
    return added;
}

CLI::Option* add_option(CLI::App& app, const Option& option, bool& value)
{
    return app.add_flag(option.name, value, option.help);
}

/// The action of a command. A device that --device names must exist, even if the work turns out to need none: a wrong
/// name is an error.
Action action_with_device(const Command& command)
{
    const auto option = std::ranges::find(command.options, "--device", &Option::name);
    if (option == command.options.end()) return command.action;
    return [action = command.action, device = std::get<std::string*>(option->target)] {
        if (!device->empty()) Device::find(*device);
        return action();
    };
}

/// Makes the command part of the parser `parent`; when arguments call for it, its action joins `called`.
void add_command(CLI::App& parent, const Command& command, std::vector<Action>& called)
{
    CLI::App& app = *parent.add_subcommand(command.name, command.summary);
    app.footer(command.commands.empty() ? command.notes // a program without the group's module does not know theirs
                                        : fmt::format("`poissonlab {} COMMAND --help` explains each.", command.name));
    for (const Option& option : command.options) {
        const auto add = [&](auto* value) { return add_option(app, option, *value); };
        CLI::Option* const added = std::visit(add, option.target);
        if (!option.excludes.empty()) added->excludes(option.excludes);
    }
    for (const Command& part : command.commands) add_command(app, part, called);
    if (!command.absent_module.empty()) return; // check_is_built() has seen that no arguments call for it
    if (command.action)
        app.callback([&called, action = action_with_device(command)] { called.push_back(action); });
    else
        app.require_subcommand(1);
}

/// The command as it would be typed: arguments in quotes where a shell needs them. Without --shard: whoever did the
/// work, results are the same.
std::string typed_command(int argc, const char* const* argv)
{
    std::string text = "poissonlab";
    for (int i = 1; i < argc; ++i) {
        const std::string_view argument = argv[i];
        if (argument == "--shard")
            ++i;
        else if (!argument.starts_with("--shard="))
            text += " " + shell_word(argv[i]);
    }
    return text;
}

/// The parser of all commands: the actions of those that arguments call for join `called`.
void add_everything(CLI::App& app, const std::vector<Command>& commands, std::vector<Action>& called)
{
    app.set_version_flag("--version", "poissonlab " POISSONLAB_VERSION_STRING "\n" POISSONLAB_BUILT_WITH,
                         "Print the version, and what was built in");
    app.footer(main_notes);
    app.formatter_fn([](const CLI::App* asked, const std::string& name, CLI::AppFormatMode mode) {
        return within_columns(CLI::Formatter().make_help(asked, name, mode));
    });
    for (const Command& command : commands) add_command(app, command, called);
    // This entry is for lists of commands and `help --help`; explanation() does the work.
    app.add_subcommand("help", "Explain a command, or the samplers")
        ->add_option_function<std::string>(
            "TOPIC", [](const std::string&) {},
            "A command; \"samplers\" lists the methods, \"man-page\" prints everything for man");
}

std::vector<std::string> names_of_commands(const CLI::App& app)
{
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(command->get_name());
    return names;
}

/// The action of a call without a command, which is a mistake in scripts.
int opening()
{
    std::fputs(opening_words, stderr);
    return exit_wrong_input;
}

/// The action of `help`, of which `topic` are the words after it: those of a command, such as "distribute stipple".
Action explanation(const CLI::App& program, const std::vector<std::string>& topic)
{
    if (topic == std::vector<std::string>{"samplers"}) return samplers_command().action;
    if (topic == std::vector<std::string>{"man-page"})
        return [] {
            fmt::print("{}", man_page(all_commands(""), main_summary, main_notes));
            return 0;
        };
    const CLI::App* app = &program;
    std::string before, parents;
    for (const std::string& word : topic) {
        const std::vector<std::string> names = names_of_commands(*app);
        if (names.empty()) throw InputError("help explains one topic at a time");
        if (std::ranges::find(names, word) == names.end())
            throw InputError(fmt::format("no help on \"{}{}\"{} (topics: {})", before, shortened(printable(word)),
                                         did_you_mean(word, names), fmt::join(names, ", ")));
        parents += (parents.empty() ? "" : " ") + app->get_name();
        app = app->get_subcommand(word);
        before += word + " ";
    }
    return [text = app->help(parents)] {
        fmt::print("{}", text);
        return 0;
    };
}

void parse(CLI::App& app, int argc, const char* const* argv)
{
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& outcome) {
        if (outcome.get_exit_code() == 0) {
            app.exit(outcome); // prints the help or the version
            return;
        }
        throw argument_error(app, outcome);
    }
}

}

std::vector<Action> actions_called_for(int argc, const char* const* argv)
{
    CLI::App app{fmt::format("poissonlab: {}.", main_summary), "poissonlab"};
    std::vector<Action> called;
    const std::vector<Command> commands = all_commands(typed_command(argc, argv));
    add_everything(app, commands, called);
    const std::vector<std::string> names = names_of_commands(app);
    if (argc < 2) {
        called.push_back(opening);
        return called;
    }
    const std::string first = argv[1];
    if (!first.starts_with("-") && std::ranges::find(names, first) == names.end())
        throw InputError(fmt::format("unknown command \"{}\"{} (commands: {})", first, did_you_mean(first, names),
                                     fmt::join(names, ", ")));
    // Topics are names of commands, which the parser would run instead of explaining.
    if (first == "help" && (argc == 2 || argv[2][0] != '-')) {
        check_is_built(commands, std::span(argv, static_cast<std::size_t>(argc)).subspan(2));
        called.push_back(explanation(app, {argv + 2, argv + argc}));
    } else {
        check_is_built(commands, std::span(argv, static_cast<std::size_t>(argc)).subspan(1));
        parse(app, argc, argv);
    }
    return called;
}

}
