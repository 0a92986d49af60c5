#include "base/crew/mpi_exchange.hpp"

#include "base/crew/mpi_waiting.hpp"

#include <algorithm>

namespace poissonlab {
namespace {

constexpr int exchange_tag = 4; ///< see mpi_crew.cpp for the others

/// MPI counts bytes by int.
constexpr std::size_t most_bytes_at_once = std::size_t{1} << 30;

/// Calls `start` with each piece of a message, in order: its begin, its length, and its request.
template <class Bytes, class Start>
void start_pieces(Bytes& message, std::vector<MPI_Request>& requests, const Start& start)
{
    for (std::size_t at = 0; at < message.size(); at += most_bytes_at_once) {
        const auto length = static_cast<int>(std::min(most_bytes_at_once, message.size() - at));
        start(message.data() + at, length, &requests.emplace_back());
    }
}

}

std::vector<std::uint64_t> exchange_lengths(const std::vector<std::uint64_t>& lengths)
{
    std::vector<std::uint64_t> taken(lengths.size());
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Ialltoall(lengths.data(), 1, MPI_UINT64_T, taken.data(), 1, MPI_UINT64_T, MPI_COMM_WORLD, &request);
    wait_for(request);
    return taken;
}

void exchange_messages(int rank, const Messages& sent, Messages& taken)
{
    std::vector<MPI_Request> requests;
    for (int other = 0; other < static_cast<int>(sent.size()); ++other) {
        if (other == rank) continue;
        const auto place = static_cast<std::size_t>(other);
        start_pieces(taken[place], requests, [&](std::byte* begin, int length, MPI_Request* request) {
            MPI_Irecv(begin, length, MPI_BYTE, other, exchange_tag, MPI_COMM_WORLD, request);
        });
        start_pieces(sent[place], requests, [&](const std::byte* begin, int length, MPI_Request* request) {
            MPI_Isend(begin, length, MPI_BYTE, other, exchange_tag, MPI_COMM_WORLD, request);
        });
    }
    for (MPI_Request& request : requests) wait_for(request);
}

}
