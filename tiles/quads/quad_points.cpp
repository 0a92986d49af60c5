#include "tiles/quads/quad_points.hpp"

#include "base/random/random_words.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace poissonlab {
namespace {

/// So many darts that are refused in a row end the filling of a region.
constexpr int most_misses = 3000;

/// These are half of a strip's width and the radius of a disk, in minimum distances.
constexpr double strip_part = 0.5, disk_part = 1.3066;

constexpr double place_steps = 65536;

/// A sector of a disk begins at a side.
struct Sector
{
    std::uint32_t valence = 0, color = 0, wedge = 0;

    Sector after() const { return {valence, color, (wedge + 1) % valence}; }
    auto operator<=>(const Sector&) const = default;
};

/// A corner of a tile has a sector, and the edge that begins there may be seen along its own direction.
struct TileCorner
{
    Sector sector;
    bool is_forward = true;

    auto operator<=>(const TileCorner&) const = default;
};

using TileKey = std::array<TileCorner, 4>;
using EdgeKey = std::array<Sector, 2>;

/// A place has coordinates along an edge from its start and to its left, or in a tile.
using UnitPlace = std::array<double, 2>;

double squared(const UnitPlace& p, const UnitPlace& q)
{
    return (p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]);
}

/// Returns a place beside an edge as its end sees it.
UnitPlace reversed(const UnitPlace& p) { return {1 - p[0], -p[1]}; }

/// Returns a place beside the edge that a sector begins at, as the sector's vertex has it.
WedgePlace around_sector(const Sector& sector, const UnitPlace& p)
{
    if (p[1] >= 0) return {sector.wedge, p[0], p[1]};
    return {(sector.wedge + sector.valence - 1) % sector.valence, -p[1], p[0]};
}

/// Draws random places, which the key of a region alone decides.
class Darts
{
public:
    Darts(std::uint64_t seed, std::uint32_t region, std::initializer_list<Sector> sectors, std::uint32_t bits = 0)
        : words_(stream_of(seed, region, sectors, bits), 0)
    {}

    std::uint32_t below(std::uint32_t end) { return words_.below(end); }
    /// Returns a multiple of 2^-16 from `low` to less than `high`, both of them such.
    double between(double low, double high)
    {
        return low + words_.below(static_cast<std::uint32_t>((high - low) * place_steps)) / place_steps;
    }

private:
    static StreamKey stream_of(std::uint64_t seed, std::uint32_t region, std::initializer_list<Sector> sectors,
                               std::uint32_t bits)
    {
        // Realization 0 of the purpose makes the colours of the mesh.
        StreamKey key = stream_key(seed, Purpose::mesh_colors, region);
        const auto mix = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            const auto words = philox({a, b, c, 0}, key);
            key = {words[0], words[1]};
        };
        mix(bits, static_cast<std::uint32_t>(sectors.size()), 0);
        for (const Sector& s : sectors) mix(s.valence, s.color, s.wedge);
        return key;
    }

    RandomWords words_;
};

class QuadPointTiles
{
public:
    explicit QuadPointTiles(const QuadPointRequest& request)
        : request_(request), squared_(request.min_distance * request.min_distance),
          strip_(rounded_up(strip_part * request.min_distance)), disk_(rounded_up(disk_part * request.min_distance))
    {}

    const std::vector<UnitPlace>& tile(const TileKey& key)
    {
        const auto [at, is_new] = tiles_.try_emplace(key);
        if (is_new) at->second = made_tile(key);
        return at->second;
    }

    std::size_t disks() const { return disks_.size(); }
    std::size_t edges() const { return edges_.size(); }
    std::size_t tiles() const { return tiles_.size(); }

private:
    static double rounded_up(double x) { return std::ceil(x * place_steps) / place_steps; }

    const std::vector<WedgePlace>& disk(const Sector& of)
    {
        const auto [at, is_new] = disks_.try_emplace({of.valence, of.color});
        if (!is_new) return at->second;
        Darts darts(request_.seed, 1, {{of.valence, of.color, 0}});
        for (int misses = 0; misses < most_misses; ++misses) {
            const WedgePlace p{darts.below(of.valence), darts.between(0, disk_), darts.between(0, disk_)};
            if (p.a * p.a + p.b * p.b >= disk_ * disk_ || !is_free(of, p)) continue;
            at->second.push_back(p);
            misses = 0;
        }
        return at->second;
    }

    /// Is a place around a vertex far enough from all points that its disk has by now?
    bool is_free(const Sector& of, const WedgePlace& p)
    {
        return std::ranges::none_of(disks_.at({of.valence, of.color}),
                                    [&](const WedgePlace& q) { return cone_squared(of.valence, p, q) < squared_; });
    }

    bool is_free(const std::vector<UnitPlace>& points, const UnitPlace& p) const
    {
        return std::ranges::none_of(points, [&](const UnitPlace& q) { return squared(p, q) < squared_; });
    }

    bool is_in_disk(double a, double b) const { return a * a + b * b < disk_ * disk_; }

    const std::vector<UnitPlace>& edge(const EdgeKey& key)
    {
        const auto [at, is_new] = edges_.try_emplace(key);
        std::vector<UnitPlace>& points = at->second;
        if (!is_new) return points;
        for (const Sector& end : key) disk(end);
        Darts darts(request_.seed, 2, {key[0], key[1]});
        for (int misses = 0; misses < most_misses; ++misses) {
            // No point lies on the edge itself, where it would be in both tiles or in none.
            const UnitPlace p{darts.between(0, 1), darts.between(-strip_, strip_) + 0.5 / place_steps};
            const UnitPlace back = reversed(p);
            if (is_in_disk(p[0], p[1]) || is_in_disk(back[0], back[1]) || !is_free(points, p) ||
                !is_free(key[0], around_sector(key[0], p)) || !is_free(key[1], around_sector(key[1], back)))
                continue;
            points.push_back(p);
            misses = 0;
        }
        return points;
    }

    /// Returns the points beside side k of a tile, in the tile's square or beyond it.
    std::vector<UnitPlace> beside(const TileKey& key, std::uint32_t k)
    {
        const Sector &start = key[k].sector, end = key[(k + 1) % 4].sector.after();
        std::vector<UnitPlace> places;
        for (UnitPlace p : edge(key[k].is_forward ? EdgeKey{start, end} : EdgeKey{end, start})) {
            if (!key[k].is_forward) p = reversed(p);
            places.push_back(turned_place(p[0], p[1], k));
        }
        return places;
    }

    static bool is_inside(const UnitPlace& p) { return p[0] >= 0 && p[0] <= 1 && p[1] >= 0 && p[1] <= 1; }

    std::vector<UnitPlace> made_tile(const TileKey& key)
    {
        std::vector<UnitPlace> own, around;
        for (std::uint32_t k = 0; k < 4; ++k) {
            for (const UnitPlace& p : beside(key, k)) {
                around.push_back(p);
                if (is_inside(p)) own.push_back(p);
            }
            for (const WedgePlace& p : disk(key[k].sector))
                if (p.wedge == key[k].sector.wedge) own.push_back(turned_place(p.a, p.b, k));
        }
        std::uint32_t directions = 0;
        for (const TileCorner& corner : key) directions = 2 * directions + corner.is_forward;
        Darts darts(request_.seed, 3, {key[0].sector, key[1].sector, key[2].sector, key[3].sector}, directions);
        for (int misses = 0; misses < most_misses; ++misses) {
            const UnitPlace p{darts.between(strip_, 1 - strip_), darts.between(strip_, 1 - strip_)};
            bool is_kept = is_free(around, p);
            for (std::uint32_t k = 0; k < 4 && is_kept; ++k) {
                const UnitPlace near = turned_place(p[0], p[1], 4 - k);
                is_kept = !is_in_disk(near[0], near[1]) &&
                          is_free(key[k].sector, WedgePlace{key[k].sector.wedge, near[0], near[1]});
            }
            if (!is_kept) continue;
            around.push_back(p);
            own.push_back(p);
            misses = 0;
        }
        return own;
    }

    const QuadPointRequest& request_;
    double squared_, strip_, disk_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<WedgePlace>> disks_;
    std::map<EdgeKey, std::vector<UnitPlace>> edges_;
    std::map<TileKey, std::vector<UnitPlace>> tiles_;
};

/// Draws the colours and turns of a mesh's vertices, and the directions of its edges, by the seed.
class QuadSectors
{
public:
    QuadSectors(const QuadMesh& mesh, const QuadTopology& topology, const QuadPointRequest& request)
        : mesh_(mesh), topology_(topology), colors_(request.colors),
          stream_(stream_key(request.seed, Purpose::mesh_colors, 0))
    {}

    TileKey tile_of(std::uint32_t quad) const
    {
        TileKey key;
        for (std::uint32_t k = 0; k < 4; ++k) key[k].sector = sector({quad, k});
        for (std::uint32_t k = 0; k < 4; ++k) {
            const Sector &start = key[k].sector, end = key[(k + 1) % 4].sector.after();
            key[k].is_forward = start != end ? start < end : is_random_forward({quad, k});
        }
        return key;
    }

private:
    Sector sector(QuadCorner at) const
    {
        const std::uint32_t vertex = mesh_.quads[at.quad][at.corner], valence = topology_.valence(vertex);
        const auto words = philox({vertex, 0, 0, 0}, stream_);
        return {valence, words[0] % colors_, (topology_.wedge_of(at) + words[1]) % valence};
    }
    bool is_random_forward(QuadCorner side) const
    {
        return topology_.is_forward(side) == ((philox({topology_.edge_of(side), 1, 0, 0}, stream_)[0] & 1) == 0);
    }

    const QuadMesh& mesh_;
    const QuadTopology& topology_;
    std::uint32_t colors_;
    StreamKey stream_;
};

/// Returns the least of the four turns of a tile, and the corner of the quad that is corner 0 of that turn.
std::pair<TileKey, std::uint32_t> least_turned(const TileKey& key)
{
    std::pair<TileKey, std::uint32_t> least{key, 0};
    for (std::uint32_t first = 1; first < 4; ++first) {
        TileKey other;
        for (std::size_t k = 0; k < 4; ++k) other[k] = key[(k + first) % 4];
        if (other < least.first) least = {other, first};
    }
    return least;
}

/// Returns the squared distance of p from q, whose quad comes `turns` quads after that of p, around a vertex that is in
/// the way where the angle between them is more than half a turn.
double squared_after(std::uint32_t turns, const WedgePlace& p, const WedgePlace& q)
{
    if (turns == 0) return squared({p.a, p.b}, {q.a, q.b});
    if (turns == 1) return squared({p.a, p.b}, {-q.b, q.a});
    if (turns == 2 && p.b * q.a - p.a * q.b >= 0) return squared({p.a, p.b}, {-q.a, -q.b});
    const double way = std::hypot(p.a, p.b) + std::hypot(q.a, q.b);
    return way * way;
}

}

double cone_squared(std::uint32_t valence, const WedgePlace& p, const WedgePlace& q)
{
    const std::uint32_t after = (q.wedge + valence - p.wedge) % valence;
    return std::min(squared_after(after, p, q), squared_after(after == 0 ? valence : valence - after, q, p));
}

QuadPoints lay_quad_points(const QuadMesh& mesh, const QuadTopology& topology, const QuadPointRequest& request)
{
    QuadPointTiles tiles(request);
    const QuadSectors sectors(mesh, topology, request);
    QuadPoints laid;
    for (std::uint32_t quad = 0; quad < mesh.quads.size(); ++quad) {
        const auto [key, first] = least_turned(sectors.tile_of(quad));
        for (const UnitPlace& p : tiles.tile(key)) {
            const UnitPlace at = turned_place(p[0], p[1], first);
            laid.points.push_back({quad, at[0], at[1]});
        }
    }
    laid.disks = tiles.disks();
    laid.edges = tiles.edges();
    laid.tiles = tiles.tiles();
    return laid;
}

}
