// poissonlab kinds: what tables of configs can say, from the kinds' own descriptions.
#include "app/commands/core/stored_text.hpp"
#include "app/commands/work_options.hpp"

#include <fmt/format.h>

namespace poissonlab {
namespace {

constexpr auto kinds_notes =
    R"(Each kind is a table of a config, such as [[tiling]]; most are commands as well, whose options are the keys.
  poissonlab kinds
  poissonlab kinds --json)";

}

Command kinds_command()
{
    const auto markdown = std::make_shared<bool>(false), as_json = std::make_shared<bool>(false);
    return {"kinds",
            "List the kinds of work that tables of configs ask for, and their keys",
            {{"--markdown", markdown.get(), "Print docs/kinds.md"}, json_option(*as_json)},
            kinds_notes,
            [markdown, as_json] {
                fmt::print("{}", *as_json ? all_kinds_json() : *markdown ? all_kinds_markdown() : all_kinds_text());
                return 0;
            }};
}

}
