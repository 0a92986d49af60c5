#include "base/crew/schedule.hpp"

namespace poissonlab {
namespace {

bool are_of_one_item(const Job& a, const Job& b)
{
    const bool are_alike = (a.kind == Job::Kind::exhibit) == (b.kind == Job::Kind::exhibit);
    return are_alike && a.run == b.run && a.item == b.item;
}

}

Schedule::Place Schedule::place_of(Id id) const
{
    const Job& job = nodes_[id].job;
    const bool goes_on = nodes_[id].is_follow_up;
    const std::uint32_t stage = goes_on && job.kind == Job::Kind::series ? 0 : goes_on ? 1 : 2;
    return {stage, job.run, job.kind == Job::Kind::sample && job.first > 0, id};
}

Schedule::Id Schedule::add(const Job& job, std::span<const Id> after)
{
    const Id id = nodes_.size();
    nodes_.push_back({.job = job, .is_follow_up = !after.empty(), .followers = {}});
    for (const Id before : after) {
        if (nodes_[before].is_done) continue;
        nodes_[before].followers.push_back(id);
        ++nodes_[id].waits_for;
    }
    if (nodes_[id].waits_for == 0) ready_.insert(place_of(id));
    return id;
}

std::optional<Schedule::Id> Schedule::next()
{
    if (ready_.empty()) return std::nullopt;
    const Id id = std::get<Id>(*ready_.begin());
    ready_.erase(ready_.begin());
    nodes_[id].is_out = true;
    return id;
}

void Schedule::finish(Id id)
{
    nodes_[id].is_done = true;
    ++done_;
    for (const Id follower : nodes_[id].followers)
        if (--nodes_[follower].waits_for == 0 && !nodes_[follower].is_done) ready_.insert(place_of(follower));
}

std::size_t Schedule::give_up(const Job& job)
{
    std::size_t count = 0;
    for (Id id = 0; id < nodes_.size(); ++id) {
        if (nodes_[id].is_out || nodes_[id].is_done || !are_of_one_item(nodes_[id].job, job)) continue;
        ready_.erase(place_of(id));
        finish(id);
        ++count;
    }
    return count;
}

}
