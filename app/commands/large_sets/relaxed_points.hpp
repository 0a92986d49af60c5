// Commands that relax one set of any size, by one process or several: what they are asked for, and their work.
//
// The set is that of the method with the same seed, its first realization, number for number: the method's steps are
// those of slabs of the torus, which processes share, see host/large_sets/slab_relaxation.hpp.
#pragma once

#include "app/commands/kind_options.hpp"
#include "base/crew/crew.hpp"
#include "host/sampling/lloyd_relaxation.hpp"
#include "host/sampling/slabs/slab_method.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// A method whose steps can be made slab by slab.
struct RelaxedMethod
{
    SamplerSpec spec;
    std::vector<std::string> left_out; ///< parameters of the method that need the set as a whole

    std::function<LloydRequest(const Parameters& parameters)> request; ///< iterations on each level
    std::function<std::unique_ptr<SlabMethod>(const Parameters& parameters, int dimension, std::uint64_t points)>
        in_slabs;

    /// Coarser sets before the last one, each of whose points is split, see level_points().
    std::function<std::int64_t(const Parameters& parameters)> coarser_levels;
};

/// A set as it is asked for.
struct AskedRelaxation
{
    Parameters parameters;
    std::optional<std::uint64_t> points;
    int dimension = 2;
    double memory = 1; ///< GB
};

/// Says what an interruption of a command that makes one set leaves: nothing, in one line for all processes.
void say_what_interruption_keeps(const Crew& crew);

/// The keys of such a command: the method's own, and those of the set.
void relaxation_keys(Keys& keys, AskedRelaxation& asked, const RelaxedMethod& method);

/// Makes the set and writes it to --out, by all processes of the crew.
void write_relaxed_points(const KindOptions& options, const RelaxedMethod& method);

/// The command of a kind that described_command() has made.
Command relaxation_command(const Kind& kind, std::string notes, void (*work)(const KindOptions&));

}
