#include "host/kinds/kinds.hpp"

#include <algorithm>

namespace poissonlab {
namespace {

std::vector<Kind> listed_kinds()
{
    std::vector<Kind> all{tile_set_picture_kind(), tiling_kind()};
    std::ranges::move(construction_kinds(), std::back_inserter(all));
    for (Kind (*const kind)() : {warp_kind,
                                 object_kind,
                                 self_similar_kind,
                                 rank_kind,
                                 dart_kind,
                                 region_point_kind,
                                 class_kind,
                                 surface_point_kind,
                                 sampling_mask_kind,
                                 dither_mask_kind,
                                 cell_kind,
                                 stippling_kind,
                                 hatching_kind,
                                 icon_kind,
                                 instance_kind,
                                 corner_problem_kind,
                                 scanline_steps_kind,
                                 direct_scheme_kind,
                                 noise_kind,
                                 tiling_cost_kind,
                                 lattice_construction_kind,
                                 aperiodic_table_kind,
                                 diffraction_kind,
                                 isohedral_kind,
                                 surface_kind,
                                 texture_kind,
                                 packing_kind,
                                 printed_tiling_kind,
                                 printed_packing_kind,
                                 tile_set_kind,
                                 texture_set_kind,
                                 endless_kind})
        all.push_back(kind());
    return all;
}

}

const std::vector<Kind>& all_kinds()
{
    static const std::vector<Kind> all = listed_kinds();
    return all;
}

const Kind* find_kind(const std::string& table, const std::string& word)
{
    const auto& all = all_kinds();
    const auto found =
        std::ranges::find_if(all, [&](const Kind& kind) { return kind.table == table && kind.word == word; });
    return found == all.end() ? nullptr : &*found;
}

std::vector<std::string> kind_words(const std::string& table)
{
    std::vector<std::string> words;
    for (const Kind& kind : all_kinds())
        if (kind.table == table) words.push_back(kind.word);
    return words;
}

}
