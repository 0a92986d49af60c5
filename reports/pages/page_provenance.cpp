// The origin of results: program, seed, machine, command and config of a run.
#include "reports/pages/page_parts.hpp"

#include <algorithm>
#include <cctype>

namespace poissonlab {

std::string engine_words(const std::string& engine)
{
    return engine == "opencl" ? "OpenCL" : engine == "reference" ? "the sequential reference" : engine;
}

void set_provenance(PageData& data, const Run& run)
{
    PageData facts{PageData::type::list};
    const auto add = [&](const std::string& name, const std::string& value) {
        if (value.empty()) return;
        PageData fact;
        fact.set("name", name);
        fact.set("value", value);
        facts << fact;
    };
    add("Program", "poissonlab " + run.version);
    add("Seed", run.seed);
    add("Engine", engine_words(run.engine));
    for (const auto& [name, value] : run.machine.used()) {
        auto words = name;
        std::ranges::replace(words, '_', ' ');
        words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
        add(words, value);
    }
    std::string overrides;
    for (const auto& text : run.overrides) overrides += (overrides.empty() ? "" : "  ") + text;
    add("Overrides", overrides);

    data.set("run_title", run.title);
    data.set("command", optional_text(run.command));
    data.set("config", optional_text(run.config));
    data.set("facts", facts);
}

}
