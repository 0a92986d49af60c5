// The settings of each scene, and the limit on how many instances a file should hold.
#include "base/errors/errors.hpp"
#include "host/distribution/instances/instances.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace poissonlab {

const std::vector<std::string>& instance_scenes()
{
    static const std::vector<std::string> scenes{"forest", "sunflowers", "asteroids"};
    return scenes;
}

InstanceSettings scene_settings(const std::string& scene)
{
    using Kind = SpreadChoice::Kind;
    InstanceSettings settings;
    settings.scene = scene;
    if (scene == "forest") {
        settings.density = 2000;
        settings.models = 5;
        settings.scale = {Kind::uniform, 0.7, 1};
        settings.tilt = 0.06;
    } else if (scene == "sunflowers") {
        settings.density = 500;
        settings.models = 11;
        settings.scale = {Kind::uniform, 0.8, 1};
        settings.tilt = 0.25;
    } else {
        settings.density = 40'000;
        settings.models = 8;
        settings.scale = {Kind::uniform, 0.3, 1};
        settings.tilt = most_tilt;
        settings.window = {-1, -1, 2, 2};
        settings.ring = {0.55, 0.95, 0.08};
    }
    return settings;
}

void check_instances(const InstanceSettings& settings)
{
    const auto& [inner, outer, thickness] = settings.ring;
    const bool is_belt = settings.scene == "asteroids";
    if (is_belt && !(inner >= 0 && outer > inner && thickness > 0))
        throw InputError(fmt::format("a ring from {} to {} that is {} thick: must be [inner, outer, thickness] with "
                                     "0 <= inner < outer and thickness > 0",
                                     inner, outer, thickness));
    const double box = settings.window[2] * settings.window[3];
    const double ring = std::numbers::pi * outer * outer;
    const double size = is_belt ? std::min(box, ring) * thickness : box;
    if (settings.density * size > most_instances)
        throw InputError(fmt::format("{:.0f} instances in the window: must be at most {:.0f}", settings.density * size,
                                     most_instances));
}

}
