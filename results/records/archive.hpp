// Records of samplers as bytes, see base/files/byte_archive.hpp.
#pragma once

#include "base/files/byte_archive.hpp"
#include "results/records/sample_records.hpp"

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

}
