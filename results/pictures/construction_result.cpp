#include "results/pictures/construction_result.hpp"

#include "base/files/json_members.hpp"

namespace poissonlab {
namespace {

void describe(JsonMembers& m, Stored<ConstructionResult> auto& construction)
{
    m.folder_name("name", construction.name);
    m.member("label", construction.label);
    m.member("kind", construction.kind);
    m.member("show", construction.show);
    m.member("colors", construction.colors, 1);
    m.member("tiles", construction.tiles, 1);
    m.member("points_per_tile", construction.points_per_tile, 1);
    m.member("relative_radius", construction.relative_radius);
    m.member("filling", construction.filling);
    m.member("lloyd_iterations", construction.lloyd_iterations);
    m.member("repulsion", construction.repulsion);
    m.json("seed", construction.seed);
    m.file_name("file", construction.file);
    m.if_any("panels", construction.scene.panels);
    m.group("points", [&](JsonMembers& points) {
        for (const PointClass kind : stored_point_classes)
            points.if_any(name_of(kind), construction.scene.points[static_cast<std::size_t>(kind)]);
    });
}

}

void members(JsonMembers& m, const ConstructionResult& construction) { describe(m, construction); }
void members(JsonMembers& m, ConstructionResult& construction) { describe(m, construction); }

}
