// Buffers that are listed once: what is foretold of them is what they take.
#include "host/device/needed_buffers.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

struct Buffers
{
    Buffer<std::uint32_t> words;
    Buffer<double> values;

    NeededBuffers needed(std::size_t count) { return {{words, 3 * count}, {values, count}}; }
};

TEST(NeededBuffers, TakeWhatIsForetold)
{
    const DeviceMemory foretold = memory_of(Buffers{}.needed(1000));
    EXPECT_EQ(foretold, (DeviceMemory{12'000, 20'000}));
    Device device = Device::open();
    const std::uint64_t before = device.memory().total;
    Buffers buffers;
    reserve(device, buffers.needed(1000));
    EXPECT_EQ(device.memory().total - before, foretold.total);
}

TEST(NeededBuffers, KeepBuffersThatAreLargeEnough)
{
    Device device = Device::open();
    Buffers buffers;
    reserve(device, buffers.needed(10));
    buffers.words.write(std::vector<std::uint32_t>(30, 7));
    buffers.values = {};
    reserve(device, buffers.needed(9));
    EXPECT_EQ(buffers.words.read(29, 1).at(0), 7u);
    EXPECT_EQ(buffers.values.size(), 9);
}

}
}
