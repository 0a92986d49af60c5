// Parts of the tree of a search for packings: its nodes are the steps that fit, one below the other.
//
// Knuth, Estimating the Efficiency of Backtrack Programs, Mathematics of Computation 29, 1975: a walk that goes down by
// chance estimates the number of nodes, without bias, and weighs a node by the product of 1 / choices on the way to it.
#pragma once

#include "tiles/packing/packing_board.hpp"

#include <functional>

namespace poissonlab {

/// A subtree and how far its search is.
struct PackingSubtree
{
    std::vector<std::size_t> path;    ///< the choices down to the last node that was visited
    std::size_t depth = 0;            ///< of its root: as many choices of the path lead there
    double weight = 1;                ///< of its root
    double share = 0;                 ///< of the subtree that is done, by the weights of nodes
    std::uint64_t nodes = 0;          ///< that were visited, without the root
    std::uint64_t packings = 0;       ///< that were found
    std::vector<std::size_t> tiles{}; ///< of those that are kept, one packing after the other
    bool is_done = false;
};

/// A search stops at these events.
struct SubtreeWalk
{
    std::uint64_t until_nodes = 0;   ///< pauses once so many of the subtree were visited
    bool stops_at_first = false;     ///< is done with the first packing
    bool keeps_packings = true;      ///< false: they are counted only
    std::function<bool()> goes_on{}; ///< is asked now and then; false, or an exception, leaves what can go on later
};

/// True if a path lies below the root of a fresh subtree, and an empty board allows it and leaves steps below it.
bool has_path(PackingBoard& board, const PackingSubtree& root, const std::vector<std::size_t>& path);

/// Goes on with the search of a subtree, whose path is there, on an empty board, which is empty again afterwards.
void walk(PackingBoard& board, PackingSubtree& subtree, const SubtreeWalk& how);

/// The tree above some subtrees.
struct CutTree
{
    std::vector<PackingSubtree> subtrees; ///< in the order of the search
    std::uint64_t nodes = 0;              ///< their roots and all above, but for the tree's root
};

/// Cuts the tree at the smallest depth at which it has at least `wanted` subtrees, or where it has no more.
CutTree cut_tree(PackingBoard& board, std::size_t wanted);

/// A mean of independent estimates, and its standard error.
struct TreeEstimate
{
    double nodes = 0; ///< of the tree, without its root
    double error = 0;
};

/// Estimates the number of nodes of the tree by at least 2 walks down, whose choices are random.
TreeEstimate estimate_nodes(PackingBoard& board, std::uint32_t walks, std::uint64_t seed);

}
