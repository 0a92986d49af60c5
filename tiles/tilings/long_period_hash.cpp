#include "tiles/tilings/long_period_hash.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace poissonlab {
namespace {

__extension__ using Wide = unsigned __int128;

bool is_prime(std::uint32_t n)
{
    for (std::uint32_t d = 2; d * d <= n; ++d) {
        if (n % d == 0) return false;
    }
    return n >= 2;
}

[[noreturn]] void refuse(const LongPeriodDesign& design, const std::string& why)
{
    throw InputError(fmt::format("long-period hash of tables with {} entries, range {}: {}",
                                 fmt::join(design.sizes, ", "), design.range, why));
}

/// Throws InputError, see the constructor. Returns the product of all sizes.
std::uint64_t checked_product(Color colors, const LongPeriodDesign& design)
{
    const auto& sizes = design.sizes;
    if (std::ranges::find(sizes, design.range) == sizes.end()) refuse(design, "the range must be one of them");
    if (colors < 1 || colors > max_colors || design.range % colors != 0)
        refuse(design, fmt::format("must be a multiple of the {} colors", colors));
    std::uint64_t product = 1;
    const std::uint64_t largest = *std::ranges::max_element(sizes);
    for (const std::uint32_t size : sizes) {
        if (size < 2 || size > 65536) refuse(design, "tables must have from 2 to 65536 entries");
        if (std::gcd(product, std::uint64_t{size}) != 1) refuse(design, "sizes must be pairwise coprime");
        if (static_cast<Wide>(product) * size * largest >> 64 != 0) refuse(design, "the period is too long");
        product *= size;
    }
    return product;
}

/// 2^64 / size, rounded up.
std::uint64_t reciprocal_of(std::uint32_t size) { return ~std::uint64_t{0} / size + 1; }

}

LongPeriodDesign tiling_hash_design(Color colors)
{
    const std::uint32_t range = std::max(1u, (24 + colors / 2) / colors) * colors;
    LongPeriodDesign design{range, {range}};
    const auto add_primes = [&](std::uint32_t step) {
        int wanted = 3;
        for (std::uint32_t n = range + step; wanted > 0 && n >= 2; n += step) {
            if (!is_prime(n) || range % n == 0) continue;
            design.sizes.push_back(n);
            --wanted;
        }
    };
    add_primes(~0u); // downwards
    add_primes(1);
    std::ranges::sort(design.sizes);
    return design;
}

LongPeriodHash::LongPeriodHash(Color colors, LongPeriodDesign design, const StreamKey& key)
    : colors_(colors), design_(std::move(design)), product_(checked_product(colors, design_))
{
    std::uint32_t largest_sum = 0;
    for (const std::uint32_t size : design_.sizes) {
        const auto number = static_cast<std::uint32_t>(tables_.size()) + 1;
        const auto values = random_permutation(size, key, number);
        tables_.push_back({size, reciprocal_of(size), entries_.size()});
        for (int copy = 0; copy < 2; ++copy) {
            for (const std::uint32_t value : values) entries_.push_back(static_cast<std::uint16_t>(value));
        }
        largest_sum += size - 1;
    }
    for (std::uint32_t sum = 0; sum <= largest_sum; ++sum)
        color_of_sum_.push_back(static_cast<std::uint8_t>(sum % design_.range % colors));
}

HashPeriod LongPeriodHash::period() const
{
    // The colour is the sum of all tables' colours modulo their number, which divides the range. Periods of
    // different tables are coprime, so a period of the sum is one of each summand: some multiple of it is 1
    // modulo that summand's period and 0 modulo all others.
    HashPeriod period{1, 1};
    for (const Table& table : tables_) {
        const auto entries = permutation(table);
        const HashPeriod own = permutation_period(std::vector<std::uint32_t>(entries.begin(), entries.end()), colors_);
        period.x *= own.x;
        period.y *= own.y;
    }
    return period;
}

void LongPeriodHash::fill_row(std::int64_t x, std::int64_t step, std::int64_t y, std::span<std::uint8_t> row) const
{
    const std::uint64_t x0 = reduced(x);
    const std::uint64_t y0 = reduced(y);
    const std::uint64_t step0 = reduced(step);
    std::array<std::uint32_t, 1024> sums{};
    for (std::size_t begin = 0; begin < row.size(); begin += sums.size()) {
        const std::size_t count = std::min(sums.size(), row.size() - begin);
        std::fill_n(sums.begin(), count, 0u);
        for (const Table& table : tables_) {
            const std::uint16_t* const column = entries_.data() + table.begin;
            const std::uint16_t* const entry = column + table.remainder(y0);
            const std::uint32_t table_step = table.remainder(step0);
            const auto passed = static_cast<std::uint32_t>(begin % table.size);
            std::uint32_t at = (table.remainder(x0) + passed * table_step) % table.size;
            for (std::size_t i = 0; i < count; ++i) {
                sums[i] += entry[column[at]];
                at += table_step;
                if (at >= table.size) at -= table.size;
            }
        }
        for (std::size_t i = 0; i < count; ++i) row[begin + i] = color_of_sum_[sums[i]];
    }
}

std::vector<std::uint32_t> LongPeriodHash::device_words() const
{
    std::vector<std::uint32_t> words{long_period_hash_tag, colors_, static_cast<std::uint32_t>(tables_.size())};
    words.insert(words.end(), design_.sizes.begin(), design_.sizes.end());
    for (const Table& table : tables_) {
        const auto entries = permutation(table);
        words.insert(words.end(), entries.begin(), entries.end());
    }
    return words;
}

}
