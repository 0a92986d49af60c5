// One expansion move: every pixel keeps what it shows or takes what is proposed to it, whichever costs least together.
//
// Boykov, Veksler and Zabih, Fast Approximate Energy Minimization via Graph Cuts, PAMI 23, 2001, section 5; the graph
// is that of Kolmogorov and Zabih, What Energy Functions Can Be Minimized via Graph Cuts?, PAMI 26, 2004, section 4.
// Costs are integers, so that moves are exact; of several least choices it is the one that takes the fewest pixels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// The costs of two neighbouring pixels, by what the first and the second one do. A cut can minimise them where
/// kept_kept + taken_taken is at most kept_taken + taken_kept, as it is for distances that obey the triangle
/// inequality.
struct PairChoice
{
    std::int64_t kept_kept = 0, kept_taken = 0, taken_kept = 0, taken_taken = 0;

    bool operator==(const PairChoice&) const = default;
};

class ExpansionMove
{
public:
    explicit ExpansionMove(std::size_t pixels) : gains_(pixels) { edges_.reserve(2 * pixels); }

    std::size_t pixels() const { return gains_.size(); }

    /// Adds to what a pixel costs by itself.
    void add_pixel(std::size_t pixel, std::int64_t kept, std::int64_t taken)
    {
        constant_ += kept;
        gains_[pixel] += kept - taken;
    }

    /// Throws std::logic_error for costs that no cut can minimise.
    void add_pair(std::size_t first, std::size_t second, const PairChoice& costs);

    /// The cost of a choice: 1 stands for pixels that take the proposal.
    std::int64_t cost(const std::vector<std::uint8_t>& choice) const;

    struct Choice
    {
        std::vector<std::uint8_t> taken; ///< 1: the pixel takes the proposal
        std::int64_t cost = 0;
    };

    /// The choice that costs least. By libmaxflow; its flow is compared with the cost.
    Choice best() const;

private:
    /// A part of what a pair costs: if the first pixel keeps and the second one takes, or the other way round.
    struct Edge
    {
        std::uint32_t first = 0, second = 0;
        std::int64_t forward = 0, backward = 0;
    };

    /// No flow, and no capacity that matters, is larger.
    std::int64_t largest_flow() const;

    std::int64_t constant_ = 0;       ///< the cost if all pixels keep
    std::vector<std::int64_t> gains_; ///< by how much a pixel becomes cheaper by itself if it takes
    std::vector<Edge> edges_;
};

}
