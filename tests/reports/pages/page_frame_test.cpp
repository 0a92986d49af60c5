// Templates and their fields.
#include "reports/pages/page_frame.hpp"

#include "tests/support/errors.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

namespace poissonlab {
namespace {

/// A field that is forgotten would show that of a section around it, or nothing.
TEST(PageTemplate, NamesTheFieldThatIsMissing)
{
    PageData data;
    data.set("figure_class", false);
    EXPECT_THAT(message_of<std::logic_error>([&] { render_template("panel", data); }), testing::HasSubstr("\"link\""));
}

}
}
