// The words of HLSL that runtime/poisson_tiles_gpu.h uses, as C++: its text is then a function of this program.
// Integers wrap and floats round as Direct3D and Vulkan want them for what is `precise`.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace poissonlab::hlsl {

using uint = std::uint32_t;

struct int3
{
    int x = 0, y = 0, z = 0;
    int3() = default;
    int3(int i, int j, int k) : x(i), y(j), z(k) {}
    int3 operator+(const int3& o) const { return {wrapped(x, o.x), wrapped(y, o.y), wrapped(z, o.z)}; }

private:
    static int wrapped(int a, int b) { return static_cast<int>(static_cast<uint>(a) + static_cast<uint>(b)); }
};

struct float3
{
    float x = 0, y = 0, z = 0;
    float3() = default;
    float3(float a, float b, float c) : x(a), y(b), z(c) {}
};

inline const uint* ptiles_words = nullptr; ///< StructuredBuffer<uint>

inline float max(float a, float b) { return std::max(a, b); }
inline float min(float a, float b) { return std::min(a, b); }
inline float sqrt(float a) { return std::sqrt(a); }

}
