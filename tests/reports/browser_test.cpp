// The report in a real browser: it opens from disk, quietly, and shows something. Needs Chromium.
#include "reports/report.hpp"

#include "support/browser.hpp"
#include "synthetic_results.hpp"

#include <gmock/gmock.h>

namespace poissonlab {
namespace {

TEST(Browser, OpensTheReportFromDisk)
{
    const TemporaryFolder folder;
    test::write_synthetic_results(folder.path());
    write_report({folder.path()}, folder.path());

    const auto visit = test::visit(folder.path() / "index.html", 2400);
    EXPECT_THAT(visit.log, testing::Not(testing::HasSubstr("CONSOLE")));
    EXPECT_EQ(visit.picture.width, 1280);
    EXPECT_GT(visit.picture.variance(), 100);
}

}
}
