// Filling tori of two tiles a side with points of several classes around those that are there already.
//
// Wei, Multi-class blue noise sampling, SIGGRAPH 2010: a distance for each pair of classes. Darts are thrown class
// after class, the class of the largest distance first, at distances that are reduced all together while points do not
// fit (relaxation dart throwing); then points that are too near for their classes are pushed apart, sliding along the
// borders of their regions, as points without classes are in tile_filling.hpp.
#pragma once

#include "host/device/device.hpp"
#include "host/tile_construction/filling/tile_filling.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace poissonlab {

/// Points class after class.
using ClassedPositions = std::vector<std::vector<TilePosition>>;

std::size_t point_count(const ClassedPositions& points);

/// Points in one list, class after class, with their class as third coordinate.
std::vector<TilePosition> with_classes(const ClassedPositions& points);

/// The inverse of with_classes(); points of a class stay in their order.
ClassedPositions by_class(std::span<const TilePosition> points, std::size_t classes);

/// The part of the squared distances that are asked for, all of it, in the units that parts are counted in.
inline constexpr std::uint32_t whole_part = 1U << 16;

struct ClassFillSettings
{
    std::vector<std::uint32_t> wanted; ///< squared distances, a row of all classes for each class
    std::vector<double> pushed;        ///< nearer points are pushed apart, in the same order; units
    std::vector<std::uint32_t> parts;  ///< of the squared distances, that darts keep one after the other
    std::vector<std::uint32_t> order;  ///< of classes, in which darts are thrown
    std::uint32_t attempts = 0;        ///< failed darts in a row before the next part
    std::uint32_t passes = 0;          ///< of pushing, at most
    StreamKey stream{};

    std::size_t classes() const { return order.size(); }
};

ClassFillSettings class_fill_settings(const PoissonTileParameters& parameters);

struct ClassFillProblem
{
    ClassedPositions held;
    std::vector<std::uint32_t> active; ///< points of each class that are wanted
    std::uint32_t stream = 0;          ///< of random numbers

    std::uint32_t active_points() const;
};

struct ClassFilledTorus
{
    ClassedPositions active;
    std::uint32_t part = 0; ///< of the wanted squared distances that active points keep; 0: they did not fit

    bool is_good() const { return part >= whole_part; }
    bool operator==(const ClassFilledTorus&) const = default;
};

class ClassTileFiller
{
public:
    virtual ~ClassTileFiller() = default;

    /// Fills the active zone of the stage; it has no surroundings. `attempt`: every one has its own random numbers.
    virtual std::vector<ClassFilledTorus> fill(const FillStage& stage, std::span<const ClassFillProblem> problems,
                                               std::uint32_t attempt) = 0;
};

namespace reference {
std::unique_ptr<ClassTileFiller> make_class_tile_filler(const ClassFillSettings& settings);
}

/// Makes a filler by kernels/class_tiles.cl, a work-group a torus; it has the results of the reference.
/// `work_group_size` 0: the default, at most 256.
std::unique_ptr<ClassTileFiller> make_class_tile_filler(const ClassFillSettings& settings, Device device,
                                                        std::size_t work_group_size = 0);

/// The memory that this takes for so many tori at once, each with so many points at most.
DeviceMemory class_filling_memory(std::size_t classes, std::size_t tori, std::size_t points);

}
