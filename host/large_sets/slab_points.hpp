// The points of a set that the processes of a crew hold together: each has slabs of the torus that are side by side.
#pragma once

#include "host/large_sets/sent_points.hpp"
#include "host/sampling/slabs/numbered_points.hpp"
#include "host/sampling/slabs/slab_division.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace poissonlab {

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

}
