// Darts of several classes on surfaces, plain and sequential: what the kernels must reproduce.
#include "host/sampling/surfaces/class_surface_darts.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

namespace poissonlab::reference {
namespace {

using contract::class_surface::SurfaceSlot;
using contract::class_surface::TRIES;
using contract::class_surface::TRIES_BEFORE;

class PlainClassSurface final : public ClassSurfaceEngine
{
public:
    explicit PlainClassSurface(const ClassSurfaceRequest& request)
        : surface_(request.surface), stream_(request.stream), cells_(request.distances.classes())
    {}

    void restart(const ClassSurfaceRules& rules, const ClassSurfaceDarts& darts, std::size_t) override
    {
        rules_ = rules;
        for (auto& of_class : cells_) of_class.clear();
        for (std::size_t i = 0; i < darts.points.size(); ++i) add(darts.points[i], darts.classes[i]);
    }

    void set_pieces(const std::vector<ClassPieces>& all, std::size_t) override { open_ = &all; }

    Settled settle(const std::vector<SurfaceSlot>& slots, std::size_t first, std::uint32_t skipped) override
    {
        Settled settled;
        for (std::size_t i = 0; i < slots.size(); ++i) {
            const auto dart = first_free(slots[i], static_cast<std::uint32_t>(first + i), i == 0 ? skipped : 0);
            if (!dart) break;
            add(*dart, slots[i].own);
            settled.points.push_back(*dart);
        }
        return settled;
    }

    std::vector<std::uint32_t> cover(std::uint32_t own) override
    {
        std::vector<std::uint32_t> states;
        for (const SurfacePiece& piece : (*open_)[own].pieces) {
            const bool is_small = is_last(piece) && meets_point(centre_of(piece), own);
            states.push_back(is_covered(piece, own) ? contract::surface::PIECE_COVERED
                             : is_small             ? contract::surface::PIECE_SMALL
                                                    : contract::surface::PIECE_OPEN);
        }
        return states;
    }

private:
    using Cell = std::array<std::int64_t, 3>;

    Cell cell_of(const MeshPlace& place, std::size_t own) const
    {
        const std::int64_t side = rules_[own].cell; // of each class in its column
        return {place[0] / side, place[1] / side, place[2] / side};
    }

    void add(const SurfacePoint& point, std::size_t own)
    {
        cells_[own][cell_of(place_of(point), own)].push_back(point);
    }

    /// Returns nothing where TRIES darts fail.
    std::optional<SurfacePoint> first_free(const SurfaceSlot& slot, std::uint32_t at, std::uint32_t skipped) const
    {
        for (std::uint32_t number = skipped; number < skipped + TRIES; ++number) {
            const SurfacePoint dart = class_surface_dart(*surface_, (*open_)[slot.own], slot, at, number, stream_);
            if (!meets_point(dart, slot.own)) return dart;
        }
        return {};
    }

    /// Calls predicate(point, rule) for all points in the cells around a place that the triangle sees.
    template <typename Predicate>
    bool any_near(const MeshPlace& place, std::uint32_t triangle, std::size_t own, const Predicate& predicate) const
    {
        for (std::size_t other = 0; other < cells_.size(); ++other) {
            const contract::surface::SurfaceRule& rule = rules_[own * cells_.size() + other];
            const Cell at = cell_of(place, other);
            for (int i = 0; i < 27; ++i) {
                const auto found = cells_[other].find({at[0] + i % 3 - 1, at[1] + i / 3 % 3 - 1, at[2] + i / 9 - 1});
                if (found == cells_[other].end()) continue;
                for (const SurfacePoint& point : found->second)
                    if (cosine_between(surface_->triangles[triangle], surface_->triangles[point.triangle]) >=
                            rule.least_cosine &&
                        predicate(place_of(point), rule))
                        return true;
            }
        }
        return false;
    }

    bool meets_point(const SurfacePoint& dart, std::size_t own) const
    {
        const MeshPlace place = place_of(dart);
        return any_near(place, dart.triangle, own, [&](const MeshPlace& point, const auto& rule) {
            return squared_distance(place, point) < rule.squared;
        });
    }

    bool is_covered(const SurfacePiece& piece, std::size_t own) const
    {
        std::array<MeshPlace, 3> corners;
        for (std::size_t i = 0; i < 3; ++i)
            corners[i] = place_on(surface_->triangles[piece.triangle], piece.shares[2 * i], piece.shares[2 * i + 1]);
        return any_near(corners[0], piece.triangle, own, [&](const MeshPlace& point, const auto& rule) {
            return std::ranges::all_of(
                corners, [&](const MeshPlace& corner) { return squared_distance(corner, point) < rule.covered; });
        });
    }

    SurfacePoint centre_of(const SurfacePiece& piece) const
    {
        SurfacePoint centre{};
        centre.triangle = piece.triangle;
        for (std::size_t k = 0; k < 2; ++k)
            centre.shares[k] = static_cast<std::uint32_t>(
                (std::uint64_t{piece.shares[k]} + piece.shares[2 + k] + piece.shares[4 + k]) / 3);
        const MeshPlace place = place_on(surface_->triangles[piece.triangle], centre.shares[0], centre.shares[1]);
        for (std::size_t k = 0; k < 3; ++k) centre.place[k] = static_cast<std::int32_t>(place[k]);
        return centre;
    }

    std::shared_ptr<const FixedSurface> surface_;
    StreamKey stream_;
    ClassSurfaceRules rules_;
    std::vector<std::map<Cell, std::vector<SurfacePoint>>> cells_; ///< of each class
    const std::vector<ClassPieces>* open_ = nullptr;
};

}

SurfacePoint class_surface_dart(const FixedSurface& surface, const ClassPieces& open, const SurfaceSlot& slot,
                                std::uint32_t at, std::uint32_t number, const StreamKey& stream)
{
    const auto words = philox({at, number, slot.own, 0}, stream);
    std::uint64_t upper = words[0];
    if (open.spread > 0 && number < TRIES - TRIES_BEFORE) {
        const std::uint32_t wider = open.spread + 2 * (number / TRIES_BEFORE);
        const std::uint64_t random = (std::uint64_t{1} << std::min(32u, wider)) - 1;
        upper = (slot.target & ~random) | (words[0] & random);
    }
    const SurfacePiece& piece = open.pieces[open.choice.piece(upper << 32 | words[1])];
    return surface_dart_on(surface, piece, words[2], words[3]);
}

std::unique_ptr<ClassSurfaceEngine> class_surface_engine(const ClassSurfaceRequest& request)
{
    return std::make_unique<PlainClassSurface>(request);
}

}
