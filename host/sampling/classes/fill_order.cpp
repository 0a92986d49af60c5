#include "host/sampling/classes/fill_order.hpp"

#include <utility>

namespace poissonlab {

FillOrder::FillOrder(std::vector<double> shares, std::vector<std::size_t> ends)
    : shares_(std::move(shares)), ends_(std::move(ends)), counts_(shares_.size()), is_closed_(shares_.size())
{}

std::optional<std::uint32_t> FillOrder::next() const
{
    std::optional<std::uint32_t> least;
    for (std::uint32_t i = 0; i < shares_.size(); ++i) {
        if (is_closed_[i] || (!ends_.empty() && counts_[i] == ends_[i])) continue;
        // Products, not quotients: whole numbers below 2^53 are compared exactly.
        if (!least ||
            static_cast<double>(counts_[i]) * shares_[*least] < static_cast<double>(counts_[*least]) * shares_[i])
            least = i;
    }
    return least;
}

void FillOrder::add(std::uint32_t to) { ++counts_[to]; }

void FillOrder::close(std::uint32_t full) { is_closed_[full] = true; }

}
