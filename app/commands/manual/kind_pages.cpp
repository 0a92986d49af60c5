// Pages of kinds of work beside methods: picture, example, keys, and the doors to each.
#include "app/commands/manual/manual.hpp"
#include "host/kinds/kind_help.hpp"
#include "host/kinds/kinds.hpp"

#include <fmt/format.h>

#include <array>
#include <sstream>

namespace poissonlab {
namespace {

/// The words for tables of configs, in the order of the page that lists them.
constexpr std::array<std::array<const char*, 3>, 7> tables{{
    {"distribution", "Points and objects that follow densities", "poissonlab.distribute"},
    {"texture", "Texture tiles", "poissonlab.texture"},
    {"tiling", "Tilings", "poissonlab.tilings"},
    {"tile_set", "Tile sets", "poissonlab.tilings"},
    {"packing", "Packings", "poissonlab.tilings"},
    {"construction", "How tiles and sets are made", "poissonlab.tilings"},
    {"scheme", "Schemes, aperiodic and isohedral tilings", "poissonlab.tilings"},
}};

std::string page_name(const Kind& kind) { return kind.word.empty() ? kind.table : kind.table + "-" + kind.word; }

/// The table of docs/kinds/examples.toml of a kind.
std::string example_of(const Kind& kind)
{
    const std::string head = "[[" + kind.table + "]]\n",
                      start = kind.word.empty() ? head : head + fmt::format("kind = \"{}\"\n", kind.word);
    const std::string examples(example_file("examples.toml"));
    const std::size_t from = examples.find(start);
    if (from == examples.npos) return "";
    return examples.substr(from, examples.find("\n\n", from) - from);
}

/// The picture of a kind, as pictures.txt lists it beside what it is made from; empty where it has none.
std::string picture_of(const Kind& kind)
{
    std::istringstream lines{std::string(example_file("pictures.txt"))};
    for (std::string page, folder, file; lines >> page >> folder >> file;)
        if (page == page_name(kind)) return page + file.substr(file.rfind('.'));
    return "";
}

std::string figure_of(const Kind& kind)
{
    const std::string file = picture_of(kind);
    if (file.empty()) return "";
    return fmt::format("\n<div class=\"pictures\" markdown=\"0\">\n<figure><img src=\"pictures/{}\" alt=\"{}\" />"
                       "<figcaption>Made by the example below.</figcaption></figure>\n</div>\n",
                       file, kind.title);
}

std::string indented(const std::string& text)
{
    std::istringstream lines(text);
    std::string result;
    for (std::string line; std::getline(lines, line);) result += "    " + line + "\n";
    return result;
}

std::string kind_page(const Kind& kind, const std::string& python)
{
    std::string text = fmt::format("# {}\n\n{}.\n{}\nIn a [config](../experiments.md):\n\n{}", kind.title, kind.summary,
                                   figure_of(kind), indented(example_of(kind)));
    if (!kind.command.empty())
        text += fmt::format("\nOn the [command line](../commands.md): `poissonlab {}`, whose options are these keys "
                            "with `_` as `-`.\n",
                            kind.command);
    return text + fmt::format("\nIn [Python](../python.md): a function of `{}`, whose keyword arguments are these "
                              "keys.\n\n## Keys\n\nEvery table may have a `label`, which is what the report calls the "
                              "result.\n\n{}",
                              python, keys_markdown(kind));
}

std::string kind_list()
{
    std::string text =
        "# Other kinds of work\n\nPoint sets are made by [methods](methods.md). Everything else that a config, "
        "a command or Python can ask for is a kind of work, with a page, a picture and an example; "
        "[keys of configs](kinds.md) has all keys on one page.\n";
    for (const auto& [table, title, python] : tables) {
        text += fmt::format("\n## {}: `[[{}]]`\n\n| kind | |\n| --- | --- |\n", title, table);
        for (const Kind& kind : all_kinds())
            if (kind.table == table)
                text += fmt::format("| [{}](kinds/{}.md) | {}. |\n", kind.title, page_name(kind), kind.summary);
    }
    return text;
}

}

ManualPages kind_pages()
{
    ManualPages pages{{"beside-methods.md", kind_list()}};
    for (const auto& [table, title, python] : tables)
        for (const Kind& kind : all_kinds())
            if (kind.table == table) pages[fmt::format("kinds/{}.md", page_name(kind))] = kind_page(kind, python);
    return pages;
}

}
