#include "host/device/kernel_program.hpp"

#include <algorithm>
#include <stdexcept>

namespace poissonlab {
namespace {

/// This is 1 where a program uses the double precision of a device, and 0 where it does without.
constexpr const char* doubles_constant = "DOUBLES";

const KernelFile& listed_file(const std::string& name)
{
    const auto& files = kernel_files();
    const auto listed = std::ranges::find(files, name, &KernelFile::name);
    if (listed == files.end()) throw std::logic_error("kernel_files() does not list " + name);
    return *listed;
}

}

KernelNeeds& KernelNeeds::operator|=(const KernelNeeds& other)
{
    double_precision |= other.double_precision;
    local_bytes = std::max(local_bytes, other.local_bytes);
    return *this;
}

const std::vector<KernelFile>& kernel_files()
{
    static const KernelNeeds doubles{.double_precision = true};
    static const KernelNeeds doubles_in_tiles{.double_precision = true, .local_bytes = 8 << 10};
    static const KernelNeeds staging{.local_bytes = 1 << 10}; // takes more where there is more
    static const KernelConstant dimension{"DIMENSION", {"2", "3"}};
    static const KernelConstant with_doubles{doubles_constant, {"1", "0"}}; // see kernels/common/reals.clh
    static const KernelConstant reach{"REACH", {"2", "3"}};
    static const KernelConstant large_disks{"LARGE_DISKS", {"0", "1"}};
    static const KernelConstant bricks{"BRICKS", {"0", "1"}};
    static const KernelConstant listed{"LISTED", {"0", "1"}};
    static const std::vector<KernelFile> files{
        {"averaged_tiles.cl", "averaged-tiles", doubles, {}},
        {"beatty_tiling.cl", "aperiodic tile", {}, {}},
        {"class_darts.cl", "distribute classes", {}, {dimension, {"REGION", {"0", "1"}}}},
        {"class_tiles.cl", "tiles build", doubles_in_tiles, {dimension}},
        {"dart_throwing.cl", "dart-throwing", staging, {dimension, reach, large_disks, bricks, {"REGION", {"0", "1"}}}},
        {"darts_in_bricks.cl", "dart-throwing", {}, {dimension, reach, large_disks, {"BRICKS", {"1"}}}},
        {"darts_in_order.cl", "dart-throwing", {}, {dimension, reach, large_disks, {"BRICKS", {"0"}}}},
        {"darts_in_rounds.cl", "dart-throwing", {}, {dimension, reach, large_disks, bricks}},
        {"farthest_point.cl", "farthest-point", doubles, {}},
        {"gaussian_blue_noise.cl", "gaussian-blue-noise", doubles, {dimension, {"ADAPTIVE", {"0", "1"}}, listed}},
        {"gradient_domain.cl", "texture build", doubles, {}},
        {"instances.cl", "distribute instances", doubles, {}},
        {"joint_nulling.cl", "tiles build", doubles, {dimension}},
        {"lloyd_sets.cl", "Lloyd relaxation", {}, {with_doubles}},
        {"objects.cl", "object distribution", {}, {}},
        {"penrose.cl", "penrose", {}, {}},
        {"point_grid.cl", "relaxation", {}, {dimension, with_doubles, listed}},
        {"polyominoes.cl", "polyominoes", {}, {{"FACTOR", {"2", "9"}}, {"CELL_UNITS", {"4096"}}}},
        {"power_cells.cl", "equal-areas", doubles, {}},
        {"recursive_tiles.cl", "recursive-wang-tiles", doubles, {}},
        {"region_lloyd.cl", "Lloyd relaxation in regions", doubles, {}},
        {"relaxation.cl", "relaxation", {}, {dimension, with_doubles}},
        {"relaxation_dart_throwing.cl",
         "relaxation-dart-throwing",
         {},
         {dimension, {"COVER_BITS", {"2", "3"}}, {"REGION", {"0", "1", "2"}}}},
        {"repulsion.cl", "repulsion", {}, {dimension, with_doubles}},
        {"sample_elimination.cl", "sample-elimination", doubles, {dimension, {"FACTORS", {"0", "1"}}, listed}},
        {"sector_darts.cl", "sector-darts", doubles, {}},
        {"self_similar.cl", "distribute rank", {}, {}},
        {"surfaces/class_surface_darts.cl", "distribute surface-classes", {}, {}},
        {"surfaces/surface_darts.cl", "distribute surface", {}, {}},
        {"surfaces/surface_elimination.cl", "distribute surface", doubles, {}},
        {"textures/endless_map.cl",
         "texture map",
         doubles,
         {{"METHOD", {"0", "1", "2", "3"}},
          {"CHANNELS", {"1", "3"}},
          {"EXPONENT", {"7"}, true},
          {"GAIN", {"2"}, true},
          {"RESTORED", {"0", "1"}},
          {"TURNED", {"0", "1"}}}},
        {"textures/endless_texture.cl",
         "texture endless",
         {},
         {{"METHOD", {"0", "1", "2", "3", "4", "5"}},
          {"CHANNELS", {"1", "3"}},
          {"CELL", {"24"}, true},
          {"ROW", {"21"}, true},
          {"EXPONENT", {"7"}, true},
          {"GAIN", {"2"}, true},
          {"RESTORED", {"0", "1"}},
          {"TURNED", {"0", "1"}},
          {"COLORS", {"3"}, true}}},
        {"textures/texture_map.cl",
         "texture map",
         doubles,
         {{"LOOKUP", {"0", "1", "2", "3"}}, {"CHANNELS", {"1", "3"}}, {"WANG", {"0", "1"}}, {"COLORS", {"3"}, true}}},
        {"tile_darts.cl", "tiles build", doubles_in_tiles, {dimension}},
        {"tile_points.cl",
         "tiles points",
         {},
         {{"KIND", {"0", "1", "2"}},
          dimension,
          {"COLORS", {"2u"}, true},
          {"TILES", {"16u"}, true},
          {"POINTS", {"7u", "64u"}, true},
          {"LOW", {"0", "-32768"}},
          {"STEP", {"1", "2"}},
          {"VALUE", {"float", "uint"}}}},
        {"tile_relaxation.cl", "tiles build", doubles_in_tiles, {dimension}},
        {"varied_darts.cl", "distribute darts", {}, {}},
        {"voronoi_2d.cl", "Lloyd relaxation", {}, {with_doubles}},
        {"voronoi_3d_fast.cl", "Lloyd relaxation", doubles, {}},
        {"voronoi_3d_slow.cl", "Lloyd relaxation", doubles, {}},
        {"voronoi_darts.cl", "voronoi-darts", doubles, {}},
        {"warp.cl", "distribute warp", doubles, {}},
    };
    return files;
}

KernelNeeds needs_of(const std::vector<std::string>& files)
{
    KernelNeeds needs;
    for (const std::string& file : files) needs |= listed_file(file).needs;
    return needs;
}

KernelNeeds all_kernel_needs()
{
    KernelNeeds needs;
    for (const KernelFile& file : kernel_files()) needs |= file.needs;
    return needs;
}

KernelProgram kernel_program(const std::string& file, const std::vector<KernelValue>& values)
{
    const KernelFile& listed = listed_file(file);
    const auto is_listed = [](const KernelConstant& constant, const KernelValue& value) {
        return constant.name == value.name &&
               (constant.has_more || std::ranges::find(constant.values, value.value) != constant.values.end());
    };
    KernelProgram program{file, listed.work, "", listed.needs};
    program.needs.double_precision |= std::ranges::any_of(
        values, [](const KernelValue& value) { return value.name == doubles_constant && value.value == "1"; });
    for (const KernelValue& value : values)
        program.options += (program.options.empty() ? "-D " : " -D ") + value.name + "=" + value.value;
    if (!std::ranges::equal(listed.constants, values, is_listed))
        throw std::logic_error("kernel_files() does not list " + file + " with " + program.options);
    return program;
}

}
