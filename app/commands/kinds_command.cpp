// poissonlab kinds: what tables of configs can say, from the kinds' own descriptions.
#include "app/commands/command.hpp"
#include "host/kinds/kind_help.hpp"

#include <fmt/format.h>

namespace poissonlab {

Command kinds_command()
{
    const auto markdown = std::make_shared<bool>(false);
    return {"kinds",
            "List the kinds of work that tables of configs ask for, and their keys",
            {{"--markdown", markdown.get(), "Print docs/kinds.md"}},
            "",
            [markdown] {
                fmt::print("{}", *markdown ? kinds_markdown() : kinds_text());
                return 0;
            }};
}

}
