// The chains that a tile set gets: candidates from many tori, those of the most even balance first.
#pragma once

#include "host/tile_construction/chain_paths.hpp"
#include "host/tile_construction/tile_construction.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// The tori that are filled at once: some for each two colours.
std::size_t chain_tori(const PoissonTileParameters& parameters);

/// Fills tori around pairs of corner points, and finds chains there.
class ChainChoice
{
public:
    ChainChoice(const PoissonTileParameters& parameters, TileFiller& filler, const ConstructionOptions& options,
                ConstructionReport& report);

    /// Gives each pair of colours its best chains. Throws InputError where none are found.
    void choose(ChainPieces& pieces);

    /// Replaces a chain by its next candidate; false when there are no more.
    bool replace(ChainPieces& pieces, std::size_t direction, std::size_t number);

private:
    void fill_tori(const ChainPieces& pieces, std::uint32_t round);
    void collect(const ChainPieces& pieces, std::uint32_t a, std::uint32_t b, const FilledTorus& torus);
    bool are_enough() const;
    void sort_by_balance();
    std::vector<ChainCandidate>& candidates(std::size_t direction, std::size_t number)
    {
        return candidates_[direction][number];
    }

    const PoissonTileParameters& p_;
    TileFiller& filler_;
    const ConstructionOptions& options_;
    ConstructionReport& report_;
    ChainFinder finder_;
    std::array<std::vector<std::vector<ChainCandidate>>, chain_directions> candidates_; ///< by chain_number()
    std::array<std::vector<std::size_t>, chain_directions> taken_; ///< number of the candidate that is in use
};

}
