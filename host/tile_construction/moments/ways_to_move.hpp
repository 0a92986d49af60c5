// The ways to move some points by a few stored units each, found by what they change.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// A linear mixture of numbers from which they can be told, nearly always; sums of mixtures are mixtures of sums.
inline std::uint64_t mixture(std::int64_t a, std::int64_t b)
{
    return static_cast<std::uint64_t>(a) * 0x9e3779b97f4a7c15 + static_cast<std::uint64_t>(b) * 0xd1b54a32d192ed03;
}

/// All sums of one term of each list, by their numbers, in which the first list counts fast. Sums of the first lists
/// and of the last ones are kept, which fit into a fast memory; there are millions of all.
class Sums
{
public:
    explicit Sums(const std::vector<std::vector<std::uint64_t>>& terms);

    std::size_t size() const { return low_.size() * high_.size(); }
    std::uint64_t operator[](std::size_t number) const
    {
        return low_[number % low_.size()] + high_[number / low_.size()];
    }

    /// Visits the number and the sum of each, in order.
    template <class Visit>
    void for_each(const Visit& visit) const
    {
        std::size_t number = 0;
        for (const std::uint64_t high : high_)
            for (const std::uint64_t low : low_) visit(number++, low + high);
    }

private:
    std::vector<std::uint64_t> low_, high_;
};

/// Finds the ways that make a change. Most changes are found to be made by none in a small sieve.
class WayTable
{
public:
    /// Forgets the ways that were there. A table that is used again keeps its memory.
    void fill(const Sums& changes)
    {
        unsigned bits = 8;
        while (std::size_t{1} << bits < 2 * changes.size()) ++bits;
        shift_ = 64 - bits;
        ways_.assign(std::size_t{1} << bits, none);
        changes_.resize(ways_.size());
        sieve_.assign((ways_.size() << sieve_bits) / 64, 0);
        changes.for_each([&](std::size_t way, std::uint64_t change) {
            std::size_t place = mixed(change) >> shift_;
            while (ways_[place] != none) place = (place + 1) % ways_.size();
            ways_[place] = static_cast<std::uint32_t>(way);
            changes_[place] = change;
            const std::uint64_t bit = mixed(change) >> (shift_ - sieve_bits);
            sieve_[bit / 64] |= std::uint64_t{1} << bit % 64;
        });
    }

    template <class Visit>
    void for_each(std::uint64_t change, const Visit& visit) const
    {
        const std::uint64_t bit = mixed(change) >> (shift_ - sieve_bits);
        if ((sieve_[bit / 64] >> bit % 64 & 1) == 0) return;
        for (std::size_t place = mixed(change) >> shift_; ways_[place] != none; place = (place + 1) % ways_.size())
            if (changes_[place] == change) visit(ways_[place]);
    }

private:
    static constexpr std::uint32_t none = UINT32_MAX;
    static constexpr unsigned sieve_bits = 3; ///< of a place of the table, more than one

    static std::uint64_t mixed(std::uint64_t change) { return (change ^ change >> 32) * 0xff51afd7ed558ccd; }

    unsigned shift_ = 0;
    std::vector<std::uint32_t> ways_;
    std::vector<std::uint64_t> changes_, sieve_;
};

/// Moves each of some points along an axis in all ways; the numbers of ways count points' movements.
struct Half
{
    std::vector<std::size_t> points;

    bool operator==(const Half&) const = default;

    /// The movement of a point in one of the ways.
    static std::int64_t movement(std::size_t point, std::size_t way, int reach)
    {
        for (std::size_t i = 0; i < point; ++i) way /= static_cast<std::size_t>(2 * reach + 1);
        return static_cast<std::int64_t>(way % static_cast<std::size_t>(2 * reach + 1)) - reach;
    }

    /// The mixtures of what ways change, for the mixture of a single movement.
    template <class Change>
    Sums changes(int reach, const Change& change) const
    {
        std::vector<std::vector<std::uint64_t>> terms;
        for (const std::size_t point : points) {
            terms.emplace_back();
            for (int by = -reach; by <= reach; ++by) terms.back().push_back(change(point, by));
        }
        return Sums(terms);
    }
};

}
