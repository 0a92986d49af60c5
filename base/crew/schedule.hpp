// The jobs of a run and their order: which one may be done next.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <tuple>
#include <vector>

namespace poissonlab {

/// A piece of work for one process. Trivially copyable: sent between processes as it is.
struct Job
{
    enum class Kind : std::uint32_t
    {
        series,  ///< whatever a series still needs
        part,    ///< analysis of part `first` of a series
        sample,  ///< realizations `first` ... of a series
        exhibit, ///< one of a config's tables beside its methods
        points,  ///< piece `first` of the points of a window
    };

    Kind kind = Kind::series;
    std::uint32_t run = 0;  ///< of the runs at hand
    std::uint32_t item = 0; ///< series or exhibit of the run
    std::uint32_t first = 0;
    std::uint32_t count = 0; ///< of realizations that it makes, as far as that is known
};

/// Jobs that wait for others. Of those that are ready, what completes a series comes first, then what completes a part,
/// so that work that was begun is finished; then the order of runs. Within a run the first realizations of each series
/// come first, so that several processes build what series need, such as tile sets, at the same time. Else jobs keep
/// the order in which they were added.
class Schedule
{
public:
    using Id = std::size_t;

    /// `after` are jobs that must be done before.
    Id add(const Job& job, std::span<const Id> after = {});

    /// Hands out a job. Nothing: all are handed out, or wait for jobs that are not done.
    std::optional<Id> next();

    /// Takes note that a job that was handed out is done.
    void finish(Id id);

    /// Takes back the jobs of the same series or exhibit that are not handed out yet, as if they were done. Returns how
    /// many there were.
    std::size_t give_up(const Job& job);

    const Job& job(Id id) const { return nodes_[id].job; }
    std::size_t size() const { return nodes_.size(); }
    bool is_done() const { return done_ == nodes_.size(); }

private:
    struct Node
    {
        Job job;
        bool is_follow_up = false; ///< of jobs before
        bool is_out = false;       ///< handed out
        bool is_done = false;
        std::size_t waits_for = 0; ///< jobs
        std::vector<Id> followers;
    };
    using Place = std::tuple<std::uint32_t, std::uint32_t, bool, Id>;

    Place place_of(Id id) const;

    std::vector<Node> nodes_;
    std::set<Place> ready_;
    std::size_t done_ = 0;
};

}
