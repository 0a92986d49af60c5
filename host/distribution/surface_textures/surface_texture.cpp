#include "host/distribution/surface_textures/surface_texture.hpp"

#include "base/errors/errors.hpp"
#include "host/distribution/surfaces/quad_surface.hpp"
#include "host/texture/exemplar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace poissonlab {
namespace {

/// Finds the labels of the sides of a surface's quads, by the colours of its edges or its vertices.
class SurfaceLabels
{
public:
    SurfaceLabels(const QuadSurface& surface, const SurfaceTextureSettings& settings, std::uint64_t seed)
        : surface_(surface), settings_(settings), stream_(stream_key(seed, Purpose::mesh_colors, 0))
    {}

    SideLabels of(std::uint32_t quad) const
    {
        SideLabels labels{};
        for (std::uint32_t k = 0; k < 4; ++k)
            labels[k] = settings_.labels == QuadLabels::wang
                            ? edge_label({quad, k})
                            : vertex_color({quad, k}) * settings_.colors + vertex_color({quad, (k + 1) % 4});
        return labels;
    }

    /// Counts the edges that their two quads see differently.
    std::size_t mismatches() const
    {
        std::size_t count = 0;
        for (std::uint32_t q = 0; q < surface_.mesh.quads.size(); ++q)
            for (std::uint32_t k = 0; k < 4; ++k) {
                const QuadCorner other = surface_.topology.across({q, k});
                count += surface_.topology.is_forward({q, k}) &&
                         of(q)[k] != opposite_label(settings_.labels, settings_.colors, of(other.quad)[other.corner]);
            }
        return count;
    }

private:
    std::uint32_t vertex_color(QuadCorner at) const
    {
        const std::uint32_t vertex = surface_.mesh.quads[at.quad][at.corner];
        return philox({vertex, 0, 0, 0}, stream_)[0] % settings_.colors;
    }
    std::uint32_t edge_label(QuadCorner side) const
    {
        const auto words = philox({surface_.topology.edge_of(side), 2, 0, 0}, stream_);
        const bool is_along = (words[1] & 1) == 0;
        return words[0] % settings_.colors * 2 + (surface_.topology.is_forward(side) == is_along ? 0 : 1);
    }

    const QuadSurface& surface_;
    const SurfaceTextureSettings& settings_;
    StreamKey stream_;
};

/// Returns the numbers of a normal that is turned by quarters counterclockwise.
std::array<std::uint8_t, 3> turned_normal(const std::uint8_t* n, std::uint8_t turns)
{
    const auto opposite = [](std::uint8_t value) { return static_cast<std::uint8_t>(255 - value); };
    switch (turns) {
    case 1:
        return {opposite(n[1]), n[0], n[2]};
    case 2:
        return {opposite(n[0]), opposite(n[1]), n[2]};
    case 3:
        return {n[1], opposite(n[0]), n[2]};
    default:
        return {n[0], n[1], n[2]};
    }
}

/// Draws the cells of all tiles of a set as they show a picture of the exemplar's size.
PngPixels shown_cells(const QuadTextureSet& set, const QuadAtlas& atlas, const PngPixels& picture, bool has_normals)
{
    PngPixels cells{atlas.color.width, atlas.color.height, picture.channels, {}};
    cells.values.resize(cells.at(0, cells.height, 0));
    const int whole = set.size + 2 * set.gutter;
    for (std::uint32_t tile = 0; tile < set.tiles.size(); ++tile) {
        const auto [left, top] = atlas.corner_of(tile);
        for (int i = 0; i < whole * whole; ++i) {
            const TurnedSource& source = set.tiles[tile][static_cast<std::size_t>(i)];
            const std::uint8_t* const from = &picture.values[picture.at(source.pixel.x, source.pixel.y, 0)];
            std::uint8_t* const to = &cells.values[cells.at(left + i % whole, top + i / whole, 0)];
            if (has_normals)
                std::ranges::copy(turned_normal(from, source.turns), to);
            else
                std::copy(from, from + picture.channels, to);
        }
    }
    return cells;
}

PngPixels companion(const std::filesystem::path& file, const PngPixels& exemplar, int channels)
{
    PngPixels picture = read_exemplar(file);
    if (picture.width != exemplar.width || picture.height != exemplar.height)
        throw InputError::at({file.string()}, fmt::format("has {} x {} pixels, the exemplar {} x {}", picture.width,
                                                          picture.height, exemplar.width, exemplar.height));
    if (picture.channels < channels) throw InputError::at({file.string()}, "is grey: normals have three channels");
    return picture;
}

QuadTextureSet made_set(const SurfaceTextureSettings& s, const PngPixels& exemplar, std::uint64_t seed,
                        const DistributionPlace& place)
{
    QuadTextureRequest request{s.labels, s.colors, {}};
    request.pieces.size = s.size;
    request.pieces.candidates = s.candidates;
    request.pieces.seed = seed;
    return make_quad_texture(exemplar, request, [&](const std::string& stage, std::size_t done, std::size_t total) {
        if (place.on_step) place.on_step(fmt::format("{}: {} of {}", stage, done, total));
    });
}

}

DressedSurface textured_surface(const SurfaceTextureSettings& settings, std::uint64_t seed,
                                const DistributionPlace& place)
{
    DressedSurface dressed{quad_surface(settings.quads), {}, {}, {}};
    const QuadSurface& surface = *dressed.surface;
    const PngPixels exemplar = read_exemplar(settings.exemplar);
    const QuadTextureSet set = made_set(settings, exemplar, seed, place);
    QuadAtlas& atlas = dressed.atlas;
    atlas = QuadAtlas::with(set.tiles.size(), set.size, set.gutter, exemplar.channels);
    atlas.color = shown_cells(set, atlas, exemplar, false);
    if (!settings.normals.empty())
        atlas.normal = shown_cells(set, atlas, companion(settings.normals, exemplar, 3), true);
    if (!settings.heights.empty())
        atlas.normal = normals_of_heights(shown_cells(set, atlas, companion(settings.heights, exemplar, 1), false),
                                          settings.relief);
    const SurfaceLabels labels(surface, settings, seed);
    std::set<std::uint32_t> used;
    for (std::uint32_t q = 0; q < surface.mesh.quads.size(); ++q) {
        const SideLabels own = labels.of(q);
        const std::uint32_t first = least_turn(own);
        const auto tile = std::ranges::lower_bound(set.labels, turned_labels(own, first)) - set.labels.begin();
        atlas.cells.push_back({static_cast<std::uint32_t>(tile), first});
        used.insert(atlas.cells.back().number);
    }
    const AtlasSteps steps = atlas_steps(atlas, surface.mesh, surface.topology);
    dressed.numbers = quad_numbers(surface, stretch_of_quads(triangles_of(surface.mesh)));
    const auto add = [&](const char* key, const char* title, double value, std::string words) {
        dressed.numbers.push_back({key, title, value, std::move(words)});
    };
    add("mismatches", "Edges where tiles do not fit", static_cast<double>(labels.mismatches()),
        fmt::format("of {}, by the colours of their two quads", surface.topology.edges()));
    add("tiles", "Tiles used", static_cast<double>(used.size()), fmt::format("of the {} of the set", set.tiles.size()));
    add("step_across", "Step across edges", steps.across, "mean difference of colours, from a quad to the next one");
    add("step_inside", "Step beside edges", steps.inside, "the same from the outermost to the next line of a quad");
    add("greatest_step_across", "Greatest step of an edge", steps.greatest_across, "mean over the pixels along it");
    add("greatest_step_inside", "Greatest step of a line", steps.greatest_inside, "beside an edge");
    dressed.facts = {fmt::format("{} tiles of {} colours, {} x {} pixels",
                                 settings.labels == QuadLabels::wang ? "generalised Wang" : "corner", settings.colors,
                                 set.size, set.size)};
    return dressed;
}

void write_dressed(const std::filesystem::path& file, const DressedSurface& dressed, int pixels)
{
    const QuadSurface& surface = *dressed.surface;
    if (file.extension() == ".glb") return write_glb(file, surface.mesh, surface.topology, dressed.atlas);
    write_png(file, quad_picture(surface.mesh, surface.topology, dressed.atlas, pixels));
}

}
