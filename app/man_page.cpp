#include "app/man_page.hpp"

#include "app/help_lines.hpp"
#include "version.hpp"

#include <fmt/format.h>

#include <sstream>
#include <type_traits>

namespace poissonlab {
namespace {

/// Text as roff prints it: backslashes and dashes as they are, and no line that is taken for a request.
std::string roff(const std::string& text)
{
    std::string printed;
    for (const char letter : text) {
        const bool starts_line = printed.empty() || printed.back() == '\n';
        if (starts_line && (letter == '.' || letter == '\'')) printed += "\\&";
        if (letter == '\\')
            printed += "\\e";
        else if (letter == '-')
            printed += "\\-";
        else
            printed += letter;
    }
    return printed;
}

/// The option with the name of its value: an argument that is known by its place is its own name.
std::string usage(const Option& option)
{
    const std::string value = value_word(option);
    if (!option.name.starts_with('-')) return fmt::format("\\fI{}\\fR", roff(option.name));
    if (value.empty()) return fmt::format("\\fB{}\\fR", roff(option.name));
    return fmt::format("\\fB{}\\fR \\fI{}\\fR", roff(option.name), roff(value));
}

constexpr std::size_t man_columns = 72; ///< that man indents in a terminal of 80

/// Lines with their breaks and indents, as long as a page of man has room for.
std::string as_written(const std::string& text)
{
    return fmt::format(".PP\n.nf\n{}\n.fi\n", roff(within_columns(text, man_columns)));
}

void write_command(std::ostream& page, const Command& command, const std::string& group)
{
    const std::string name = group.empty() ? command.name : group + " " + command.name;
    if (command.action) {
        page << fmt::format(".SS {}\n{}.\n", roff(name), roff(command.summary));
        for (const Option& option : command.options)
            page << fmt::format(".TP\n{}\n{}\n", usage(option), roff(option.help));
        if (!command.notes.empty()) page << as_written(command.notes);
    }
    for (const Command& part : command.commands) write_command(page, part, name);
}

}

std::string man_page(const std::vector<Command>& commands, const std::string& summary, const std::string& notes)
{
    std::ostringstream page;
    page << fmt::format(".TH POISSONLAB 1 \"\" \"poissonlab {}\" \"User Commands\"\n", roff(POISSONLAB_VERSION));
    page << fmt::format(".SH NAME\npoissonlab \\- {}\n", roff(summary));
    page << ".SH SYNOPSIS\n.B poissonlab\n\\fICOMMAND\\fR [\\fIARGUMENTS\\fR]\n.SH COMMANDS\n";
    for (const Command& command : commands) write_command(page, command, "");
    page << ".SH NOTES\n" << as_written(notes);
    return page.str();
}

std::string value_word(const Option& option)
{
    if (!option.name.starts_with('-')) return "";
    if (!option.value_name.empty()) return option.value_name;
    return std::visit(
        [](const auto* value) -> std::string {
            using Value = std::remove_cvref_t<decltype(*value)>;
            if constexpr (std::is_same_v<Value, bool>) return "";
            if constexpr (std::is_arithmetic_v<Value>) return "NUMBER";
            return "TEXT";
        },
        option.target);
}

}
