// poissonlab samplers: what a [[method]] table can say, from the samplers' own descriptions.
#include "app/commands/command.hpp"
#include "host/settings/sampler_help.hpp"

#include <fmt/format.h>

namespace poissonlab {

Command samplers_command()
{
    const auto markdown = std::make_shared<bool>(false);
    return {"samplers",
            "List the methods of making point sets and their parameters",
            {{"--markdown", markdown.get(), "Print the table of docs/samplers.md"}},
            "",
            [markdown] {
                fmt::print("{}", *markdown ? samplers_markdown() : samplers_text());
                return 0;
            }};
}

}
