// Sets of realizations that are made several at once, and kept until they are asked for.
#pragma once

#include "host/device/device.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace poissonlab {

template <typename Set>
class SetsAhead
{
public:
    /// See Sampler::expect().
    void expect(std::uint32_t first, std::uint32_t count) { expected_ = {first, count}; }

    /// The number of sets that are expected from a realization on, itself among them, but at most `most`; at least 1.
    std::uint32_t expected_from(std::uint32_t realization, std::size_t most) const
    {
        const auto [first, count] = expected_;
        const bool is_expected = realization >= first && realization - first < count;
        const std::size_t all = is_expected ? count - (realization - first) : 1;
        return static_cast<std::uint32_t>(std::clamp<std::size_t>(most, 1, all));
    }

    /// The set of a realization. Unless it is there, make() makes it, and as many after it as it likes.
    template <typename Make>
    Set take(std::uint32_t realization, const Device& device, const Make& make)
    {
        if (!made_.contains(realization)) {
            const double built = device.build_seconds();
            const auto begin = std::chrono::steady_clock::now();
            std::vector<Set> sets = make();
            const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
            seconds_ = (seconds - (device.build_seconds() - built)) / static_cast<double>(sets.size());
            made_.clear();
            for (std::uint32_t i = 0; i < sets.size(); ++i) made_.emplace(realization + i, std::move(sets[i]));
        }
        return std::move(made_.extract(realization).mapped());
    }

    /// See SetTraits::shared_seconds.
    std::optional<double> seconds() const { return seconds_; }

private:
    std::pair<std::uint32_t, std::uint32_t> expected_{};
    std::map<std::uint32_t, Set> made_; ///< and not asked for yet
    std::optional<double> seconds_;
};

}
