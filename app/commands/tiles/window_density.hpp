// The density that a command's points follow over a window of tiles, as it is typed: --density NUMBER|IMAGE|FORMULA.
#pragma once

#include "base/densities/density.hpp"

#include <array>
#include <optional>
#include <span>
#include <string>

namespace poissonlab {

/// The rectangle that a picture or a formula is laid over, in the units of points.
struct DensityArea
{
    std::array<double, 2> low{};
    std::array<double, 2> size{};
};

class WindowDensity
{
public:
    /// `from` says what of a picture: see density_of_picture(). Throws InputError, a line that starts with the option,
    /// where the text is none of the three, the number is not above 0 and at most 1, or tiles in space are given a
    /// picture or a formula.
    WindowDensity(const std::string& text, const std::string& from, const DensityArea& area, int dimension,
                  bool is_quiet = false);

    bool is_full() const { return !density_ && number_ >= 1; }

    /// Tells whether a point stays: its level is below the density.
    bool keeps(std::span<const double> point, double level) const
    {
        if (!density_) return level < number_;
        const auto weight =
            density_->at((point[0] - area_.low[0]) / area_.size[0], (point[1] - area_.low[1]) / area_.size[1]);
        return level * static_cast<double>(full_weight) < static_cast<double>(weight);
    }

private:
    double number_ = 1;
    std::optional<Density> density_;
    DensityArea area_;
};

}
