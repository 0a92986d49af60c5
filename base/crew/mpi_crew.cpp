#include "base/crew/mpi_crew.hpp"

#include "base/crew/failure.hpp"
#include "base/crew/mpi_waiting.hpp"
#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <deque>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace poissonlab {
namespace {

// Bytes from each process of an MPI job to each other one.

/// The bytes for each process, by its rank, or from each.
using Messages = std::vector<std::vector<std::byte>>;

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

/// The lengths of the messages that each process sends to this one; `lengths` are those of its own, by rank.
std::vector<std::uint64_t> exchange_lengths(const std::vector<std::uint64_t>& lengths)
{
    std::vector<std::uint64_t> taken(lengths.size());
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Ialltoall(lengths.data(), 1, MPI_UINT64_T, taken.data(), 1, MPI_UINT64_T, MPI_COMM_WORLD, &request);
    wait_for(request);
    return taken;
}

/// Sends messages to all other processes, and fills those that they send to this one, which have their lengths.
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

constexpr int report_tag = 1;   ///< to the leader: what became of a job, and that another one is wanted
constexpr int order_tag = 2;    ///< from the leader
constexpr int farewell_tag = 3; ///< from the leader: the end

/// A process's report to the leader. The message of a failure follows.
struct JobReport
{
    std::int64_t id = -1; ///< of the job that was done, or failed; -1: none yet
    Failure::Kind failure = Failure::Kind::none;
};

/// The leader's answer.
struct Order
{
    std::int64_t id = -1; ///< -1: there is no more to do
    Job job;
    bool has_failed = false; ///< the work as a whole
};

std::string host_name()
{
    std::array<char, 256> name{};
    return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "another machine";
}

Failure elsewhere(Failure failure, const std::string& host)
{
    if (failure.kind != Failure::Kind::none) failure.message = host + ": " + failure.message;
    return failure;
}

/// The outcome of a job.
struct Outcome
{
    Job job;
    Failure failure;
    std::size_t given_up = 0;
};

/// Hands out the jobs of a schedule: to its own process, and in a thread to the others.
class Dealer
{
public:
    Dealer(Schedule& schedule, int processes, const Crew::Done& done, const Crew::Failed& failed)
        : schedule_(schedule), others_(processes - 1), done_(done), failed_(failed)
    {}

    /// Executes jobs here until all are done everywhere. Throws what was thrown in any process and ends the work.
    void work(const Crew::Execute& execute)
    {
        std::thread dealing([this] { deal(); });
        try {
            work_here(execute);
        } catch (...) {
            note(Failure::current());
        }
        {
            const std::lock_guard lock(mutex_);
            is_over_ = true;
        }
        dealing.join();
        failure_.raise();
    }

private:
    void work_here(const Crew::Execute& execute)
    {
        while (true) {
            stop_if_interrupted();
            std::deque<Outcome> finished;
            std::optional<Schedule::Id> id;
            {
                const std::lock_guard lock(mutex_);
                if (failure_.kind != Failure::Kind::none) return;
                finished.swap(finished_);
                if (finished.empty()) {
                    if (schedule_.is_done()) return;
                    id = schedule_.next();
                }
            }
            for (const Outcome& outcome : finished) tell(outcome, false);
            if (id) {
                const Job job = schedule_.job(*id);
                const Failure failure = Failure::of([&] { execute(job); }, static_cast<bool>(failed_));
                Outcome outcome;
                {
                    const std::lock_guard lock(mutex_);
                    outcome = finish(*id, failure);
                }
                tell(outcome, true);
            } else if (finished.empty()) {
                std::this_thread::sleep_for(longest_pause);
            }
        }
    }

    bool is_of_one_job(const Failure& failure) const { return failed_ && failure.spares_others(); }

    Outcome finish(Schedule::Id id, const Failure& failure)
    {
        Outcome outcome{schedule_.job(id), failure};
        schedule_.finish(id);
        if (failure.kind != Failure::Kind::none) outcome.given_up = schedule_.give_up(outcome.job);
        return outcome;
    }

    void tell(const Outcome& outcome, bool here) const
    {
        if (outcome.failure.kind == Failure::Kind::none)
            done_(outcome.job, here);
        else
            failed_(outcome.job, outcome.failure, outcome.given_up);
    }

    void note(const Failure& failure)
    {
        const std::lock_guard lock(mutex_);
        if (failure_.kind == Failure::Kind::none) failure_ = failure;
    }

    /// Answers reports until every other process was told that there is no more to do.
    void deal()
    {
        std::deque<int> waiting;
        for (int left = others_; left > 0;) {
            bool idle = true;
            if (const int rank = receive(); rank > 0) {
                waiting.push_back(rank);
                idle = false;
            }
            while (!waiting.empty()) {
                const auto order = next_order();
                if (!order) break;
                MPI_Send(&*order, sizeof(Order), MPI_BYTE, waiting.front(), order_tag, MPI_COMM_WORLD);
                waiting.pop_front();
                if (order->id < 0) --left;
                idle = false;
            }
            if (idle) std::this_thread::sleep_for(longest_pause);
        }
    }

    /// Takes a report, if one has come, and returns who sent it; 0: none has.
    int receive()
    {
        int there = 0;
        MPI_Status status;
        MPI_Iprobe(MPI_ANY_SOURCE, report_tag, MPI_COMM_WORLD, &there, &status);
        if (!there) return 0;
        int bytes = 0;
        MPI_Get_count(&status, MPI_BYTE, &bytes);
        std::vector<char> message(static_cast<std::size_t>(bytes));
        MPI_Recv(message.data(), bytes, MPI_BYTE, status.MPI_SOURCE, report_tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
        JobReport report;
        std::memcpy(&report, message.data(), sizeof report);
        const Failure failure{report.failure, std::string(message.begin() + sizeof report, message.end())};
        if (failure.kind != Failure::Kind::none && !is_of_one_job(failure)) {
            note(failure);
        } else if (report.id >= 0) {
            const std::lock_guard lock(mutex_);
            finished_.push_back(finish(static_cast<Schedule::Id>(report.id), failure));
        }
        return status.MPI_SOURCE;
    }

    /// A job, or that there is no more; nothing: jobs are left, but all of them wait for others, or this process has
    /// not said yet that all went well.
    std::optional<Order> next_order()
    {
        const std::lock_guard lock(mutex_);
        const bool has_failed = failure_.kind != Failure::Kind::none;
        if (has_failed || is_over_) return Order{-1, {}, has_failed};
        const auto id = schedule_.next();
        if (!id) return std::nullopt;
        return Order{static_cast<std::int64_t>(*id), schedule_.job(*id)};
    }

    Schedule& schedule_;
    int others_;
    const Crew::Done& done_;
    const Crew::Failed& failed_;
    std::mutex mutex_;             ///< of all below, and of the schedule
    std::deque<Outcome> finished_; ///< by other processes, and not told yet
    Failure failure_;              ///< the first that ends the work
    bool is_over_ = false;         ///< nothing more can fail
};

class MpiCrew final : public Crew
{
public:
    /// `expected` is the number of processes that mpirun says it has started.
    explicit MpiCrew(int expected)
    {
        int threads = MPI_THREAD_SINGLE;
        if (MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &threads) != MPI_SUCCESS)
            throw InputError("MPI does not start");
        MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
        MPI_Comm_size(MPI_COMM_WORLD, &size_);
        if (threads < MPI_THREAD_SERIALIZED) refuse("this MPI does not allow several threads to use it");
        if (size_ != expected)
            refuse(fmt::format("mpirun started {} processes, and the MPI that poissonlab was built with sees {}: use "
                               "the mpirun of that MPI, or --shard",
                               expected, size_));
    }
    /// MPI_Finalize waits busily for the process that leads, which may write a report for long: sleep until that is
    /// done.
    ~MpiCrew() override
    {
        if (leads()) {
            for (int rank = 1; rank < size_; ++rank) MPI_Send(nullptr, 0, MPI_BYTE, rank, farewell_tag, MPI_COMM_WORLD);
        } else {
            MPI_Request request = MPI_REQUEST_NULL;
            MPI_Irecv(nullptr, 0, MPI_BYTE, 0, farewell_tag, MPI_COMM_WORLD, &request);
            wait_for(request);
        }
        MPI_Finalize();
    }
    MpiCrew(const MpiCrew&) = delete;
    MpiCrew& operator=(const MpiCrew&) = delete;

    int size() const override { return size_; }
    int rank() const override { return rank_; }
    bool leads() const override { return rank_ == 0; }

    bool work(Schedule& schedule, const Execute& execute, const Done& done, const Failed& failed) override
    {
        if (!leads()) return follow(execute);
        Dealer(schedule, size_, done, failed).work(execute);
        return true;
    }

    bool together(const std::function<void()>& what) override
    {
        Failure failure;
        try {
            what();
        } catch (...) {
            failure = Failure::current();
        }
        // The failure of the process that leads comes first, as it needs no name of a machine.
        if (!leads()) failure = elsewhere(failure, host_name());
        const auto all = gather(failure);
        for (const Failure& one : all) {
            if (one.kind == Failure::Kind::none) continue;
            if (leads()) one.raise();
            return false;
        }
        return true;
    }

    std::string from_leader(const std::string& text) override
    {
        auto bytes = static_cast<int>(text.size());
        MPI_Bcast(&bytes, 1, MPI_INT, 0, MPI_COMM_WORLD);
        std::string result = text;
        result.resize(static_cast<std::size_t>(bytes));
        MPI_Bcast(result.data(), bytes, MPI_BYTE, 0, MPI_COMM_WORLD);
        return result;
    }

    std::vector<std::uint64_t> sum(const std::vector<std::uint64_t>& numbers) override
    {
        std::vector<std::uint64_t> sums(numbers.size());
        MPI_Request request = MPI_REQUEST_NULL;
        MPI_Iallreduce(numbers.data(), sums.data(), static_cast<int>(numbers.size()), MPI_UINT64_T, MPI_SUM,
                       MPI_COMM_WORLD, &request);
        wait_for(request);
        return sums;
    }

    std::optional<Messages> exchange(Messages messages) override
    {
        std::vector<std::uint64_t> lengths;
        for (const auto& message : messages) lengths.push_back(message.size());
        const std::vector<std::uint64_t> lengths_taken = exchange_lengths(lengths);
        Messages taken(messages.size());
        const bool has_room = together([&] {
            for (std::size_t from = 0; from < taken.size(); ++from)
                if (static_cast<int>(from) != rank_) taken[from].resize(lengths_taken[from]);
        });
        if (!has_room) return {};
        exchange_messages(rank_, messages, taken);
        taken[static_cast<std::size_t>(rank_)] = std::move(messages[static_cast<std::size_t>(rank_)]);
        return taken;
    }

private:
    [[noreturn]] static void refuse(const std::string& why)
    {
        MPI_Finalize();
        throw InputError(why);
    }

    /// Takes orders until there are no more. Returns whether all went well, everywhere.
    bool follow(const Execute& execute)
    {
        JobReport report;
        std::string message;
        while (true) {
            send(report, message);
            const Order order = receive();
            if (order.id < 0) return !order.has_failed;
            report = {order.id, Failure::Kind::none};
            message.clear();
            try {
                execute(order.job);
            } catch (...) {
                const Failure failure = elsewhere(Failure::current(), host_name());
                report.failure = failure.kind;
                message = failure.message;
            }
        }
    }

    static void send(const JobReport& report, const std::string& message)
    {
        std::vector<char> bytes(sizeof report + message.size());
        std::memcpy(bytes.data(), &report, sizeof report);
        std::memcpy(bytes.data() + sizeof report, message.data(), message.size());
        MPI_Send(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, 0, report_tag, MPI_COMM_WORLD);
    }

    static Order receive()
    {
        Order order;
        MPI_Request request = MPI_REQUEST_NULL;
        MPI_Irecv(&order, sizeof order, MPI_BYTE, 0, order_tag, MPI_COMM_WORLD, &request);
        wait_for(request);
        return order;
    }

    /// The failures of all processes by rank, messages cut to what fits into a fixed length.
    std::vector<Failure> gather(const Failure& failure) const
    {
        constexpr std::size_t length = 2048;
        std::vector<char> own(length);
        own[0] = static_cast<char>(failure.kind);
        std::memcpy(own.data() + 1, failure.message.data(), std::min(failure.message.size(), length - 2));
        std::vector<char> all(length * static_cast<std::size_t>(size_));
        MPI_Request request = MPI_REQUEST_NULL;
        MPI_Iallgather(own.data(), length, MPI_BYTE, all.data(), length, MPI_BYTE, MPI_COMM_WORLD, &request);
        wait_for(request);
        std::vector<Failure> failures;
        for (std::size_t at = 0; at < all.size(); at += length)
            failures.push_back({static_cast<Failure::Kind>(all[at]), &all[at + 1]});
        return failures;
    }

    int rank_ = 0;
    int size_ = 1;
};

}

std::unique_ptr<Crew> make_mpi_crew(int expected) { return std::make_unique<MpiCrew>(expected); }

}
