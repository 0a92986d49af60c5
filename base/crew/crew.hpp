// The processes that share the work of a run.
#pragma once

#include "base/crew/failure.hpp"
#include "base/crew/schedule.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// One process, or several that take jobs from the same schedule and keep what they make in the same store.
///
/// One of them leads: it has the schedule, writes the results and speaks to the user. Members are called by all
/// processes in the same order.
class Crew
{
public:
    using Execute = std::function<void(const Job&)>;
    /// `here`: this process has executed the job.
    using Done = std::function<void(const Job&, bool here)>;
    /// `given_up`: so many more jobs of the same series or exhibit will not be executed.
    using Failed = std::function<void(const Job&, const Failure&, std::size_t given_up)>;

    virtual ~Crew() = default;

    virtual int size() const = 0;
    virtual int rank() const = 0; ///< from 0 on
    virtual bool leads() const = 0;

    /// Executes jobs until all are done: `execute` in the process that got the job, `done` in the one that leads, one
    /// call at a time, between its own jobs. Only the schedule of the process that leads matters. `failed` is called
    /// there like `done` where `execute` throws what spares other jobs. All else that any process throws, and
    /// everything where there is no `failed`, is thrown in the one that leads, and the others return false; true where
    /// nothing was thrown.
    virtual bool work(Schedule& schedule, const Execute& execute, const Done& done, const Failed& failed) = 0;

    /// Does something in every process. What any of them throws is thrown in the one that leads, and the others return
    /// false; true where all went well.
    virtual bool together(const std::function<void()>& what) = 0;

    /// The text of the process that leads, in every process.
    virtual std::string from_leader(const std::string& text) = 0;

    /// The sums of the numbers of all processes, place by place, in every process; each has as many numbers.
    virtual std::vector<std::uint64_t> sum(const std::vector<std::uint64_t>& numbers) = 0;

    /// Sends bytes to each process, by its rank, and returns what each of them sends to this one. Nothing where one has
    /// no memory for it, which the process that leads throws.
    virtual std::optional<std::vector<std::vector<std::byte>>>
    exchange(std::vector<std::vector<std::byte>> messages) = 0;
};

/// A crew of this process alone.
std::unique_ptr<Crew> make_crew_of_one();

/// The processes that mpirun started together with this one; this one alone if it did not. Throws InputError if mpirun
/// started several and the program was built without MPI: each would do all the work.
std::unique_ptr<Crew> make_crew();

/// The number of processes of the crew on this machine, this one included. Asks the environment only.
int crew_processes_here();

/// The threads of this process for ThreadLimit, of which the user has asked for so many (0: as many as there are).
/// Processes of a crew share the cores of a machine, unless mpirun has given each its own.
int threads_of_process(int asked, const Crew& crew);

/// True if another process leads the crew of this one. Asks the environment only.
bool is_crew_follower();

}
