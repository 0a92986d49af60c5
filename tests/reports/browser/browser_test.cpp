// The driver of the browser, on pages whose behaviour is known. Needs Chromium.
#include "tests/support/browser.hpp"

#include "tests/support/errors.hpp"
#include "tests/support/picture.hpp"

#include <gmock/gmock.h>

#include <signal.h>
#include <sys/wait.h>

#include <cerrno>

namespace poissonlab::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// One browser for all tests of this file, as starting one takes most of the time.
class BrowserDriver : public testing::Test
{
protected:
    static void SetUpTestSuite() { browser_ = std::make_unique<Browser>(); }
    static void TearDownTestSuite() { browser_.reset(); }

    Browser& opened(const std::string& body)
    {
        browser_->open(folder_.write("a page, 100 %.html", "<!doctype html><meta charset='utf-8'>" + body));
        return *browser_;
    }

    TemporaryFolder folder_;
    static inline std::unique_ptr<Browser> browser_;
};

TEST_F(BrowserDriver, SaysNothingOfAQuietPage)
{
    Browser& browser = opened("<p>quiet</p><img src='data:image/gif;base64,R0lGODlhAQABAAAAACw='>");
    EXPECT_EQ(browser.evaluate("document.querySelector('p').textContent"), "quiet");
    EXPECT_THAT(browser.messages(), IsEmpty());
    EXPECT_THAT(browser.requests(), IsEmpty());
}

TEST_F(BrowserDriver, EvaluatesValuesOfEveryKind)
{
    Browser& browser = opened("");
    EXPECT_EQ(browser.evaluate("[1.5, 'zwölf', {a: null}]"), (nlohmann::json{1.5, "zwölf", {{"a", nullptr}}}));
    EXPECT_EQ(browser.evaluate("new Promise(done => setTimeout(() => done(7), 20))"), 7);
    EXPECT_EQ(browser.evaluate("undefined"), nullptr);
    // Longer than what comes through the pipe at once.
    EXPECT_EQ(browser.evaluate("'x'.repeat(1000000)").get<std::string>(), std::string(1'000'000, 'x'));
    EXPECT_EQ(browser.evaluate("'" + std::string(1'000'000, 'y') + "'.length"), 1'000'000);
    EXPECT_THROW(browser.evaluate("nothing.here"), BrowserError);
}

TEST_F(BrowserDriver, HearsTheConsole)
{
    Browser& browser = opened("<script>console.error('broken', 3); console.log('chat')</script>");
    EXPECT_THAT(browser.messages(), ElementsAre("console.error: broken 3", "console.log: chat"));
}

TEST_F(BrowserDriver, HearsExceptions)
{
    Browser& browser = opened("<script>\nthrow new Error('thrown at once')\n</script>");
    ASSERT_EQ(browser.messages().size(), 1u);
    EXPECT_THAT(browser.messages()[0], HasSubstr("thrown at once"));
    EXPECT_THAT(browser.messages()[0], HasSubstr(".html:2)"));
}

TEST_F(BrowserDriver, SeesRequestsAndFilesThatAreMissing)
{
    Browser& browser = opened("<img src='missing.png'><script src='http://127.0.0.1:1/script.js'></script>");
    EXPECT_THAT(browser.requests(), ElementsAre("http://127.0.0.1:1/script.js"));
    EXPECT_THAT(browser.messages(), testing::Contains(HasSubstr("missing.png")));
}

TEST_F(BrowserDriver, ForgetsThePageBefore)
{
    opened("<script>console.error('x')</script><img src='http://127.0.0.1:1/a.png'>");
    Browser& browser = opened("<p>quiet</p>");
    EXPECT_THAT(browser.messages(), IsEmpty());
    EXPECT_THAT(browser.requests(), IsEmpty());
}

TEST_F(BrowserDriver, ClicksAreThoseOfAMouse)
{
    Browser& browser = opened("<div style='height: 3000px'></div><button onclick='clicks.push([event.isTrusted, "
                              "event.offsetX])' style='width: 100px'>a</button><script>clicks = []</script>");
    browser.click("button");
    browser.click("button", 0.25);
    const auto clicks = browser.evaluate("clicks");
    ASSERT_EQ(clicks.size(), 2u);
    EXPECT_EQ(clicks[0][0], true);
    // The button has a border, which offsets leave out; places are rounded to pixels.
    EXPECT_NEAR(clicks[0][1].get<double>() - clicks[1][1].get<double>(), 25, 1);
}

TEST_F(BrowserDriver, ClicksOnlyWhatAPersonCouldClick)
{
    Browser& browser = opened("<button id='under'>a</button><div style='position: fixed; inset: 0'></div>"
                              "<button id='hidden' hidden>b</button>");
    EXPECT_THROW(browser.click("#under"), BrowserError);
    EXPECT_THROW(browser.click("#hidden"), BrowserError);
    EXPECT_THROW(browser.click("#nowhere"), BrowserError);
}

TEST_F(BrowserDriver, HoversOver)
{
    Browser& browser = opened("<p style='width: 50px'>a</p>");
    browser.point_at("p");
    EXPECT_EQ(browser.evaluate("document.querySelector('p').matches(':hover')"), true);
}

TEST_F(BrowserDriver, KeysMoveTheFocusAndActivate)
{
    Browser& browser = opened("<button onclick='pressed++'>a</button><input><script>pressed = 0; keys = [];"
                              "addEventListener('keydown', e => keys.push(e.key))</script>");
    browser.press("Tab");
    EXPECT_EQ(browser.evaluate("document.activeElement.tagName"), "BUTTON");
    browser.press("Enter");
    browser.press("Space");
    EXPECT_EQ(browser.evaluate("pressed"), 2);
    browser.press("Tab");
    browser.type("edge 2");
    EXPECT_EQ(browser.evaluate("document.querySelector('input').value"), "edge 2");
    browser.press("Tab", true);
    EXPECT_EQ(browser.evaluate("document.activeElement.tagName"), "BUTTON");
    browser.press("ArrowRight");
    EXPECT_EQ(browser.evaluate("keys.at(-1)"), "ArrowRight");
    EXPECT_THROW(browser.press("Hyper"), BrowserError);
}

TEST_F(BrowserDriver, HasTheSizeAndTheMediumThatIsAskedFor)
{
    Browser& browser = opened("<style>body { background: white } @media (prefers-color-scheme: dark) { body { "
                              "background: black } } @media print { body { background: lime } }</style>");
    const auto ground = [&] { return decode_color_png(browser.screenshot()).at(5, 5); };
    browser.resize(390, 700, true);
    browser.emulate("screen", false);
    const auto picture = decode_png(browser.screenshot());
    EXPECT_EQ(picture.width, 390);
    EXPECT_EQ(picture.height, 700);
    EXPECT_EQ(ground(), "#ffffff");
    browser.emulate("screen", true);
    EXPECT_EQ(ground(), "#000000");
    browser.emulate("print", false);
    EXPECT_EQ(ground(), "#00ff00");
    browser.emulate("screen", false);
    browser.resize(1280, 800);
}

TEST_F(BrowserDriver, SaysWhichPageIsMissing)
{
    EXPECT_THROW(browser_->open(folder_.path() / "nowhere.html"), BrowserError);
}

TEST(BrowserProcess, IsGoneAfterwards)
{
    pid_t process = 0;
    {
        Browser browser;
        process = browser.process();
        EXPECT_EQ(::kill(process, 0), 0);
    }
    EXPECT_EQ(::waitpid(process, nullptr, WNOHANG), -1);
    EXPECT_EQ(errno, ECHILD);
    EXPECT_NE(::kill(-process, 0), 0) << "processes that it started are still there";
}

TEST(BrowserProcess, PagesThatHangFailInTime)
{
    Browser browser;
    browser.set_limit(std::chrono::seconds(1));
    EXPECT_THAT(message_of<BrowserError>([&] { browser.evaluate("new Promise(() => {})"); }),
                testing::StartsWith("waited 1000 ms for the answer to Runtime.evaluate"));
}

}
}
