// Darts on surfaces, plain and sequential: what the kernels must reproduce.
#include "host/sampling/surfaces/surface_darts.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace poissonlab::reference {
namespace {

using contract::surface::PIECE_COVERED;
using contract::surface::PIECE_OPEN;
using contract::surface::PIECE_SMALL;

/// A place with the triangle that it lies on.
struct SurfaceSpot
{
    MeshPlace place;
    std::uint32_t triangle;
};

SurfaceSpot spot_of(const SurfacePoint& point) { return {place_of(point), point.triangle}; }

SurfaceSpot corner_spot(const FixedSurface& surface, const SurfacePiece& piece, std::size_t i)
{
    return {place_on(surface.triangles[piece.triangle], piece.shares[2 * i], piece.shares[2 * i + 1]), piece.triangle};
}

class PlainSurfaceDarts final : public SurfaceDartEngine
{
public:
    explicit PlainSurfaceDarts(const SurfaceDartRequest& request) : surface_(request.surface), stream_(request.stream)
    {}

    void restart(const contract::surface::SurfaceRule& rule, const std::vector<SurfacePoint>& points,
                 std::size_t) override
    {
        rule_ = rule;
        cells_.clear();
        for (const SurfacePoint& point : points) add(point);
    }

    void set_pieces(const std::vector<SurfacePiece>& pieces) override { pieces_ = pieces; }
    void set_choice(const SurfacePieceChoice& choice) override { choice_ = choice; }

    std::vector<SurfacePoint> throw_darts(std::uint64_t first, std::uint32_t darts, std::size_t most) override
    {
        std::vector<SurfacePoint> accepted;
        for (std::uint32_t i = 0; i < darts && accepted.size() < most; ++i) {
            const SurfacePoint dart = surface_dart(*surface_, pieces_, choice_, stream_, first + i);
            if (has_conflict(spot_of(dart))) continue;
            add(dart);
            accepted.push_back(dart);
        }
        return accepted;
    }

    std::vector<std::uint32_t> cover() override
    {
        std::vector<std::uint32_t> states;
        states.reserve(pieces_.size());
        for (const SurfacePiece& piece : pieces_)
            states.push_back(is_covered(piece)                                  ? PIECE_COVERED
                             : is_last(piece) && has_conflict(centre_of(piece)) ? PIECE_SMALL
                                                                                : PIECE_OPEN);
        return states;
    }

private:
    using Cell = std::array<std::int64_t, 3>;

    Cell cell_of(const MeshPlace& place) const
    {
        return {place[0] / rule_.cell, place[1] / rule_.cell, place[2] / rule_.cell};
    }

    void add(const SurfacePoint& point) { cells_[cell_of(place_of(point))].push_back(spot_of(point)); }

    /// Looks at all points in the cells around a place.
    template <typename Predicate>
    bool any_near(const SurfaceSpot& spot, const Predicate& predicate) const
    {
        const Cell own = cell_of(spot.place);
        for (int i = 0; i < 27; ++i) {
            const auto found = cells_.find({own[0] + i % 3 - 1, own[1] + i / 3 % 3 - 1, own[2] + i / 9 - 1});
            if (found != cells_.end() && std::ranges::any_of(found->second, [&](const SurfaceSpot& other) {
                    return cosine_between(surface_->triangles[spot.triangle], surface_->triangles[other.triangle]) >=
                               rule_.least_cosine &&
                           predicate(other);
                }))
                return true;
        }
        return false;
    }

    bool has_conflict(const SurfaceSpot& spot) const
    {
        return any_near(
            spot, [&](const SurfaceSpot& other) { return squared_distance(spot.place, other.place) < rule_.squared; });
    }

    bool is_covered(const SurfacePiece& piece) const
    {
        const std::array corners{corner_spot(*surface_, piece, 0), corner_spot(*surface_, piece, 1),
                                 corner_spot(*surface_, piece, 2)};
        return any_near(corners[0], [&](const SurfaceSpot& point) {
            return std::ranges::all_of(corners, [&](const SurfaceSpot& corner) {
                return squared_distance(corner.place, point.place) < rule_.covered;
            });
        });
    }

    SurfaceSpot centre_of(const SurfacePiece& piece) const
    {
        std::array<std::uint32_t, 2> shares{};
        for (std::size_t k = 0; k < 2; ++k)
            shares[k] = static_cast<std::uint32_t>(
                (std::uint64_t{piece.shares[k]} + piece.shares[2 + k] + piece.shares[4 + k]) / 3);
        return {place_on(surface_->triangles[piece.triangle], shares[0], shares[1]), piece.triangle};
    }

    std::shared_ptr<const FixedSurface> surface_;
    StreamKey stream_;
    contract::surface::SurfaceRule rule_{};
    std::map<Cell, std::vector<SurfaceSpot>> cells_;
    std::vector<SurfacePiece> pieces_;
    SurfacePieceChoice choice_;
};

}

SurfacePoint surface_dart_on(const FixedSurface& surface, const SurfacePiece& piece, std::uint32_t first,
                             std::uint32_t second)
{
    std::int64_t u = first, v = second;
    if (u + v > std::int64_t{UINT32_MAX}) {
        u = UINT32_MAX - u;
        v = UINT32_MAX - v;
    }
    SurfacePoint dart{};
    dart.triangle = piece.triangle;
    for (std::size_t k = 0; k < 2; ++k) {
        const std::int64_t origin = piece.shares[k];
        const std::int64_t sum = (piece.shares[2 + k] - origin) * u + (piece.shares[4 + k] - origin) * v;
        dart.shares[k] = static_cast<std::uint32_t>(origin + (sum >> 32));
    }
    const MeshPlace place = place_on(surface.triangles[dart.triangle], dart.shares[0], dart.shares[1]);
    for (std::size_t k = 0; k < 3; ++k) dart.place[k] = static_cast<std::int32_t>(place[k]);
    return dart;
}

SurfacePoint surface_dart(const FixedSurface& surface, const std::vector<SurfacePiece>& pieces,
                          const SurfacePieceChoice& choice, const StreamKey& stream, std::uint64_t number)
{
    const auto words =
        philox({static_cast<std::uint32_t>(number), static_cast<std::uint32_t>(number >> 32), 0, 0}, stream);
    return surface_dart_on(surface, pieces[choice.piece(std::uint64_t{words[0]} << 32 | words[1])], words[2], words[3]);
}

std::unique_ptr<SurfaceDartEngine> surface_dart_engine(const SurfaceDartRequest& request)
{
    return std::make_unique<PlainSurfaceDarts>(request);
}

}
