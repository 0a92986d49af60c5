// Bytes from each process of an MPI job to each other one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// The bytes for each process, by its rank, or from each.
using Messages = std::vector<std::vector<std::byte>>;

/// The lengths of the messages that each process sends to this one; `lengths` are those of its own, by rank.
std::vector<std::uint64_t> exchange_lengths(const std::vector<std::uint64_t>& lengths);

/// Sends messages to all other processes, and fills those that they send to this one, which have their lengths.
void exchange_messages(int rank, const Messages& sent, Messages& taken);

}
