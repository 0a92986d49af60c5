#include "host/tile_sampling/polyominoes/polyomino_sampler.hpp"

#include "base/errors/errors.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/programs/cache_folder.hpp"
#include "code_hashes.hpp"
#include "host/sampling/classics/plain_spec.hpp"
#include "host/sampling/density_parameters.hpp"
#include "host/sampling/device_sampler.hpp"
#include "kernels/common/tile_sampling/polyominoes.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

namespace poissonlab {
namespace {

PolyominoTable table_with_steps(Polyomino shape, const std::function<void(const std::string& what)>& on_step)
{
    if (!on_step) return build_polyomino_table(shape);
    return build_polyomino_table(shape, [&](const std::string& what, std::size_t done, std::size_t total) {
        on_step(total > 0 ? fmt::format("table of polyominoes: {} {} of {}", what, done, total)
                          : fmt::format("table of polyominoes: {}", what));
    });
}

}

std::string polyomino_table_name(Polyomino shape)
{
    return fmt::format("polyominoes-{}-{}.table", polyominoes[shape], POISSONLAB_CONSTRUCTION_VERSION);
}

BuiltOnce<PolyominoTable> cached_polyomino_table(Polyomino shape, const std::filesystem::path& folder,
                                                 const std::function<void(const std::string& what)>& on_step)
{
    return built_once(
        folder.empty() ? folder : folder / polyomino_table_name(shape), on_step, read_polyomino_table,
        [&] { return table_with_steps(shape, on_step); }, write_polyomino_table);
}

namespace {

std::array<std::int32_t, 4> packed(const Pose& pose, std::uint32_t tile_class = 0)
{
    return {static_cast<std::int32_t>(pose.shift.x), static_cast<std::int32_t>(pose.shift.y), pose.turn,
            static_cast<std::int32_t>(tile_class)};
}

}

NeededBuffers PolyominoGenerator::Buffers::needed(const Sizes& sizes)
{
    return {{order, sizes.roots},       {next, sizes.classes * sizes.children},   {tiles, sizes.tiles},
            {children, sizes.children}, {corrections, sizes.classes * sizes.row}, {points, sizes.points}};
}

PolyominoGenerator::PolyominoGenerator(Device device, Polyomino shape, std::size_t work_group_size)
    : device_(std::move(device)),
      work_group_size_(work_group_size > 0 ? work_group_size
                                           : std::min<std::size_t>(256, device_.info().max_work_group_size)),
      place_points_(device_.kernel(
          kernel_program("polyominoes.cl", {{"FACTOR", factor_of(shape)}, {"CELL_UNITS", cell_units}}), "place_points"))
{}

DeviceMemory PolyominoGenerator::memory(Polyomino shape, std::uint32_t side, std::size_t points)
{
    const PolyominoCounts counts(shape, side);
    const std::uint32_t level = counts.level_of(static_cast<double>(points));
    std::size_t tiles = counts.roots;
    for (std::uint32_t i = 0; i < first_level_of(shape); ++i) tiles *= counts.children;
    const std::size_t classes = shape == Polyomino::P ? 58 : 188;
    return memory_of(Buffers{}.needed(
        {counts.roots, tiles, counts.children, classes, counts.row_of(static_cast<double>(points), level), points}));
}

PointSet PolyominoGenerator::points(const PolyominoTorus& torus, std::size_t points)
{
    const PolyominoTable& table = torus.table();
    const Neighbourhoods& all = table.neighbourhoods;
    const std::uint32_t level = torus.counts().level_of(static_cast<double>(points));
    const std::uint32_t row = torus.counts().row_of(static_cast<double>(points), level);
    std::vector<std::array<std::int32_t, 4>> tiles, children;
    for (std::size_t i = 0; i < torus.first_tiles().size(); ++i)
        tiles.push_back(packed(torus.first_tiles()[i], torus.first_classes()[i]));
    for (const Pose& child : all.rule.children) children.push_back(packed(child));
    reserve(device_,
            buffers_.needed({torus.order().size(), tiles.size(), children.size(), all.collars.size(), row, points}));
    buffers_.order.write(torus.order());
    buffers_.next.write(all.next);
    buffers_.tiles.write(tiles);
    buffers_.children.write(children);
    buffers_.corrections.write(table.rows[row - 1]);
    const LatticePlace anchor = anchor_of(all.rule.shape);
    const auto side = static_cast<std::uint64_t>(torus.side_units(level));
    const contract::polyominoes::Torus header{.roots = static_cast<std::uint32_t>(torus.counts().roots),
                                              .first_level = all.first_level,
                                              .depth = table.depth,
                                              .level = level,
                                              .row = row,
                                              .count = static_cast<std::uint32_t>(points),
                                              .side = side,
                                              .anchor_x = static_cast<int>(anchor.x),
                                              .anchor_y = static_cast<int>(anchor.y)};
    place_points_.run(points, work_group_size_, header, buffers_.order, buffers_.tiles, buffers_.children,
                      buffers_.next, buffers_.corrections, buffers_.points);
    PointSet set{2, {}};
    set.coordinates.reserve(2 * points);
    for (const auto& place : buffers_.points.read(0, points))
        for (const std::uint64_t c : place)
            set.coordinates.push_back(static_cast<double>(c) / static_cast<double>(side));
    return set;
}

namespace {

constexpr const char* variant_key = "variant";
constexpr const char* side_key = "seed_side";

Polyomino shape_of(const Parameters& given) { return *polyominoes.find(given.text(variant_key)); }

/// Fewer points than these are in rows of the table that are proven after more divisions, with a side of 10.
constexpr std::size_t fewest_points_for_ten = 6401;

/// A density that is the same everywhere has the points of none, and their distance.
bool is_constant(const Density& density)
{
    return std::ranges::all_of(density.weights,
                               [&](std::uint64_t weight) { return weight == density.weights.front(); });
}

/// The side of the torus before its tiles are divided, in cells.
std::uint32_t side_of(const Parameters& given, std::size_t points)
{
    if (given.is_given(side_key)) return static_cast<std::uint32_t>(given.integer(side_key));
    if (shape_of(given) == Polyomino::G) return 12;
    return points < fewest_points_for_ten ? 5 : 10;
}

class PolyominoSampler final : public DeviceSampler
{
public:
    PolyominoSampler(const Parameters& given, const SampleRequest& request, Engine engine, const DeviceProvider& device)
        : DeviceSampler(engine, device), points_(request.points), seed_(request.seed),
          side_(side_of(given, request.points)), density_(given_density(given))
    {
        const auto begin = std::chrono::steady_clock::now();
        BuiltOnce<PolyominoTable> cached = cached_polyomino_table(shape_of(given), cache_folder(), request.on_step);
        table_ = std::move(cached.built);
        if (device_) generator_.emplace(*device_, shape_of(given));
        const std::chrono::duration<double> all = std::chrono::steady_clock::now() - begin;
        preparation_seconds_ = all.count() - build_seconds() - cached.waiting_seconds;
    }

    PointSet sample(std::uint32_t realization) override
    {
        const PolyominoTorus torus(table_, side_, seed_, realization);
        if (!density_ || is_constant(*density_)) proven_ = relative_radius(proven_distance(torus, points_), points_, 2);
        if (density_) return polyomino_points(torus, points_, *density_);
        return generator_ ? generator_->points(torus, points_) : polyomino_points(torus, points_);
    }

    SetTraits traits() const override
    {
        SetTraits traits;
        traits.sizes_vary = density_.has_value();
        traits.proven_relative_radius = proven_;
        traits.preparation_seconds = preparation_seconds_;
        return traits;
    }

private:
    std::size_t points_;
    std::uint64_t seed_;
    std::uint32_t side_;
    std::optional<Density> density_;
    PolyominoTable table_;
    std::optional<PolyominoGenerator> generator_;
    std::optional<double> proven_;
    double preparation_seconds_ = 0;
};

void check_polyominoes(const Parameters& given, const SampleRequest& request, const SourceLocation&)
{
    const std::uint32_t side = side_of(given, request.points);
    const auto cells = static_cast<std::uint32_t>(cells_of(shape_of(given)).size());
    if (side % cells != 0)
        throw given.error(side_key, fmt::format("must be a multiple of {}, the number of cells of a {} polyomino",
                                                cells, given.text(variant_key)));
    if (const auto density = given_density(given))
        if (const double values = polyomino_values(request.points, *density); values > most_polyomino_values)
            throw given.error("density",
                              fmt::format("has a densest place of {:.0f} points per unit area: must be at most {:.0f}",
                                          values, most_polyomino_values));
}

}

SamplerSpec polyomino_sampler()
{
    using Kind = ParameterSpec::Kind;
    std::vector<ParameterSpec> parameters{
        {.key = variant_key,
         .kind = Kind::choice,
         .help = "the polyomino: a pentomino that is divided into 4, or a hexomino that is divided into 81",
         .choices = polyominoes.all(),
         .otherwise = std::string(polyominoes[Polyomino::P])},
        {.key = side_key,
         .kind = Kind::integer,
         .help = "the torus' side before divisions, in cells: a multiple of 5 (P) or 6 (G)",
         .minimum = 5,
         .maximum = 24,
         .symbol = "S",
         .unless_given = "10 (P; 5 for 6,400 points and less) or 12 (G)"}};
    for (ParameterSpec& spec : density_parameters()) parameters.push_back(std::move(spec));
    SamplerSpec spec = plain_spec(
        "polyominoes", "Polyominoes",
        "a tiling with polyominoes whose points are moved by a table; even points at a distance that is proven", {2},
        std::move(parameters));
    spec.check = check_polyominoes;
    spec.outside_input = density_hash;
    // Values that have a point are counted as the density says, but for where tiles straddle its changes.
    spec.most_points = [](const Parameters& given, const SampleRequest& request) -> std::size_t {
        return given.is_given("density") ? request.points + request.points / 4 + 64 : request.points;
    };
    spec.memory_growth = MemoryGrowth::linear;
    spec.device_memory = [](const Parameters& given, const SampleRequest& request, const DeviceInfo&) {
        if (given.is_given("density")) return DeviceMemory{};
        return PolyominoGenerator::memory(shape_of(given), side_of(given, request.points), request.points);
    };
    spec.kernels = {"polyominoes.cl"};
    spec.create = [](const Parameters& given, const SampleRequest& request, Engine engine,
                     const DeviceProvider& device) {
        // Densities are followed on the host: values without points are most of the work there.
        const Engine used = given.is_given("density") ? Engine::reference : engine;
        return std::make_unique<PolyominoSampler>(given, request, used, device);
    };
    return spec;
}

}
