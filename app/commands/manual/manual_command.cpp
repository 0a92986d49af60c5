// poissonlab manual: the pages of the documentation that follow from descriptions.
#include "app/commands/command.hpp"
#include "app/commands/manual/manual.hpp"
#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"

namespace poissonlab {
namespace {

struct ManualOptions
{
    std::filesystem::path out;
    std::vector<std::filesystem::path> pages;
};

void put_results_into(const std::filesystem::path& page)
{
    const std::string old = read_whole_file(page), anew = with_stored_results(old, page.string());
    if (anew != old) write_whole_file(page, anew);
}

}

Command manual_command(std::function<std::vector<Command>()> all_commands)
{
    const auto o = std::make_shared<ManualOptions>();
    return {
        "manual",
        "Write the pages of the documentation that follow from descriptions: methods, kinds, measures, commands",
        {{"--out", &o->out, "Where the pages and their curves go", "DIR"},
         {"--results", &o->pages, "Put the stored results into these pages, such as docs/results.md, anew", "FILE"}},
        "",
        [o, all_commands = std::move(all_commands)] {
            if (o->out.empty() && o->pages.empty()) throw InputError("--out or --results is needed");
            for (const std::filesystem::path& page : o->pages) put_results_into(page);
            if (!o->out.empty()) write_manual(o->out, all_commands());
            return 0;
        }};
}

}
