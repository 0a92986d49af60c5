#include "app/commands/tiles/tile_points_work.hpp"

#include "app/commands/output_file.hpp"
#include "base/errors/errors.hpp"
#include "base/points/hdf5_points.hpp"
#include "base/regions/region_text.hpp"
#include "host/distribution/classes/class_files.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace poissonlab {
namespace {

TileBlock checked_window(const std::vector<std::int64_t>& numbers, int dimension)
{
    const std::string option = fmt::format("tiles points: --window {}", fmt::join(numbers, " "));
    const auto axes = static_cast<std::size_t>(dimension);
    if (numbers.size() != 2 * axes)
        throw InputError(fmt::format("{}: must be {}", option, dimension == 3 ? "X Y Z W H D" : "X Y W H"));
    TileBlock block;
    for (std::size_t axis = 0; axis < axes; ++axis) {
        const std::int64_t size = numbers[axes + axis];
        if (numbers[axis] < INT32_MIN || numbers[axis] > INT32_MAX || size < 1 || size > UINT32_MAX)
            throw InputError(option + ": places have 32 bits, and sizes are at least 1 tile");
        block.lowest[axis] = static_cast<std::int32_t>(numbers[axis]);
        block.size[axis] = static_cast<std::uint32_t>(size);
    }
    check(block, dimension);
    return block;
}

/// The whole torus.
TileBlock torus_block(std::uint32_t tiles, int dimension)
{
    TileBlock block;
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis) block.size[axis] = tiles;
    return block;
}

TileBlock checked_block(const TilesPointsOptions& options, int dimension)
{
    return options.torus > 0 ? torus_block(options.torus, dimension) : checked_window(options.window, dimension);
}

/// Throws InputError that names --crs where it is wrong, which is no fault of the region.
void check_crs(const std::string& crs)
{
    try {
        if (!crs.empty()) check_map_system(crs);
    } catch (const InputError& error) {
        throw InputError(fmt::format("tiles points: --crs {}", error.what()));
    }
}

/// Particles are in cubes.
void check_particles(const TilesPointsOptions& options, const TileBlock& block, const PointFileHead& head)
{
    check_head(options.out, head);
    if (is_particle_file(options.out) && (block.size[0] != block.size[1] || block.size[0] != block.size[2]))
        throw InputError(
            fmt::format("tiles points: --out {}: particles are in a cube: --window must have as many tiles "
                        "along each axis",
                        printable(options.out.string())));
}

/// Files of points with classes have formats of their own.
OutputFormats class_formats() { return {class_file_ends()}; }

void check_class_target(const std::filesystem::path& out)
{
    const std::string ending = output_name(out, class_formats()).extension();
    if (std::ranges::find(class_file_ends(), ending) == class_file_ends().end())
        throw InputError(fmt::format("tiles points: --out {}: the points of these tiles have classes: must end in {}",
                                     printable(out.string()), fmt::join(class_file_ends(), ", ")));
}

}

void check_region_options(const TilesPointsOptions& options, int dimension)
{
    if (options.region.empty()) {
        for (const auto& [name, is_given] : {std::pair("--planar", options.reading.is_planar),
                                             {"--crs", !options.reading.crs.empty()},
                                             {"--overlap", !options.overlap.empty()},
                                             {"--buffer", options.reading.buffer != 0},
                                             {"--min-distance", options.min_distance != 0},
                                             {"--points", options.points != 0}})
            if (is_given) throw InputError(fmt::format("tiles points: {}: needs --region", name));
        return;
    }
    if (dimension != 2) throw InputError("tiles points: --region: tiles in space have no plane region");
    if ((options.min_distance == 0) == (options.points == 0))
        throw InputError("tiles points: --region: needs --min-distance or --points, and not both");
    if (options.min_distance != 0 && !(options.min_distance >= 1e-12 && options.min_distance <= 1e12))
        throw InputError(
            fmt::format("tiles points: --min-distance {}: must be from 1e-12 to 1e12", options.min_distance));
    if (options.reading.is_planar && !options.reading.crs.empty())
        throw InputError("tiles points: --crs: cannot be combined with --planar");
    if (!(options.reading.buffer >= 0 && options.reading.buffer <= 1e12))
        throw InputError(fmt::format("tiles points: --buffer {}: must be from 0 to 1e12", options.reading.buffer));
    if (!options.overlap.empty() && !polygon_overlap_names.find(options.overlap))
        throw InputError(
            fmt::format("tiles points: --overlap {}: must be union or refuse", printable(options.overlap)));
}

std::string comment_of(const TilesPointsOptions& options, const std::string& coordinates)
{
    std::vector<std::string> words{file_word(options.file.string())};
    const auto add = [&](bool is_given, const char* option, const std::string& value) {
        if (!is_given) return;
        words.emplace_back(option);
        if (!value.empty()) words.push_back(value);
    };
    add(!options.window.empty(), "--window", "");
    for (const std::int64_t number : options.window) words.push_back(std::to_string(number));
    add(options.torus > 0, "--torus", std::to_string(options.torus));
    add(!options.region.empty(), "--region", options.region);
    add(options.reading.is_planar, "--planar", "");
    add(!options.reading.crs.empty(), "--crs", options.reading.crs);
    add(!options.overlap.empty(), "--overlap", options.overlap);
    add(options.reading.buffer > 0, "--buffer", fmt::format("{}", options.reading.buffer));
    add(options.min_distance > 0, "--min-distance", fmt::format("{}", options.min_distance));
    add(options.points > 0, "--points", std::to_string(options.points));
    add(options.density != "1", "--density", options.density);
    add(options.density_from != "light", "--density-from", options.density_from);
    return command_comment("tiles points", words, options.seed, coordinates);
}

PlaneRegion read_points_region(const TilesPointsOptions& options)
{
    check_crs(options.reading.crs);
    RegionReading reading = options.reading;
    if (!options.overlap.empty()) reading.overlap = *polygon_overlap_names.find(options.overlap);
    try {
        return read_region(options.region, reading);
    } catch (const InputError& error) {
        throw InputError(fmt::format("tiles points: --region: {}", error.what()));
    }
}

TilePointsWork::TilePointsWork(const TilesPointsOptions& options) : options_(options)
{
    const int places = !options.window.empty() + (options.torus > 0) + !options.region.empty();
    if (places != 1) throw InputError("tiles points: needs one of --window, --torus and --region");
    tiles_ = read_tile_set(options.file);
    if (has_classes()) check_class_target(options.out);
    out = checked_output("tiles points", "--out", options.out, has_classes() ? class_formats() : point_formats());
    head.dimension = tiles_.parameters.dimension;
    check_region_options(options, head.dimension);
    if (options.region.empty()) {
        set_up_block();
    } else {
        plane_ = read_points_region(options);
        region_ = std::make_shared<const FixedRegion>(plane_);
        set_up_region();
    }
}

double TilePointsWork::min_distance() const
{
    if (options_.points == 0) return options_.min_distance;
    return min_distance_in(tiled_->tile_width(), tiles_, region_->box());
}

void TilePointsWork::set_up_block()
{
    const TileBlock block = checked_block(options_, head.dimension);
    head.side = std::ranges::max(block.size); // of the square (cube) that the points are in
    for (int k = 0; k < head.dimension; ++k)
        head.fills_square = head.fills_square && block.size[static_cast<std::size_t>(k)] == head.side;
    head.comment = comment_of(options_, fmt::format("coordinates in tiles, from the lowest corner of the {}",
                                                    options_.torus > 0 ? "torus" : "window"));
    check_particles(options_, block, head);
    set_density({{}, {static_cast<double>(block.size[0]), static_cast<double>(block.size[1])}});
    open_stream(block);
    points.emplace(stream_, tiles_, WindowOfTiling{block, options_.torus, options_.seed}, *density_);
}

void TilePointsWork::set_up_region()
{
    const RegionBox& box = region_->box();
    set_density({box.low, {box.width(), box.height()}});
    head.side = 0;
    head.unit = file_units(plane_);
    check_head(out, head);
    try {
        const double width = tile_width_for(options_.points > 0 ? 1 : options_.min_distance, tiles_, box);
        if (options_.points == 0) {
            lay_tiles(width);
        } else {
            const double tiles = static_cast<double>(options_.points) / tiles_.parameters.points_per_tile;
            lay_tiles(tile_width_for_points(options_.points, std::sqrt(region_->area() / tiles), [&](double tried) {
                lay_tiles(tried);
                return points->count_all();
            }));
        }
    } catch (const InputError& error) {
        throw InputError(fmt::format("tiles points: --region: {}", error.what()));
    }
    head.comment = comment_of(options_, fmt::format("in {}; a tile is {} wide", head.unit, tiled_->tile_width()));
}

/// The region's points with tiles of this width.
void TilePointsWork::lay_tiles(double width)
{
    tiled_ = std::make_shared<const TiledRegion>(region_, width);
    if (!stream_) open_stream(tiled_->block());
    const auto map = is_mapped(plane_) ? plane_.source->map : nullptr;
    points.emplace(stream_, tiles_, WindowOfTiling{tiled_->block(), 0, options_.seed, tiled_, map}, *density_);
}

void TilePointsWork::set_density(const DensityArea& area)
{
    density_.emplace(options_.density, options_.density_from, area, head.dimension, options_.work.is_quiet());
}

void TilePointsWork::open_stream(const TileBlock& block)
{
    const DistributionPlace place = options_.work.place("tiles points", true);
    if (place.engine == Engine::opencl)
        check_fits(options_.file.string(),
                   TilePointGenerator::memory(tiles_.parameters, block.tiles(), place.device().info()),
                   place.device().info());
    stream_ = place.engine == Engine::opencl ? device_stream(place.device(), tiles_) : reference_stream(tiles_);
}

}
