#include "reports/layout/followed_density.hpp"

#include "base/files/text_lines.hpp"

#include <algorithm>
#include <string>

namespace poissonlab {
namespace {

/// A density that is one number is everywhere the same.
bool is_number(const std::string& text)
{
    double value = 0;
    return parse_number(text, value);
}

}

bool follows_density(const ReportSeries& series)
{
    if (series.stored->region && series.stored->region->has_density) return true;
    return std::ranges::any_of(series.stored->parameters, [](const auto& parameter) {
        return parameter.first == "density" && !is_number(parameter.second);
    });
}

}
