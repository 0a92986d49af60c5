// The points of a set that the processes of a crew hold together: each has slabs of the torus that are side by side.
#pragma once

#include "base/crew/crew.hpp"
#include "base/points/placed_file.hpp"
#include "host/sampling/slabs/slab_mover.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <span>
#include <utility>
#include <vector>

namespace poissonlab {

// Points on their way from process to process.

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

class SlabPoints
{
public:
    /// Gives each process as many slabs as any other. Takes memory for a set of about `expected` points that are spread
    /// evenly.
    SlabPoints(const SlabDivision& division, Crew& crew, std::uint64_t expected);

    /// The bytes that a point takes in the process that has it.
    static std::uint64_t bytes_per_point(int dimension)
    {
        return sizeof(double) * static_cast<std::uint64_t>(dimension) + sizeof(std::uint32_t);
    }

    /// Adds a point, which is in its slab at once where this process has that, and after settle() elsewhere.
    void put(std::span<const double> place, std::uint32_t id);

    /// Sends points to where they belong. False where a process failed.
    bool settle();

    /// Fetches the points of so many layers of cells around each slab of this process. False where a process failed.
    bool fetch_around(std::uint32_t layers);

    /// The slabs of this process.
    std::uint32_t first_slab() const { return first_slab_; }
    std::uint32_t end_slab() const { return first_slab_ + static_cast<std::uint32_t>(own_.size()); }

    const NumberedPoints& own(std::uint32_t slab) const { return own_[slab - first_slab_]; }
    const NumberedPoints& around(std::uint32_t slab) const { return around_[slab - first_slab_]; }

    /// Forgets all points of this process.
    void clear();

private:
    std::size_t process_of(std::uint32_t slab) const { return slab / own_.size(); }
    bool is_here(std::uint32_t slab) const { return slab >= first_slab_ && slab < end_slab(); }

    const SlabDivision& division_;
    Crew& crew_;
    std::uint32_t first_slab_;
    std::vector<NumberedPoints> own_, around_; ///< of each slab of this process
    Outbox outbox_;
};

// A file of points that processes hold by their places, written in the order of their numbers.

/// Writes the points, some hundred thousand of them at a time: files with known places by all processes together,
/// others by the one that leads. The file is there whole or not at all. To be called by all processes; false where one
/// failed. Throws StorageError in the process that leads.
bool write_scattered_points(const std::filesystem::path& path, const PointFileHead& head, const SlabPoints& points,
                            Crew& crew);

/// The bytes that a point takes while this is done, in the process that has it.
constexpr std::uint64_t scattered_bytes_per_point = 16;

}
