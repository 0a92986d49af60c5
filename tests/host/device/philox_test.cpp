// Philox4x32-10 on host and device against the vectors published with Random123 (its file kat_vectors).
#include "base/random/random.hpp"
#include "host/device/device.hpp"
#include "host/device/kernel_source.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

using Words = std::array<std::uint32_t, 4>;

struct Vector
{
    Words counter;
    StreamKey key;
    Words expected;
};

const Vector published[] = {
    {{0, 0, 0, 0}, {0, 0}, {0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}},
    {{0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff},
     {0xffffffff, 0xffffffff},
     {0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}},
    {{0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344},
     {0xa4093822, 0x299f31d0},
     {0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}},
};

/// Runs kernels/common/philox.clh on counters and keys of six words each.
std::vector<std::uint32_t> philox_on_device(const std::vector<std::uint32_t>& inputs)
{
    Device device = Device::open();
    const std::string text = kernel_source("kernels/common/philox.clh") + R"(
        kernel void words(global const uint* in, global uint* out, uint count) {
            const uint id = get_global_id(0);
            if (id >= count) return;
            vstore4(philox(vload4(0, in + 6 * id), vload2(0, in + 6 * id + 4)), id, out);
        })";
    const std::size_t count = inputs.size() / 6;
    auto in = device.buffer<std::uint32_t>(inputs.size());
    auto out = device.buffer<std::uint32_t>(4 * count);
    in.write(inputs);
    device.kernel_from_text(text, "philox_test.cl", "words").run(count, 64, in, out, static_cast<std::uint32_t>(count));
    return out.read(0, 4 * count);
}

TEST(Philox, HostGivesThePublishedVectors)
{
    for (const Vector& v : published) EXPECT_EQ(philox(v.counter, v.key), v.expected);
}

TEST(Philox, DeviceGivesThePublishedVectors)
{
    std::vector<std::uint32_t> inputs;
    for (const Vector& v : published) {
        inputs.insert(inputs.end(), v.counter.begin(), v.counter.end());
        inputs.insert(inputs.end(), v.key.begin(), v.key.end());
    }
    const auto words = philox_on_device(inputs);
    for (std::size_t i = 0; i < std::size(published); ++i) {
        for (std::size_t w = 0; w < 4; ++w) EXPECT_EQ(words[4 * i + w], published[i].expected[w]) << i << " " << w;
    }
}

TEST(Philox, DeviceGivesWhatRandom123GivesForManyCounters)
{
    constexpr std::size_t count = 100'000;
    std::vector<std::uint32_t> inputs;
    for (std::uint32_t i = 0; i < count; ++i) {
        for (std::uint32_t w = 0; w < 6; ++w) inputs.push_back((i * 6 + w) * 2654435761u);
    }
    const auto words = philox_on_device(inputs);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t* in = &inputs[6 * i];
        const Words expected = philox({in[0], in[1], in[2], in[3]}, {in[4], in[5]});
        const Words found = {words[4 * i], words[4 * i + 1], words[4 * i + 2], words[4 * i + 3]};
        ASSERT_EQ(found, expected) << i;
    }
}

TEST(StreamKey, DiffersWithEverythingItIsMadeFrom)
{
    const StreamKey key = stream_key(1, Purpose::dart_throwing, 0);
    EXPECT_EQ(key, stream_key(1, Purpose::dart_throwing, 0));
    EXPECT_NE(key, stream_key(2, Purpose::dart_throwing, 0));
    EXPECT_NE(key, stream_key(1ull << 32 | 1, Purpose::dart_throwing, 0));
    EXPECT_NE(key, stream_key(1, Purpose::random_points, 0));
    EXPECT_NE(key, stream_key(1, Purpose::dart_throwing, 1));
    EXPECT_NE(key, stream_key(1, Purpose::dart_throwing, 0, 1));
}

}
}
