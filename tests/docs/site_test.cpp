// The site of the documentation: built in strict mode, every link followed, looked at in a browser from the disk, and
// every public name found by its search.
#include "tests/support/browser.hpp"
#include "tests/support/places.hpp"
#include "tests/support/program.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <regex>
#include <set>

namespace poissonlab {
namespace {

using testing::IsEmpty;

/// The words that a pattern's first group finds in a text.
std::set<std::string> words_in(const std::string& text, const std::string& pattern)
{
    const std::regex expression(pattern);
    std::set<std::string> words;
    for (std::sregex_iterator found(text.begin(), text.end(), expression), end; found != end; ++found)
        words.insert((*found)[1]);
    return words;
}

/// One site, built once, for all tests.
class DocumentationSite : public testing::Test
{
protected:
    static void SetUpTestSuite()
    {
        folder_ = std::make_unique<TemporaryFolder>();
        built_ = run_in_shell(
            folder_->path(),
            fmt::format("{} {} work site", quoted(source_folder() + "/docs/site/build.sh"), quoted(program_file())));
    }
    static void TearDownTestSuite() { folder_.reset(); }
    void SetUp() override { ASSERT_EQ(built_.status, 0) << built_.out << built_.error; }

    static std::filesystem::path site() { return folder_->path() / "site"; }

    inline static std::unique_ptr<TemporaryFolder> folder_;
    inline static Outcome built_;
};

TEST_F(DocumentationSite, HasNoDeadLinksAndNothingFromTheNet)
{
    const Outcome checked = run_in_shell(
        folder_->path(), "/usr/bin/python3 " + quoted(source_folder() + "/tests/docs/check_links.py") + " site");
    EXPECT_EQ(checked.status, 0) << checked.out << checked.error;
}

/// Misspellings that people often make; the pages that follow from descriptions, such as all help, are among these.
TEST_F(DocumentationSite, IsSpelledWell)
{
    const Outcome checked = run_in_shell(folder_->path(), "find work -name '*.md' -exec codespell {} +");
    EXPECT_EQ(checked.status, 0) << checked.error;
    EXPECT_EQ(checked.out, "");
}

/// A reader's first page decides whether pages are dark, and all others follow: each theme has a browser of its own.
void look_at_pages(const std::filesystem::path& site, bool dark)
{
    test::Browser browser;
    browser.emulate("screen", dark);
    for (const char* page : {"index.html", "docs/start.html", "docs/methods/gaussian-blue-noise.html",
                             "docs/measures.html", "docs/results.html", "docs/commands.html", "runtime/index.html"}) {
        browser.resize(1280, 900);
        browser.open(site / page);
        for (const int width : {1280, 400}) {
            SCOPED_TRACE(fmt::format("{}, {} pixels, {}", page, width, dark ? "dark" : "light"));
            browser.resize(width, 900, width < 800);
            EXPECT_THAT(browser.messages(), IsEmpty());
            EXPECT_THAT(browser.requests(), IsEmpty());
            EXPECT_EQ(browser.evaluate("document.body.dataset.mdColorScheme"), dark ? "slate" : "default");
            EXPECT_LE(browser.evaluate("document.documentElement.scrollWidth").get<int>(), width);
            EXPECT_EQ(browser.evaluate("[...document.images].filter(i => i.complete && !i.naturalWidth).length"), 0);
        }
    }
}

TEST_F(DocumentationSite, IsQuietWideAndNarrow) { look_at_pages(site(), false); }

TEST_F(DocumentationSite, IsQuietInTheDark) { look_at_pages(site(), true); }

TEST_F(DocumentationSite, FindsEveryPublicName)
{
    std::set<std::string> names = words_in(run_program(site(), {"samplers"}).out, "\n([a-z][a-z-]+): ");
    names.merge(words_in(run_program(site(), {"samplers"}).out, "\n    ([a-z_]+) = "));
    names.merge(words_in(run_program(site(), {"kinds"}).out, "\n    ([a-z_]+) = "));
    names.merge(words_in(run_program(site(), {"help", "man-page"}).out, "\n[.]SS ([a-z-]+)"));
    names.merge(words_in(content_of(source_folder() + "/docs/output-folder.md"), "\n[|] `([a-z_0-9]+)` [|]"));
    names.merge(words_in(content_of(source_folder() + "/python/poissonlab/__init__.py"), "\"([A-Za-z_]+)\", "));
    EXPECT_GT(names.size(), 150U);
    test::Browser browser;
    browser.set_limit(std::chrono::minutes(3));
    browser.open(site() / "index.html");
    const auto missing = browser.evaluate(fmt::format(R"((async () => {{
  const worker = new Worker(__search.worker), index = await __search.index, missing = [];
  const ask = message => new Promise(done => {{ worker.onmessage = event => done(event.data); worker.postMessage(message); }});
  await ask({{type: 0, data: {{config: index.config, docs: index.docs, options: {{suggestions: false}}}}}});
  for (const name of {}) {{
    const answer = await ask({{type: 2, data: name}});
    if (!answer.data.items.length) missing.push(name);
  }}
  return missing;
}})())",
                                                      nlohmann::json(names).dump()));
    EXPECT_EQ(missing.dump(), "[]");
}

TEST_F(DocumentationSite, AnswersWhoTypesIntoItsSearch)
{
    test::Browser browser;
    browser.resize(1280, 900);
    browser.open(site() / "docs/methods/random.html");
    browser.click(".md-search__input");
    browser.type("hyperuniform");
    const auto found = browser.evaluate(R"(new Promise(done => { const look = () => {
  const links = document.querySelectorAll('.md-search-result__link');
  if (links.length) done(links[0].href); else setTimeout(look, 50); }; look(); }))");
    EXPECT_NE(found.get<std::string>().find("/docs/"), std::string::npos);
    EXPECT_THAT(browser.messages(), IsEmpty());
}

/// Every command of a tutorial runs, in a folder of its own.
class Tutorial : public testing::TestWithParam<const char*>
{
};

TEST_P(Tutorial, Runs)
{
    const TemporaryFolder folder;
    const std::string page = source_folder() + "/docs/tutorials/" + GetParam() + ".md";
    const Outcome ran =
        run_in_shell(folder.path(), fmt::format("/usr/bin/python3 {} {} {} {} there",
                                                quoted(source_folder() + "/tests/docs/run_tutorial.py"), quoted(page),
                                                quoted(source_folder()), quoted(program_file())));
    EXPECT_EQ(ran.status, 0) << ran.out << ran.error;
}

INSTANTIATE_TEST_SUITE_P(Of, Tutorial, testing::Values("compare", "engine", "portrait", "park", "method", "cluster"),
                         [](const auto& tutorial) { return std::string(tutorial.param); });

}
}
