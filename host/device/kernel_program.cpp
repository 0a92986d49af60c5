#include "host/device/kernel_program.hpp"

#include <algorithm>
#include <stdexcept>

namespace poissonlab {

const std::vector<KernelFile>& kernel_files()
{
    static const KernelConstant dimension{"DIMENSION", {"2", "3"}};
    static const KernelConstant reach{"REACH", {"2", "3"}};
    static const KernelConstant large_disks{"LARGE_DISKS", {"0", "1"}};
    static const std::vector<KernelFile> files{
        {"averaged_tiles.cl", {}},
        {"beatty_tiling.cl", {}},
        {"class_darts.cl", {dimension}},
        {"class_tiles.cl", {dimension}},
        {"dart_throwing.cl", {dimension, reach, large_disks, {"REGION", {"0", "1"}}}},
        {"darts_in_order.cl", {dimension, reach, large_disks}},
        {"darts_in_rounds.cl", {dimension, reach, large_disks}},
        {"farthest_point.cl", {}},
        {"gaussian_blue_noise.cl", {dimension, {"ADAPTIVE", {"0", "1"}}}},
        {"gradient_domain.cl", {}},
        {"instances.cl", {}},
        {"joint_nulling.cl", {dimension}},
        {"masked_squares.cl", {}},
        {"objects.cl", {}},
        {"penrose.cl", {}},
        {"point_grid.cl", {dimension}},
        {"polyominoes.cl", {{"FACTOR", {"2", "9"}}, {"CELL_UNITS", {"4096"}}}},
        {"power_cells.cl", {}},
        {"recursive_tiles.cl", {}},
        {"region_lloyd.cl", {}},
        {"relaxation.cl", {dimension}},
        {"relaxation_dart_throwing.cl", {dimension, {"COVER_BITS", {"2", "3"}}, {"REGION", {"0", "1"}}}},
        {"repulsion.cl", {dimension}},
        {"sample_elimination.cl", {dimension, {"FACTORS", {"0", "1"}}}},
        {"sector_darts.cl", {}},
        {"self_similar.cl", {}},
        {"surfaces/surface_darts.cl", {}},
        {"surfaces/surface_elimination.cl", {}},
        {"textures/endless_map.cl",
         {{"METHOD", {"0", "1", "2", "3"}},
          {"CHANNELS", {"1", "3"}},
          {"EXPONENT", {"7"}, true},
          {"GAIN", {"2"}, true},
          {"RESTORED", {"0", "1"}}}},
        {"textures/endless_texture.cl",
         {{"METHOD", {"0", "1", "2", "3", "4", "5"}},
          {"CHANNELS", {"1", "3"}},
          {"CELL", {"24"}, true},
          {"ROW", {"21"}, true},
          {"EXPONENT", {"7"}, true},
          {"GAIN", {"2"}, true},
          {"RESTORED", {"0", "1"}},
          {"COLORS", {"3"}, true}}},
        {"textures/texture_map.cl",
         {{"LOOKUP", {"0", "1", "2", "3"}}, {"CHANNELS", {"1", "3"}}, {"WANG", {"0", "1"}}, {"COLORS", {"3"}, true}}},
        {"tile_darts.cl", {dimension}},
        {"tile_points.cl",
         {{"KIND", {"0", "1", "2"}},
          dimension,
          {"COLORS", {"2u"}, true},
          {"TILES", {"16u"}, true},
          {"POINTS", {"7u", "64u"}, true},
          {"LOW", {"0", "-32768"}},
          {"STEP", {"1", "2"}},
          {"VALUE", {"float", "uint"}}}},
        {"tile_relaxation.cl", {dimension}},
        {"varied_darts.cl", {}},
        {"voronoi_2d.cl", {}},
        {"voronoi_3d_fast.cl", {}},
        {"voronoi_3d_slow.cl", {}},
        {"voronoi_darts.cl", {}},
        {"warp.cl", {}},
    };
    return files;
}

KernelProgram kernel_program(const std::string& file, const std::vector<KernelValue>& values)
{
    const auto& files = kernel_files();
    const auto listed = std::ranges::find(files, file, &KernelFile::name);
    if (listed == files.end()) throw std::logic_error("kernel_files() does not list " + file);
    const auto is_listed = [](const KernelConstant& constant, const KernelValue& value) {
        return constant.name == value.name &&
               (constant.has_more || std::ranges::find(constant.values, value.value) != constant.values.end());
    };
    KernelProgram program{file, ""};
    for (const KernelValue& value : values)
        program.options += (program.options.empty() ? "-D " : " -D ") + value.name + "=" + value.value;
    if (!std::ranges::equal(listed->constants, values, is_listed))
        throw std::logic_error("kernel_files() does not list " + file + " with " + program.options);
    return program;
}

}
