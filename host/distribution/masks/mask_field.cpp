// Pixels of a mask of samples ask for distances: by a power of the distance from the middle, or by a density.
#include "base/densities/density_text.hpp"
#include "base/errors/errors.hpp"
#include "host/distribution/masks/sampling_mask.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

/// A pixel from the middle, the pixel that frequency 0 has in spectra: (rows / 2, columns / 2), rounded down.
struct FromMiddle
{
    std::int64_t rows, columns; ///< of the grid
    std::int64_t down, right;

    FromMiddle(const MaskField& field, std::size_t pixel)
        : rows(field.rows), columns(field.columns), down(static_cast<std::int64_t>(pixel / field.columns) - rows / 2),
          right(static_cast<std::int64_t>(pixel % field.columns) - columns / 2)
    {}

    /// Is it inside the ellipse that touches the sides of the grid?
    bool is_in_ellipse() const
    {
        const std::int64_t y = 2 * down * columns, x = 2 * right * rows, one = rows * columns;
        return x * x + y * y < one * one;
    }

    /// The distance in parts of the ellipse's radius there.
    double distance() const
    {
        return std::hypot(2.0 * static_cast<double>(down) / static_cast<double>(rows),
                          2.0 * static_cast<double>(right) / static_cast<double>(columns));
    }

    bool is_in(const std::array<std::uint32_t, 2>& area) const
    {
        const auto inside = [](std::int64_t at, std::int64_t size) {
            return at >= -(size / 2) && at < size - size / 2;
        };
        return inside(down, area[0]) && inside(right, area[1]);
    }
};

/// 1 / density, in parts of that at distance 1.
std::uint64_t cost_by_power(double distance, double power)
{
    const double cost = std::pow(distance, power) * 0x1p20;
    return static_cast<std::uint64_t>(std::clamp(std::round(cost), 0.0, static_cast<double>(most_cost)));
}

}

MaskField mask_field(const SamplingMaskSettings& settings)
{
    const auto [rows, columns] = settings.shape;
    MaskField field{rows, columns, {}, {}};
    field.costs.resize(std::size_t{rows} * columns);
    field.allowed.resize(field.costs.size());
    field.is_graded = !settings.density.text.empty() || settings.power > 0;
    std::optional<Density> density;
    if (!settings.density.text.empty())
        density = density_of_text(settings.density.text, settings.density.from, columns, rows);
    for (std::uint32_t i = 0; i < field.costs.size(); ++i) {
        const FromMiddle at(field, i);
        bool is_allowed = settings.has_corners || at.is_in_ellipse();
        if (density) {
            const std::uint64_t weight =
                density->at((i % columns + 0.5) / columns, 1 - (static_cast<double>(i / columns) + 0.5) / rows);
            is_allowed = is_allowed && weight > 0;
            field.costs[i] = weight == 0 ? most_cost : std::min(most_cost, (full_weight << 8) / weight);
        } else {
            field.costs[i] = cost_by_power(at.distance(), settings.power);
        }
        if (at.is_in(settings.calibration)) field.always.push_back(i);
        field.allowed[i] = is_allowed ? 1 : 0;
    }
    return field;
}

std::size_t asked_samples(const SamplingMaskSettings& settings, const MaskField& field)
{
    const auto pixels = static_cast<double>(field.pixels());
    const std::size_t asked =
        settings.samples
            ? *settings.samples
            : static_cast<std::size_t>(std::max(1.0, std::round(pixels / settings.acceleration.value_or(1))));
    std::size_t all = field.allowed_pixels();
    for (const std::uint32_t i : field.always) all += field.allowed[i] == 0 ? 1 : 0;
    if (asked > all)
        throw InputError(
            fmt::format("these are {} samples, but only {} of {} pixels may be samples: an acceleration of "
                        "at least {:.4f}",
                        asked, all, field.pixels(), pixels / static_cast<double>(all)));
    if (asked < field.always.size())
        throw InputError(
            fmt::format("these are {} samples, but the calibration area alone has {}: an acceleration of at "
                        "most {:.4f}",
                        asked, field.always.size(), pixels / static_cast<double>(field.always.size())));
    return asked;
}

}
