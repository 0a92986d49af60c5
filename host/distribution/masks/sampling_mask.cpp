#include "host/distribution/masks/sampling_mask.hpp"

#include "base/random/random.hpp"

#include <algorithm>

namespace poissonlab {
namespace {

/// Scales fall by this from pass to pass: by 0.917, distances by 0.958.
constexpr std::uint64_t next_scale(std::uint64_t scale) { return std::min(scale - 1, scale / 12 * 11 + scale % 12); }

/// Pixels by chance: sorted by a random number of each.
std::vector<std::uint32_t> shuffled_pixels(const MaskField& field, std::uint64_t seed)
{
    const StreamKey key = stream_key(seed, Purpose::mri_mask, 0);
    std::vector<std::pair<std::uint64_t, std::uint32_t>> keyed;
    for (std::uint32_t i = 0; i < field.pixels(); ++i) {
        if (field.allowed[i] == 0) continue;
        const auto words = philox({i, 0, 0, 0}, key);
        keyed.emplace_back(std::uint64_t{words[0]} << 32 | words[1], i);
    }
    std::ranges::sort(keyed);
    std::vector<std::uint32_t> order;
    for (const auto& [number, pixel] : keyed) order.push_back(pixel);
    return order;
}

std::vector<std::int64_t> random_offsets(std::size_t pixels, std::uint64_t seed)
{
    const StreamKey key = stream_key(seed, Purpose::mri_mask, 0);
    std::vector<std::int64_t> offsets;
    for (std::uint32_t i = 0; i < pixels; ++i) {
        const auto part = static_cast<std::int64_t>(philox({i, 0, 0, 0}, key)[2]); // of 2^32
        offsets.push_back((2 * most_offset * (part >> 8) >> 24) - most_offset);
    }
    return offsets;
}

class MaskDarts
{
public:
    MaskDarts(const MaskField& field, const SamplingMask& mask)
        : field_(field), mask_(mask), limits_(field.pixels(), UINT64_MAX), most_cost_(std::ranges::max(field.costs)),
          is_sample_(field.pixels())
    {}

    /// `scale` is the largest one that matters from now on.
    void take(std::uint32_t pixel, std::uint64_t scale)
    {
        is_sample_[pixel] = 1;
        const auto width = static_cast<std::int64_t>(field_.columns), height = static_cast<std::int64_t>(field_.rows);
        const std::int64_t column = pixel % field_.columns, row = pixel / field_.columns;
        const std::int64_t reach = reach_at(scale);
        for (std::int64_t y = std::max<std::int64_t>(0, row - reach); y < std::min(height, row + reach + 1); ++y)
            for (std::int64_t x = std::max<std::int64_t>(0, column - reach); x < std::min(width, column + reach + 1);
                 ++x) {
                const auto other = static_cast<std::size_t>(y * width + x);
                const std::uint64_t cost = std::max(field_.costs[pixel], field_.costs[other]);
                if (cost == 0) continue;
                const std::int64_t squared = ((x - column) * (x - column) + (y - row) * (y - row)) << 32;
                const std::int64_t left = squared - mask_.offset(pixel) - mask_.offset(other);
                limits_[other] =
                    std::min(limits_[other], static_cast<std::uint64_t>(std::max<std::int64_t>(0, left)) / cost);
            }
    }

    bool fits(std::uint32_t pixel, std::uint64_t scale) const
    {
        return is_sample_[pixel] == 0 && limits_[pixel] >= scale;
    }

    /// A scale at which two samples in opposite corners would be too near, were all costs at most the middle one.
    std::uint64_t first_scale() const
    {
        std::vector<std::uint64_t> costs = field_.costs;
        const auto middle = costs.begin() + static_cast<std::ptrdiff_t>(costs.size() / 2);
        std::ranges::nth_element(costs, middle);
        const std::uint64_t squared =
            std::uint64_t{field_.rows} * field_.rows + std::uint64_t{field_.columns} * field_.columns;
        return std::max<std::uint64_t>(1, (squared << 32) / std::max<std::uint64_t>(1, *middle));
    }

private:
    /// Pixels as far away as this or farther are not affected.
    std::int64_t reach_at(std::uint64_t scale) const
    {
        __extension__ using Wide = unsigned __int128;
        const Wide squared = (static_cast<Wide>(scale) * most_cost_ + 2 * static_cast<Wide>(most_offset)) >> 32;
        const std::int64_t longest = std::max(field_.rows, field_.columns);
        std::int64_t reach = 1;
        while (reach < longest && static_cast<Wide>(reach * reach) <= squared) ++reach;
        return reach;
    }

    const MaskField& field_;
    const SamplingMask& mask_;          ///< its offsets
    std::vector<std::uint64_t> limits_; ///< the largest scale at which each pixel is far enough from all samples
    std::uint64_t most_cost_;
    std::vector<std::uint8_t> is_sample_;
};

}

std::size_t MaskField::allowed_pixels() const
{
    return static_cast<std::size_t>(std::ranges::count(allowed, std::uint8_t{1}));
}

std::vector<std::uint8_t> SamplingMask::pixels() const
{
    std::vector<std::uint8_t> all(std::size_t{rows} * columns);
    for (const std::uint32_t sample : samples) all[sample] = 1;
    return all;
}

SamplingMask sampling_mask(const MaskField& field, std::size_t samples, std::uint64_t seed)
{
    SamplingMask mask{field.rows, field.columns, {}, 0, {}};
    if (field.is_graded) mask.offsets = random_offsets(field.pixels(), seed);
    MaskDarts darts(field, mask);
    mask.scale = darts.first_scale();
    for (const std::uint32_t pixel : field.always) {
        darts.take(pixel, mask.scale);
        mask.samples.push_back(pixel);
    }
    const std::vector<std::uint32_t> order = shuffled_pixels(field, seed);
    while (mask.samples.size() < samples) {
        for (const std::uint32_t pixel : order) {
            if (!darts.fits(pixel, mask.scale)) continue;
            darts.take(pixel, mask.scale);
            mask.samples.push_back(pixel);
            if (mask.samples.size() == samples) return mask;
        }
        mask.scale = mask.scale == 0 ? 0 : next_scale(mask.scale);
    }
    return mask;
}

}
