// Points on their way from process to process.
#pragma once

#include "base/crew/crew.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>
#include <vector>

namespace poissonlab {

struct SentPoint
{
    std::array<double, 3> place{}; ///< as many coordinates as there are axes
    std::uint32_t id = 0;          ///< of the set
    std::uint32_t slab = 0;        ///< that it goes to
};

/// Points for each process of a crew, until they are sent.
class Outbox
{
public:
    explicit Outbox(const Crew& crew) : messages_(static_cast<std::size_t>(crew.size())) {}

    void add(std::size_t process, std::span<const double> place, std::uint32_t id, std::uint32_t slab)
    {
        SentPoint point{.id = id, .slab = slab};
        std::ranges::copy(place, point.place.begin());
        const auto bytes = std::as_bytes(std::span(&point, 1));
        messages_[process].insert(messages_[process].end(), bytes.begin(), bytes.end());
    }

    /// Sends all, and calls take(point) for those that come. To be called by all processes; false where one of them has
    /// no memory for it.
    template <class Take>
    bool send(Crew& crew, const Take& take)
    {
        const std::size_t processes = messages_.size();
        const auto taken = crew.exchange(std::exchange(messages_, std::vector<std::vector<std::byte>>(processes)));
        if (!taken) return false;
        return crew.together([&] {
            for (const auto& message : *taken)
                for (std::size_t at = 0; at < message.size(); at += sizeof(SentPoint)) {
                    SentPoint point;
                    std::memcpy(&point, message.data() + at, sizeof point);
                    take(point);
                }
        });
    }

private:
    std::vector<std::vector<std::byte>> messages_;
};

}
