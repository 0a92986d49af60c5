// Singular and plural in sentences with numbers.
#pragma once

#include <cstdint>
#include <string>

namespace poissonlab {

/// "point" for 1, "points" for every other number; `many` where that is no s at the end.
inline std::string noun(std::uint64_t count, const std::string& one, const std::string& many = {})
{
    return count == 1 ? one : many.empty() ? one + "s" : many;
}

}
