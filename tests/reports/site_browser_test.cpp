// The report in a real browser: it opens from disk, quietly, and shows something. Needs Chromium.
#include "reports/report.hpp"

#include "support/browser.hpp"
#include "support/picture.hpp"
#include "synthetic_results.hpp"

#include <gmock/gmock.h>

namespace poissonlab {
namespace {

TEST(SiteInBrowser, OpensFromDisk)
{
    const TemporaryFolder folder;
    test::write_synthetic_results(folder.path());
    write_report({folder.path()}, folder.path());

    test::Browser browser;
    browser.open(folder.path() / "index.html");
    EXPECT_THAT(browser.messages(), testing::IsEmpty());
    EXPECT_THAT(browser.requests(), testing::IsEmpty());
    EXPECT_GT(test::decode_png(browser.screenshot()).variance(), 100);
}

}
}
