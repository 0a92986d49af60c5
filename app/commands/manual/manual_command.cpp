// poissonlab manual: the pages of the documentation that follow from descriptions.
#include "app/commands/command.hpp"
#include "app/commands/manual/manual.hpp"
#include "base/errors/errors.hpp"

#include <fmt/format.h>

namespace poissonlab {
namespace {

struct ManualOptions
{
    std::filesystem::path out;
    bool scale = false;
};

}

Command manual_command(std::function<std::vector<Command>()> all_commands)
{
    const auto o = std::make_shared<ManualOptions>();
    return {"manual",
            "Write the pages of the documentation that follow from descriptions: methods, measures, commands",
            {{"--out", &o->out, "Where the pages and their curves go", "DIR"},
             {"--scale", &o->scale, "Print the table of docs/results.md instead"}},
            "",
            [o, all_commands = std::move(all_commands)] {
                if (o->out.empty() != o->scale) throw InputError("--out or --scale is needed, one of them");
                if (o->scale)
                    fmt::print("{}", scale_table());
                else
                    write_manual(o->out, all_commands());
                return 0;
            }};
}

}
