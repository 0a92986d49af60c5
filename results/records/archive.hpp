// Archives by cereal of the laboratory's units of work: binary, exact, for this program's own use.
//
// Only programs built from the same sources read it again, see cmake/code_versions.cmake: there are no versions here.
#pragma once

#include "results/records/sample_records.hpp"

#include <cereal/archives/binary.hpp>
#include <cereal/types/array.hpp>
#include <cereal/types/optional.hpp>
#include <cereal/types/string.hpp>
#include <cereal/types/tuple.hpp>
#include <cereal/types/vector.hpp>

#include <sstream>
#include <string>

namespace poissonlab {

template <class Archive>
void serialize(Archive& archive, IterationRecord& record)
{
    archive(record.relative_radius, record.energy, record.relative_radius_within_tiles);
}

template <class Archive>
void serialize(Archive& archive, TileSetBuild& build)
{
    archive(build.seconds, build.device, build.threads);
}

template <class Archive>
void serialize(Archive& archive, RegionPoints& points)
{
    archive(points.name, points.points, points.expected);
}

template <class Archive>
void serialize(Archive& archive, TileSetRecord& record)
{
    archive(record.tiles, record.points_per_tile, record.cached, record.build, record.regions, record.shared_points);
}

/// The bytes of a value.
template <class T>
std::string to_bytes(const T& value)
{
    std::ostringstream stream;
    cereal::BinaryOutputArchive archive(stream);
    archive(value);
    return std::move(stream).str();
}

/// Fills a value from what to_bytes() made of one of its type. Throws cereal::Exception where bytes are missing.
template <class T>
void from_bytes(const std::string& bytes, T& value)
{
    std::istringstream stream(bytes);
    cereal::BinaryInputArchive archive(stream);
    archive(value);
}

}
