#include "host/distribution/instances/instance_files.hpp"

#include <fmt/format.h>

#include <cmath>

namespace poissonlab {
namespace {

/// The shape that stands for a model, as high as its number says.
std::string stand_in(const InstanceSettings& settings, std::uint32_t model, double radius)
{
    if (settings.scene == "asteroids")
        return fmt::format(
            "            def Sphere \"Rock\"\n            {{\n                double radius = {}\n            }}\n",
            radius);
    const double height = height_of_stand_in(settings, model) * radius;
    return fmt::format("            def Cone \"Plant\"\n            {{\n                double height = {}\n"
                       "                double radius = {}\n                token axis = \"Z\"\n"
                       "                double3 xformOp:translate = (0, 0, {})\n"
                       "                uniform token[] xformOpOrder = [\"xformOp:translate\"]\n            }}\n",
                       height, radius, height / 2);
}

/// A list of all instances, `text` of each.
template <class Text>
std::string listed(const std::vector<Instance>& instances, Text text)
{
    std::string all;
    for (const Instance& instance : instances) {
        if (!all.empty()) all += ", ";
        all += text(instance);
    }
    return all;
}

bool have_classes(const std::vector<Instance>& instances)
{
    return !instances.empty() && instances.front().of_class.has_value();
}

/// The class after a separator; nothing where there is none.
std::string class_text(const Instance& instance, char separator)
{
    return instance.of_class ? fmt::format("{}{}", separator, *instance.of_class) : "";
}

}

std::array<double, 4> orientation_of(const Instance& i)
{
    const double c = std::cos(i.tilt / 2), s = std::sin(i.tilt / 2), w = std::cos(i.turn / 2), z = std::sin(i.turn / 2);
    const double ax = -std::sin(i.tilt_direction) * s, ay = std::cos(i.tilt_direction) * s;
    return {c * w, ax * w + ay * z, ay * w - ax * z, c * z};
}

double height_of_stand_in(const InstanceSettings& settings, std::uint32_t model)
{
    return (settings.scene == "forest" ? 3 : 1.5) * (1 + 0.5 * model / settings.models);
}

std::string instances_csv(const std::vector<Instance>& instances)
{
    std::string text = "x,y,z,model,turn,scale,tilt,tilt_direction,tile_x,tile_y,tile_z,index";
    text += have_classes(instances) ? ",class\n" : "\n";
    for (const Instance& i : instances)
        text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}{}\n", i.position[0], i.position[1], i.position[2],
                            i.model, i.turn, i.scale, i.tilt, i.tilt_direction, i.tile[0], i.tile[1], i.tile[2],
                            i.index, class_text(i, ','));
    return text;
}

std::string instances_ply(const std::vector<Instance>& instances)
{
    std::string text = fmt::format("ply\nformat ascii 1.0\nelement vertex {}\n", instances.size());
    for (const char* name : {"x", "y", "z", "turn", "scale", "tilt", "tilt_direction"})
        text += fmt::format("property double {}\n", name);
    for (const char* name : {"tile_x", "tile_y", "tile_z"}) text += fmt::format("property int {}\n", name);
    text += "property uint index\nproperty uint model\n";
    text += have_classes(instances) ? "property uint class\nend_header\n" : "end_header\n";
    for (const Instance& i : instances)
        text += fmt::format("{} {} {} {} {} {} {} {} {} {} {} {}{}\n", i.position[0], i.position[1], i.position[2],
                            i.turn, i.scale, i.tilt, i.tilt_direction, i.tile[0], i.tile[1], i.tile[2], i.index,
                            i.model, class_text(i, ' '));
    return text;
}

std::string instances_usda(const std::vector<Instance>& instances, const InstanceSettings& settings, double radius)
{
    std::string prototypes, bodies;
    for (std::uint32_t model = 0; model < settings.models; ++model) {
        prototypes += fmt::format("{}</Instances/Prototypes/Model_{}>", model == 0 ? "" : ", ", model);
        bodies += fmt::format("        def Xform \"Model_{}\"\n        {{\n{}        }}\n", model,
                              stand_in(settings, model, radius));
    }
    std::string text = "#usda 1.0\n(\n    defaultPrim = \"Instances\"\n    upAxis = \"Z\"\n)\n\n"
                       "def PointInstancer \"Instances\"\n{\n    rel prototypes = [" +
                       prototypes + "]\n    int[] protoIndices = [";
    text += listed(instances, [](const Instance& i) { return fmt::format("{}", i.model); });
    text += "]\n    point3f[] positions = [";
    text += listed(instances, [](const Instance& i) {
        return fmt::format("({}, {}, {})", i.position[0], i.position[1], i.position[2]);
    });
    text += "]\n    quath[] orientations = [";
    text += listed(instances, [](const Instance& i) {
        const auto [w, x, y, z] = orientation_of(i);
        return fmt::format("({:.5f}, {:.5f}, {:.5f}, {:.5f})", w, x, y, z);
    });
    text += "]\n    float3[] scales = [";
    text += listed(instances, [](const Instance& i) { return fmt::format("({0}, {0}, {0})", i.scale); });
    return text + "]\n\n    def Scope \"Prototypes\"\n    {\n" + bodies + "    }\n}\n";
}

}
