// Buffers that are listed once: what is foretold of them is what they take.
#include "host/device/needed_buffers.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

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

/// Problems without points go to the same kernels as others.
TEST(NeededBuffers, AreThereWhereNothingIsNeeded)
{
    Device device = Device::open();
    auto kernel =
        device.kernel_from_text("kernel void count(uint words, global uint* word, global double* value, global "
                                "uint* total) { if (words == 0) *total = 7; else word[0] = *value; }",
                                "count.cl", "count");
    Buffers buffers;
    reserve(device, buffers.needed(0));
    auto total = device.buffer<std::uint32_t>(1);
    kernel.run(1, 1, std::uint32_t{0}, buffers.words, buffers.values, total);
    EXPECT_EQ(total.read(0, 1).at(0), 7u);
    EXPECT_EQ(buffers.words.size(), 0u);
}

TEST(NeededBuffers, AreRefusedWhereTheyWereForgotten)
{
    Device device = Device::open();
    auto kernel = device.kernel_from_text("kernel void none(global uint* word) {}", "none.cl", "none");
    Buffers buffers;
    EXPECT_THROW(kernel.run(1, 1, buffers.words), std::logic_error);
    EXPECT_THROW(buffers.words.read(0, 1), std::logic_error);
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
