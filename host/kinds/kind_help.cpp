#include "host/kinds/kind_help.hpp"

#include "host/kinds/kinds.hpp"
#include "host/settings/sampler_help.hpp"
#include "host/settings/sampler_texts.hpp"

#include <fmt/format.h>

namespace poissonlab {
namespace {

std::string default_of_key(const KeySpec& spec)
{
    if (spec.is_required) return "needed";
    return spec.value.otherwise ? to_string(*spec.value.otherwise) : spec.value.unless_given;
}

std::string key_row(const KeySpec& spec)
{
    const std::string other = spec.alias.empty() ? "" : fmt::format(", `{}`", option_name(spec));
    return fmt::format("| `{}`{} | {} | {} | {} |\n", spec.value.key, other, braces_as_code(spec.allowed()),
                       default_of_key(spec), meaning_of(spec.value));
}

/// Says how a config asks for the kind; for a kind that only a command makes, it names the command.
std::string table_of_kind(const Kind& kind)
{
    if (kind.table.empty()) return "poissonlab " + kind.command;
    return kind.word.empty() ? "[[" + kind.table + "]]" : fmt::format("[[{}]] kind = \"{}\"", kind.table, kind.word);
}

/// Writes what table_of_kind() says as code of Markdown.
std::string table_in_markdown(const Kind& kind)
{
    if (kind.table.empty()) return "`poissonlab " + kind.command + "`";
    return kind.word.empty() ? "`[[" + kind.table + "]]`"
                             : fmt::format("`[[{}]]` `kind = \"{}\"`", kind.table, kind.word);
}

}

std::string kinds_text()
{
    std::string text = "Tables of configs, and their keys. Every table can have\n    label = a line of text in quotes\n"
                       "        what the report calls the result\n";
    for (const Kind& kind : all_kinds()) {
        text += fmt::format("\n{}: {}\n    {}\n", table_of_kind(kind), kind.title, kind.summary);
        for (const KeySpec& spec : kind.keys())
            text += fmt::format("    {} = {}\n        {}\n", spec.value.key, spec.allowed(), key_help(spec));
    }
    return text;
}

std::string keys_markdown(const Kind& kind)
{
    std::string text = "| key | | default | |\n| --- | --- | --- | --- |\n";
    for (const KeySpec& spec : kind.keys()) text += key_row(spec);
    return text;
}

std::string kinds_markdown()
{
    std::string text = "# Keys of configs\n\n"
                       "Each kind of work has its keys in a table of a config, as options of its command (`_` becomes "
                       "`-`), and as keyword\narguments in Python. This page is printed by `poissonlab kinds "
                       "--markdown`.\n";
    for (const Kind& kind : all_kinds()) {
        text += fmt::format("\n## {}: {}\n\n{}.", kind.title, table_in_markdown(kind), kind.summary);
        const bool has_command = !kind.command.empty() && !kind.table.empty();
        text += has_command ? fmt::format(" On the command line: `poissonlab {}`.\n", kind.command) : "\n";
        text += "\n" + keys_markdown(kind);
    }
    return text;
}

}
