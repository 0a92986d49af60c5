// kind = "bricks": pairs of bricks by the binary digits of pi, along a spiral.
//
// Kaplan, Introductory Tiling Theory for Computer Graphics, 2009 (SIGGRAPH 2008 class notes, II), figure 24.
#include "host/schemes/mark_canvas.hpp"
#include "host/schemes/polygon_painter.hpp"
#include "host/schemes/scheme_run.hpp"
#include "tiles/prototiles/digit_bricks.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {

DistributionResult make_bricks(const BrickSettings& settings, DistributionFiles& files)
{
    constexpr double margin = 0.25;
    const std::vector<bool> digits = binary_digits_of_pi(settings.digits);
    const auto squares = spiral_squares(digits.size());
    std::array<int, 2> low{}, high{};
    for (const auto& square : squares)
        for (std::size_t axis = 0; axis < 2; ++axis) {
            low[axis] = std::min(low[axis], square[axis]);
            high[axis] = std::max(high[axis], square[axis]);
        }
    const double width = 2 * (high[0] - low[0] + 1) + 2 * margin, height = 2 * (high[1] - low[1] + 1) + 2 * margin;
    MarkCanvas canvas(width, height, pixels_a_unit(width));
    std::vector<MarkSquare> bricks; // of 2 x 1
    for (std::size_t i = 0; i < digits.size(); ++i) {
        const MarkPoint corner{margin + 2 * (squares[i][0] - low[0]), margin + 2 * (squares[i][1] - low[1])};
        for (const double part : {0.0, 1.0})
            bricks.push_back(digits[i] ? MarkSquare{{corner[0], corner[1] + part}, {2, 0}, {0, 1}}
                                       : MarkSquare{{corner[0] + part, corner[1]}, {1, 0}, {0, 2}});
    }
    for (std::size_t i = 0; i < bricks.size(); ++i)
        canvas.polygon(digits[i / 2] ? "#d98c6a" : "#f2e2b3", bricks[i].outline());
    for (const MarkSquare& brick : bricks) canvas.outline("#000000", brick.outline(), 0.06);
    DistributionResult result;
    const auto ones = std::ranges::count(digits, true);
    std::string first;
    for (std::size_t i = 0; i < std::min<std::size_t>(digits.size(), 40); ++i) first += digits[i] ? '1' : '0';
    result.facts = {fmt::format("digits {}{}", first, digits.size() > 40 ? "..." : ""),
                    "the first square is in the middle, the second to its right, and on counterclockwise"};
    result.numbers = {{"bricks", "Bricks", static_cast<double>(bricks.size()), ""},
                      {"ones", "Ones among the digits", static_cast<double>(ones), ""}};
    files.add_marks(
        "tiling.json", canvas.picture(),
        fmt::format("Bricks by the first {} binary digits of pi: standing pairs are 0, lying ones 1.", digits.size()),
        result);
    return result;
}

}
