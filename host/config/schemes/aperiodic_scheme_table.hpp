// The kinds of [[scheme]] that are about aperiodic sets, isohedral tilings and surfaces.
#pragma once

#include "host/config/schemes/scheme_table.hpp"

namespace poissonlab {

SchemeChoice read_construction_scheme(const ConfigTable& table, std::uint64_t seed);
SchemeChoice read_aperiodic_tables(const ConfigTable& table, std::uint64_t seed);
SchemeChoice read_diffraction(const ConfigTable& table, std::uint64_t seed);
SchemeChoice read_isohedral(const ConfigTable& table, std::uint64_t seed);
SchemeChoice read_surface(const ConfigTable& table, std::uint64_t seed);

/// The tile that the settings say. Throws InputError for parameters that it cannot have.
IsohedralTile tile_of(const IsohedralSettings& settings, std::uint64_t seed);

}
