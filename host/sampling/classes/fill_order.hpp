// The order in which classes get points: the one that is least filled is next.
//
// Wei, Multi-class blue noise sampling, 2010, section 3.3 (fill rate).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace poissonlab {

class FillOrder
{
public:
    /// `shares`: the points of each class that fill it, or numbers in proportion to them; positive. `ends`: what each
    /// has at most; empty: no end.
    FillOrder(std::vector<double> shares, std::vector<std::size_t> ends);

    /// The class whose points over its share are fewest, the first of several; nothing where all are closed or at
    /// their ends.
    std::optional<std::uint32_t> next() const;

    /// The class has one point more.
    void add(std::uint32_t to);

    /// No further point of the class fits.
    void close(std::uint32_t full);

    bool is_closed(std::uint32_t of) const { return is_closed_[of]; }
    const std::vector<std::size_t>& counts() const { return counts_; }

private:
    std::vector<double> shares_;
    std::vector<std::size_t> ends_;
    std::vector<std::size_t> counts_;
    std::vector<bool> is_closed_;
};

}
