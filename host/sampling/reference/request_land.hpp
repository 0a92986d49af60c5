// The region of a request for points in the plane or in space, by its dimension.
#pragma once

namespace poissonlab::reference {

/// A pointer that is empty where points lie anywhere.
template <int D, typename Request>
const auto& land_of(const Request& request)
{
    if constexpr (D == 2)
        return request.region;
    else
        return request.space;
}

}
