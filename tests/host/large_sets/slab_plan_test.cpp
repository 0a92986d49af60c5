// Sets are divided into slabs by what processes share, of devices that this machine need not have.
#include "host/large_sets/slab_relaxation.hpp"

#include <gmock/gmock.h>

namespace poissonlab {
namespace {

constexpr std::uint64_t points = 1'000'000;

DeviceInfo graphics_card(std::uint64_t bytes)
{
    DeviceInfo device;
    device.name = "card";
    device.type = "GPU";
    device.global_memory_bytes = bytes;
    device.max_allocation_bytes = bytes;
    return device;
}

SlabPlan plan_on(const DeviceInfo& device, std::uint32_t processes, std::uint32_t processes_here)
{
    return plan_slabs(*lloyd_in_slabs(2, points),
                      {.points = points,
                       .processes = processes,
                       .processes_here = processes_here,
                       .most_slab_bytes = std::uint64_t{1} << 40},
                      device);
}

/// A card that has room for the set of one process and not for two halves with what is around them.
TEST(SlabPlan, DividesTheMemoryOfACardBetweenProcesses)
{
    const std::uint64_t whole = plan_on(graphics_card(std::uint64_t{1} << 40), 1, 1).slab_bytes;
    const DeviceInfo card = graphics_card(whole);
    EXPECT_EQ(plan_on(card, 1, 1).slabs, 1u);
    EXPECT_EQ(plan_on(card, 2, 1).slabs, 1u) << "a card each";
    EXPECT_EQ(plan_slabs(
                  *lloyd_in_slabs(2, points),
                  {.points = points, .processes = 2, .least_slabs = 3, .most_slab_bytes = std::uint64_t{1} << 40}, card)
                  .slabs,
              3u)
        << "as many as another process needs";
    const SlabPlan shared = plan_on(card, 2, 2);
    EXPECT_GT(shared.slabs, 1u);
    EXPECT_LE(2 * shared.slab_bytes, whole);
}

}
}
