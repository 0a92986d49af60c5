// The page of the papers names every config of theirs, and only configs that there are.
#include "tests/support/places.hpp"
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

#include <regex>
#include <set>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;

/// The configs that the page names, such as configs/papers/cohen-2003.toml.
std::set<std::string> named_configs()
{
    const std::string page = content_of(source_folder() + "/docs/papers.md");
    const std::regex path("configs/[a-zA-Z0-9/_.-]+\\.toml");
    std::set<std::string> names;
    for (std::sregex_iterator found(page.begin(), page.end(), path), end; found != end; ++found)
        names.insert(found->str());
    return names;
}

/// All configs below a folder of configs, named as on the page.
std::set<std::string> configs_below(const std::string& folder)
{
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(source_folder() + "/" + folder))
        if (entry.path().extension() == ".toml")
            names.insert(entry.path().lexically_relative(source_folder()).generic_string());
    return names;
}

TEST(PapersPage, NamesEveryConfigOfThePapers)
{
    const std::set<std::string> named = named_configs();
    for (const char* folder : {"configs/papers", "configs/dissertation"}) {
        const std::set<std::string> configs = configs_below(folder);
        EXPECT_FALSE(configs.empty()) << folder;
        for (const std::string& config : configs) EXPECT_TRUE(named.contains(config)) << config;
    }
}

TEST(PapersPage, NamesConfigsThatExist)
{
    for (const std::string& config : named_configs()) EXPECT_TRUE(fs::exists(source_folder() + "/" + config)) << config;
}

}
}
