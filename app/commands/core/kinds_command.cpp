// poissonlab kinds: what tables of configs can say, from the kinds' own descriptions.
#include "app/commands/core/described_values.hpp"
#include "app/commands/core/stored_text.hpp"
#include "app/commands/work_options.hpp"
#include "host/kinds/kind_help.hpp"
#include "host/kinds/kinds.hpp"
#include "host/modules/laboratory.hpp"

#include <fmt/format.h>

namespace poissonlab {
namespace {

void print_kinds_json()
{
    need_all_modules();
    nlohmann::ordered_json json{{"kinds", nlohmann::ordered_json::array()}};
    for (const Kind& kind : all_kinds()) {
        auto keys = nlohmann::ordered_json::array();
        for (const KeySpec& spec : kind.keys()) {
            nlohmann::ordered_json key = described_value(spec.value, spec.allowed());
            key["required"] = spec.is_required;
            key["option"] = option_name(spec);
            keys.push_back(std::move(key));
        }
        json["kinds"].push_back({{"table", kind.table},
                                 {"kind", kind.word},
                                 {"command", kind.command},
                                 {"title", kind.title},
                                 {"summary", kind.summary},
                                 {"keys", keys}});
    }
    fmt::print("{}\n", json.dump(2));
}

std::string all_kinds_markdown()
{
    need_all_modules();
    return kinds_markdown();
}

std::string all_kinds_text() { return has_all_modules() ? kinds_text() : std::string(stored_text("kinds.txt")); }

}

Command kinds_command()
{
    const auto markdown = std::make_shared<bool>(false), as_json = std::make_shared<bool>(false);
    return {"kinds",
            "List the kinds of work that tables of configs ask for, and their keys",
            {{"--markdown", markdown.get(), "Print docs/kinds.md"}, json_option(*as_json)},
            "",
            [markdown, as_json] {
                if (*as_json)
                    print_kinds_json();
                else
                    fmt::print("{}", *markdown ? all_kinds_markdown() : all_kinds_text());
                return 0;
            }};
}

}
