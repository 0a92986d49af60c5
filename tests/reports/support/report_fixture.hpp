// A report over synthetic results that a test has changed.
#pragma once

#include "base/files/whole_file.hpp"
#include "reports/site/report.hpp"
#include "tests/reports/support/page_text.hpp"
#include "tests/reports/support/synthetic_results.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace poissonlab::test {

class ReportFixture : public testing::Test
{
protected:
    std::filesystem::path path() const { return folder_.path(); }

    /// All pages, the overview first, once results.json holds what json_ says. They must be sound.
    std::string page()
    {
        write_results_json(path(), json_);
        write_report({path()}, path(), {}, print_);
        EXPECT_EQ(site_errors(path()), "");
        auto pages = pages_below(path());
        auto text = pages.extract("index.html").mapped();
        for (const auto& [name, content] : pages) text += content;
        return text;
    }

    std::string svg(const std::string& name) const { return read_whole_file(path() / name); }

    /// The report's complaint about results of which `damage` has changed that member of the first series.
    template <class Damage>
    std::string error_after(const std::string& member, const Damage& damage)
    {
        const auto good = json_;
        damage(json_["series"][0][member]);
        const std::string message = message_of([&] { page(); });
        json_ = good;
        return message;
    }

    TemporaryFolder folder_;
    PrintPictures print_ = PrintPictures::none; ///< tests that look at print pictures of curves let them be drawn
    nlohmann::json json_ = write_synthetic_results(folder_.path());
};

}
