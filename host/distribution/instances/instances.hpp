// Instances of models at the points of a tiling: forests, fields of sunflowers, belts of asteroids.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 7.5, figures 7.5 and 7.6; Cohen and others, Wang tiles
// for image and texture generation, 2003, figure 10. Neither says rules: here all that an instance is follows from its
// point's identity by hashes, each with its own purpose, so that windows in parts and at once have the same instances.
#pragma once

#include "base/densities/density_values.hpp"
#include "host/device/needed_buffers.hpp"
#include "host/distribution/objects.hpp"
#include "host/kinds/distribution_place.hpp"
#include "host/settings/distributions/distribution_config.hpp"
#include "kernels/common/fields/instances.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace poissonlab {

struct Instance
{
    std::array<double, 3> position{}; ///< units; z from the terrain, or in a belt
    std::uint32_t model = 0;
    double turn = 0;           ///< about z, radians
    double scale = 1;          ///< of a model that fits a disk of instance_radius()
    double tilt = 0;           ///< from z, radians
    double tilt_direction = 0; ///< about z, radians
    std::array<std::int32_t, 3> tile{};
    std::uint32_t index = 0;                 ///< in the tile; with it, what tells instances apart
    std::uint32_t id = 0;                    ///< random bits, of which some 65,000 instances share some
    std::optional<std::uint32_t> of_class{}; ///< of its point, where the tiles have classes

    bool operator==(const Instance&) const = default;
};

/// Heights over an area; beyond it, those of its border. Between the middles of pixels they are linear.
class Terrain
{
public:
    /// Throws InputError for what cannot be read and heights that are not finite.
    explicit Terrain(const InstanceSettings& settings);

    /// The height at a place, in units.
    double at(double x, double y) const;

private:
    PixelValues heights_;
    std::array<double, 4> area_;
    double scale_;
};

/// The terrain of settings; none: flat.
std::optional<Terrain> terrain_of(const InstanceSettings& settings);

/// Dimension of a scene's tiles: 3 for asteroids.
int instance_dimension(const InstanceSettings& settings);

inline constexpr std::uint32_t most_models = 65'536;
inline constexpr double most_tilt = 1.5;      ///< radians
inline constexpr double most_instances = 1e6; ///< in a window

/// The scenes that instances are for, the default first.
const std::vector<std::string>& instance_scenes();

/// Densities, models and looks of a scene, over one unit square.
InstanceSettings scene_settings(const std::string& scene);

/// Throws InputError, a sentence, where settings ask for more instances than a file should hold, or have a ring that is
/// none.
void check_instances(const InstanceSettings& settings);

/// The radius of the disks or spheres that do not overlap, in units.
double instance_radius(const ObjectTileSet& tiles, const InstanceSettings& settings);

/// Tiles a unit: D 7.6.2.2, where the text has its inverse.
double tiles_a_unit(const ObjectTileSet& tiles, const InstanceSettings& settings);

/// A box around all instances, in tiles: half a tile larger to each side, so that positions in units decide, the same
/// for all windows. Low is not below high where there can be none.
struct InstanceBox
{
    std::array<double, 3> low{}, high{};

    bool is_empty() const { return low[0] >= high[0] || low[1] >= high[1]; }
};
InstanceBox instance_box(const ObjectTileSet& tiles, const InstanceSettings& settings);

namespace reference {
/// The plain twin of InstancePlacer::place().
std::vector<Instance> place_instances(const ObjectTileSet& tiles, const PoissonTiling& tiling,
                                      const InstanceSettings& settings);
}

/// Tells instances the classes of their points, if these have any. Each class has models of its own: the number of a
/// model modulo the number of classes is the class. Throws InputError for fewer models than classes.
void set_classes(std::vector<Instance>& instances, const TileClasses& classes, const InstanceSettings& settings);

/// The instances with a position in the window, x and y from its lowest corner on, and in the ring where the scene has
/// one, on the terrain; by rows of tiles. Throws InputError for windows so thin that the tiles around them have far
/// more points, and Interrupted.
std::vector<Instance> instances_in(const ObjectTileSet& tiles, const PoissonTiling& tiling,
                                   const InstanceSettings& settings, const DistributionPlace& place);

/// The number of instances on average.
double expected_instances(const InstanceSettings& settings);

// Instances made on a device.

/// Places instances by kernels/instances.cl, bit for bit as the reference does. The tile set is copied to the device
/// once.
class InstancePlacer
{
public:
    /// `work_group_size` 0: the default. The tile set must outlive this.
    InstancePlacer(Device device, const ObjectTileSet& tiles, std::size_t work_group_size = 0);

    static DeviceMemory memory(const ObjectTileSet& tiles);

    /// The instances in the window and the ring, by rows of tiles; on the plane, z is 0. Throws Interrupted.
    std::vector<Instance> place(const PoissonTiling& tiling, const InstanceSettings& settings);

private:
    struct Buffers
    {
        Buffer<std::uint32_t> words;
        Buffer<contract::instances::PlacedInstance> instances;

        NeededBuffers needed(const PoissonTileSet& tiles);
    };

    Device device_;
    const ObjectTileSet& tiles_;
    std::size_t work_group_size_;
    Buffers buffers_;
    Kernel place_;
};

}
