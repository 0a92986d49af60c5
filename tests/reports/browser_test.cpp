// The report in a real browser: it opens from disk, quietly, and shows something. Needs Chromium.
#include "reports/report.hpp"

#include "io/whole_file.hpp"
#include "picture.hpp"
#include "support/temporary_folder.hpp"
#include "synthetic_results.hpp"

#include <gmock/gmock.h>

#include <cstdlib>

namespace poissonlab {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Runs headless Chromium on a page with a profile of its own; returns what it wrote to its log.
std::string browse(const std::filesystem::path& page, const std::string& options,
                   const TemporaryFolder& scratch)
{
    const auto log = scratch.path() / "log";
    const auto command =
        "timeout 120 chromium --headless --no-sandbox --disable-gpu --disable-quic --no-first-run "
        "--disable-background-networking --disable-component-update --disable-sync "
        "--hide-scrollbars --enable-logging=stderr --v=0 --user-data-dir='" +
        (scratch.path() / "profile").string() + "' " + options + " 'file://" + page.string() + "' 2> '" +
        log.string() + "'";
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    return read_whole_file(log);
}

TEST(Browser, OpensTheReportFromDisk)
{
    const TemporaryFolder folder;
    const TemporaryFolder scratch;
    test::write_synthetic_results(folder.path());
    write_report({folder.path()}, folder.path());

    const auto shot = scratch.path() / "shot.png";
    const auto log = browse(folder.path() / "index.html",
                            "--window-size=1280,2400 --screenshot='" + shot.string() + "'", scratch);
    EXPECT_THAT(log, Not(HasSubstr("CONSOLE")));
    const auto picture = test::decode_png(read_whole_file(shot));
    EXPECT_EQ(picture.width, 1280);
    EXPECT_GT(picture.variance(), 100);
}

}
}
