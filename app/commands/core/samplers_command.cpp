// poissonlab samplers: what a [[method]] table can say, from the samplers' own descriptions.
#include "app/commands/core/stored_text.hpp"
#include "app/commands/work_options.hpp"

#include <fmt/format.h>

namespace poissonlab {
namespace {

constexpr auto samplers_notes =
    R"(Each method is a `sampler = ` of a [[method]] table; its parameters are the keys of that table. docs/methods.md says
which one to use.
  poissonlab samplers
  poissonlab samplers --json)";

}

Command samplers_command()
{
    const auto markdown = std::make_shared<bool>(false), as_json = std::make_shared<bool>(false);
    return {"samplers",
            "List the methods of making point sets and their parameters",
            {{"--markdown", markdown.get(), "Print the tables of docs/samplers.md"}, json_option(*as_json)},
            samplers_notes,
            [markdown, as_json] {
                fmt::print("{}", *as_json    ? all_samplers_json()
                                 : *markdown ? all_samplers_markdown()
                                             : all_samplers_text());
                return 0;
            }};
}

}
