// The page of commands: what `help` says of each.
#include "app/commands/manual/manual.hpp"
#include "app/help_lines.hpp"
#include "app/man_page.hpp"

#include <fmt/format.h>

namespace poissonlab {
namespace {

std::string without_bars(std::string text)
{
    for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.replace(at, 1, "\\|");
    return text;
}

void add_command_section(std::string& text, const Command& command, const std::string& group)
{
    const std::string name = group.empty() ? command.name : group + " " + command.name;
    if (command.action) {
        text += fmt::format("\n## {}\n\n{}.\n", name, command.summary);
        if (!command.options.empty()) text += "\n| option | |\n| --- | --- |\n";
        for (const Option& option : command.options) {
            const std::string value = value_word(option);
            text += fmt::format("| `{}{}` | {} |\n", option.name, value.empty() ? "" : " " + value,
                                without_bars(option.help));
        }
        if (!command.notes.empty()) text += fmt::format("\n```text\n{}\n```\n", within_columns(command.notes));
    }
    for (const Command& part : command.commands) add_command_section(text, part, name);
}

}

std::string command_page(const std::vector<Command>& commands)
{
    std::string text = "# Every command and option\n\n`poissonlab COMMAND --help` says the same; [the command line]"
                       "(command-line.md) has them at a glance.\n";
    for (const Command& command : commands) add_command_section(text, command, "");
    return text;
}

}
