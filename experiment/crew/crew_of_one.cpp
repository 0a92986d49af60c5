#include "experiment/crew/crew.hpp"

#include "base/programs/interrupt.hpp"

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

}

std::unique_ptr<Crew> make_crew_of_one() { return std::make_unique<CrewOfOne>(); }

}
