#include "host/sampling/slabs/slab_division.hpp"

namespace poissonlab {

std::vector<std::vector<std::uint32_t>> SlabDivision::slabs_around_layers(std::uint32_t around) const
{
    std::vector<std::vector<std::uint32_t>> slabs_of(cells_per_axis_);
    for (std::uint32_t slab = 0; slab < slabs_; ++slab) {
        const std::uint32_t first = first_layer(slab);
        const std::uint32_t end = first_layer(slab + 1);
        if (first == end) continue;
        const std::uint64_t others =
            std::min<std::uint64_t>(cells_per_axis_ - (end - first), std::uint64_t{2} * around);
        // Layers behind the slab come first, then, around the torus, layers before it.
        const std::uint64_t behind = std::min<std::uint64_t>(others, around);
        for (std::uint64_t i = 0; i < others; ++i) {
            const std::uint64_t layer = i < behind ? end + i : first + cells_per_axis_ - 1 - (i - behind);
            slabs_of[layer % cells_per_axis_].push_back(slab);
        }
    }
    return slabs_of;
}

}
