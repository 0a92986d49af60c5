// poissonlab manual: the pages of the documentation that follow from descriptions.
#include "app/command_tree.hpp"
#include "app/commands/manual/manual.hpp"
#include "app/completion.hpp"
#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "host/kinds/kind_help.hpp"
#include "host/modules/laboratory.hpp"
#include "host/modules/manifest.hpp"
#include "host/settings/sampler_registry.hpp"
#include "host/settings/sampler_texts.hpp"

#include <algorithm>
#include <iterator>

namespace poissonlab {
namespace {

struct ManualOptions
{
    std::filesystem::path out, stored;
    std::vector<std::filesystem::path> pages;
};

void put_results_into(const std::filesystem::path& page)
{
    const std::string old = read_whole_file(page), anew = with_stored_results(old, page.string());
    if (anew != old) write_whole_file(page, anew);
}

/// Writes what programs that lack modules know of these, where the build looks for it.
void write_stored_texts(const std::filesystem::path& checkout, const std::vector<Command>& commands)
{
    std::vector<ManifestEntry> entries = entries_of_laboratory();
    std::ranges::move(entries_of_commands(), std::back_inserter(entries));
    write_whole_file(checkout / "host/modules/manifest.tsv", manifest_text(entries));
    write_whole_file(checkout / "docs/methods.md", stored_choice_page());
    const std::filesystem::path folder = checkout / "app/stored";
    write_whole_file(folder / "samplers.txt", samplers_text(sampler_registry(), region_sampler_registry()));
    write_whole_file(folder / "kinds.txt", kinds_text());
    for (const std::string& shell : completed_shells())
        write_whole_file(folder / ("completion." + shell), completion_script(shell, commands));
}

constexpr auto manual_notes =
    R"(This is for those who change the laboratory: `./lab docs` builds the whole manual.
  poissonlab manual --stored .
  poissonlab manual --out pages)";

}

Command manual_command(std::function<std::vector<Command>()> all_commands)
{
    const auto o = std::make_shared<ManualOptions>();
    return {"manual",
            "Write the pages of the documentation that follow from descriptions: methods, kinds, measures, commands",
            {{"--out", &o->out, "Where the pages and their curves go", "DIR"},
             {"--results", &o->pages, "Put the stored results into these pages, such as docs/results.md, anew", "FILE"},
             {"--stored", &o->stored,
              "Write the words of all modules, and what programs that lack some print, in this checkout", "DIR"}},
            manual_notes,
            [o, all_commands = std::move(all_commands)] {
                if (o->out.empty() && o->pages.empty() && o->stored.empty())
                    throw InputError("--out, --results or --stored is needed");
                need_all_modules();
                for (const std::filesystem::path& page : o->pages) put_results_into(page);
                if (!o->stored.empty()) write_stored_texts(o->stored, all_commands());
                if (!o->out.empty()) write_manual(o->out, all_commands());
                return 0;
            }};
}

}
