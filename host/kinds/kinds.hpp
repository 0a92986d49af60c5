// All kinds of work that are described by their keys.
#pragma once

#include "host/kinds/kind.hpp"

#include <string>
#include <vector>

namespace poissonlab {

/// All kinds, in the order in which messages and the documentation list them; host/modules has what modules bring.
const std::vector<Kind>& all_kinds();

/// The kind of a table with this word; null where there is none. Throws MissingModule where only a module has it that
/// this program lacks.
const Kind* find_kind(const std::string& table, const std::string& word);

/// The words for the key `kind` of a table, the default first.
std::vector<std::string> kind_words(const std::string& table);

// Each is in a file beside what it makes: in host/scenes, host/distribution/runs, host/schemes and host/texture.
Kind tile_set_picture_kind();
Kind tiling_kind();
std::vector<Kind> construction_kinds();
Kind warp_kind();
Kind object_kind();
Kind self_similar_kind();
Kind rank_kind();
Kind dart_kind();
Kind region_point_kind();
Kind class_kind();
Kind surface_point_kind();
Kind sampling_mask_kind();
Kind dither_mask_kind();
Kind cell_kind();
Kind stippling_kind();
Kind hatching_kind();
Kind icon_kind();
Kind instance_kind();
Kind corner_problem_kind();
Kind scanline_steps_kind();
Kind direct_scheme_kind();
Kind noise_kind();
Kind tiling_cost_kind();
Kind lattice_construction_kind();
Kind aperiodic_table_kind();
Kind diffraction_kind();
Kind isohedral_kind();
Kind substitution_kind();
Kind periodic_kind();
Kind brick_kind();
Kind surface_kind();
Kind texture_kind();
Kind textured_surface_kind();
Kind surface_object_kind();
Kind packing_kind();

// Kinds that commands and Python make, but no table.
Kind printed_tiling_kind();
Kind printed_packing_kind();
Kind tile_set_kind();
Kind texture_set_kind();
Kind endless_kind();

}
