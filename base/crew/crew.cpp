#include "base/crew/crew.hpp"

#include "base/crew/mpi_crew.hpp"
#include "base/programs/interrupt.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <initializer_list>
#include <string_view>
#include <thread>

#include <unistd.h>

namespace poissonlab {
namespace {

class CrewOfOne final : public Crew
{
public:
    int size() const override { return 1; }
    int rank() const override { return 0; }
    bool leads() const override { return true; }

    bool work(Schedule& schedule, const Execute& execute, const Done& done, const Failed& failed) override
    {
        while (const auto id = schedule.next()) {
            stop_if_interrupted();
            const Job job = schedule.job(*id);
            const Failure failure = Failure::of([&] { execute(job); }, static_cast<bool>(failed));
            schedule.finish(*id);
            if (failure.kind == Failure::Kind::none)
                done(job, true);
            else
                failed(job, failure, schedule.give_up(job));
        }
        return true;
    }

    bool together(const std::function<void()>& what) override
    {
        what();
        return true;
    }

    std::string from_leader(const std::string& text) override { return text; }

    std::vector<std::uint64_t> sum(const std::vector<std::uint64_t>& numbers) override { return numbers; }

    std::optional<std::vector<std::vector<std::byte>>> exchange(std::vector<std::vector<std::byte>> messages) override
    {
        return messages;
    }
};

/// The number in the first environment variable that is there.
int number_in_environment(std::initializer_list<const char*> names, int otherwise)
{
    for (const char* name : names) {
        const char* text = std::getenv(name);
        if (!text) continue;
        int value = 0;
        const std::string_view view(text);
        if (std::from_chars(view.data(), view.data() + view.size(), value).ec == std::errc{}) return value;
    }
    return otherwise;
}

// Open MPI; MPICH and its relatives. Slurm's own variables are not asked: jobs without MPI have them as well.

int crew_size() { return number_in_environment({"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}, 1); }
int crew_rank() { return number_in_environment({"OMPI_COMM_WORLD_RANK", "PMI_RANK"}, 0); }

}

int crew_processes_here() { return number_in_environment({"OMPI_COMM_WORLD_LOCAL_SIZE", "MPI_LOCALNRANKS"}, 1); }

int threads_of_process(int asked, const Crew& crew)
{
    if (asked > 0 || crew.size() == 1) return asked;
    const auto own = static_cast<int>(std::thread::hardware_concurrency());
    const auto all = static_cast<int>(sysconf(_SC_NPROCESSORS_ONLN));
    return std::max(1, own < all ? own : all / crew_processes_here());
}

bool is_crew_follower() { return crew_size() > 1 && crew_rank() > 0; }

std::unique_ptr<Crew> make_crew_of_one() { return std::make_unique<CrewOfOne>(); }

std::unique_ptr<Crew> make_crew() { return crew_size() < 2 ? make_crew_of_one() : make_mpi_crew(crew_size()); }

}
