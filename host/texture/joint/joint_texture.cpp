// Texture tiles whose patches and cuts are chosen for the whole set together.
//
// D. = Lagae, Tile-Based Methods in Computer Graphics, 2007, section 5.3, and the papers before it fit one piece after
// another. Here all pixels of a set, those that tiles share once, are one problem: seams of all tiles, and the power of
// their mean, which tilings repeat. Patches of corners are chosen by all their pairs; pieces over edges and in tiles
// begin as they do one by one; then windows that fit what is there are laid over the dearest place of each corner, edge
// and tile, large and small in turn, and cut into all tiles at once by expansion moves (Boykov and others 2001; Kwatra
// and others 2003, section 4, hide seams by more windows in the same way). At last every window that a tile shows may
// grow or shrink in it. No move after the first pieces makes the sum dearer.
//
// Wang tiles have a common corner in this way, and fit there; the articles' do not.
#include "host/texture/corner_texture.hpp"
#include "host/texture/joint/assembly.hpp"
#include "host/texture/joint/feature_map.hpp"
#include "host/texture/joint/joint_patches.hpp"
#include "host/texture/joint/site_move.hpp"
#include "host/texture/joint/window_search.hpp"
#include "host/texture/seam_blending.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <memory>

namespace poissonlab {
namespace {

/// Sides of the windows that are laid over the dearest places, in eighths of T, one after the other. Each has so many
/// rounds, in which no place is tried twice: what was tried without success may fit later, when what is around it has
/// changed.
constexpr std::array<int, 3> sides_in_turn{4, 2, 3};
constexpr int rounds_a_side = 4;

/// So many windows are cut for each place.
constexpr int windows_a_place = 6;

/// Slopes count half as much as colours where patches and first pieces are compared.
constexpr double matched_slopes = 0.5;

/// Moves of so many sites are looked for at a time.
constexpr std::size_t sites_at_once = 16;

/// So many of the moves of a site are kept until one of them is made.
constexpr std::size_t kept_moves = 8;

/// The weight of lines of steep or flat windows in smooth pictures. In 20 pictures of waves of 40 pixels and more, 4
/// reduced the steps across the worst line of tiles of 32 pixels from 1.56 natural ones to 1.25, on average. With 30
/// and 100 they were 1.19 and 1.18, but colours differed so much at seams that blending took a fifth of the contrast.
constexpr double line_weight = 4;

Assembly::Weights weights_of(const PngPixels& exemplar)
{
    Assembly::Weights weights;
    if (is_smooth(exemplar)) weights.lines = line_weight;
    return weights;
}

/// A square with round corners around (0, 0).
bool is_in_rounded_box(double x, double y, double half_width, double half_height)
{
    if (half_width <= 0 || half_height <= 0) return false;
    const double u = x / half_width, v = y / half_height;
    return u * u * u * u + v * v * v * v < 1;
}

/// A window that may be laid over a site, and what that comes to: see SiteChange.
struct Candidate
{
    ExemplarWindow window;
    std::vector<ChangedRun> pixels;
    std::int64_t seam_gain = 0;
    double gain = 0;
};

/// A window that was laid over a box of a site.
struct LaidWindow
{
    ExemplarWindow window;
    const Site* site = nullptr;
    SiteBox box;
};

/// Says whether a pixel of the exemplar lies in a window: a patch that has grown beyond it shows another part.
auto is_in(const ExemplarWindow& window)
{
    return [&window](const SourcePixel& source) {
        return source.x >= window.x && source.x < window.x + window.size && source.y >= window.y &&
               source.y < window.y + window.size;
    };
}

/// True for places of a site, pixels east and south of its middle.
using PlaceTest = std::function<bool(int x, int y)>;

/// First pieces: the box that they lie in, the part that shows them in any case, and that in which they are compared.
struct FirstPiece
{
    SiteBox box;
    PlaceTest is_taken, is_compared;

    std::vector<std::uint8_t> counts() const
    {
        std::vector<std::uint8_t> counts;
        for (int y = box.y; y < box.y + box.side; ++y)
            for (int x = box.x; x < box.x + box.side; ++x) counts.push_back(is_compared(x, y) && !is_taken(x, y));
        return counts;
    }
};

/// Makes the first piece over the joint of two patches, as long as three quarters of T.
FirstPiece edge_piece(const TextureRequest& request, bool is_vertical)
{
    const int size = request.size, reach = size / 2 - std::max(size / 8, request.ring_pixels());
    const double core = request.core_radius() / default_core;
    const auto is_in = [=](int x, int y, double half_length, double half_width) {
        return is_in_rounded_box((is_vertical ? y : x) + 0.5, (is_vertical ? x : y) + 0.5, half_length, half_width);
    };
    const auto is_taken = [=](int x, int y) {
        const int along = is_vertical ? y : x, across = is_vertical ? x : y;
        const bool is_joint = (along == -1 || along == 0) && std::abs(across + 0.5) < size / 8.0 - 1;
        return is_joint || is_in(x, y, core * 0.8 * reach, core * 0.06 * size);
    };
    return {{-reach, -reach, 2 * reach}, is_taken, [=](int x, int y) { return is_in(x, y, reach, size / 5.0); }};
}

FirstPiece middle_piece(const TextureRequest& request)
{
    const int size = request.size;
    const double core = request.core_radius() * size, reach = size / 2.0 - request.ring_pixels();
    return {{-size / 2, -size / 2, size},
            [=](int x, int y) { return is_in_rounded_box(x + 0.5, y + 0.5, core, core); },
            [=](int x, int y) { return is_in_rounded_box(x + 0.5, y + 0.5, reach, reach); }};
}

class JointTexture
{
public:
    JointTexture(const PngPixels& exemplar, const TextureRequest& request, const std::vector<TextureTile>& tiles,
                 const PieceProgress& progress)
        : exemplar_(exemplar), request_(request), progress_(progress), features_(feature_map(exemplar, matched_slopes)),
          cover_(set_parts(request, tiles), request.size, request.ring_pixels()), sites_(sites_of(cover_)),
          tried_(sites_.size()), waves_(fitting_waves(exemplar, request.size)),
          assembly_(exemplar, cover_, weights_of(exemplar), waves_), used_(distance())
    {}

    TextureSources make()
    {
        show_patches();
        const std::size_t all = sites_.size();
        lay_first(Site::Kind::vertical_edge, edge_piece(request_, true), all, "vertical edges");
        lay_first(Site::Kind::horizontal_edge, edge_piece(request_, false), all, "horizontal edges");
        lay_first(Site::Kind::tile, middle_piece(request_), sites_at_once, "interiors");
        for (int round = 0; round < request_.rounds;) {
            const int eighths = sides_in_turn[static_cast<std::size_t>(round / rounds_a_side) % sides_in_turn.size()];
            const WindowSearch search(exemplar_, std::max(4, request_.size * eighths / 16 * 2));
            for (BoxPlaces& places : tried_) places.clear();
            for (int i = 0; i < rounds_a_side && round < request_.rounds; ++i) improve_all(search, ++round);
        }
        settle();
        return finished();
    }

private:
    void tell_round(int round) const
    {
        progress_("rounds that look for better pieces", static_cast<std::size_t>(round),
                  static_cast<std::size_t>(request_.rounds));
    }

    void improve_all(const WindowSearch& search, int round)
    {
        // The corner of Wang tiles stays one window: its pixels are what all tiles have in common.
        if (request_.has_corners()) improve(Site::Kind::corner, search, round);
        improve(Site::Kind::vertical_edge, search, round);
        improve(Site::Kind::horizontal_edge, search, round);
        improve(Site::Kind::tile, search, round);
        tell_round(round);
    }

    int distance() const
    {
        const SetParts& parts = cover_.parts();
        const std::size_t windows =
            parts.corners + parts.vertical.size() + parts.horizontal.size() + parts.tiles.size();
        return window_distance(exemplar_, request_.size, windows, request_.diversity);
    }

    /// Sites of a kind that some tile shows.
    std::vector<const Site*> sites_of_kind(Site::Kind kind) const
    {
        std::vector<const Site*> found;
        for (const Site& site : sites_)
            if (site.kind == kind && !site.tiles.empty()) found.push_back(&site);
        return found;
    }

    /// Every tile shows the patches of its corners, a quarter each.
    void show_patches()
    {
        const SetParts& parts = cover_.parts();
        JointPatches chosen = joint_patches(exemplar_, features_, request_, parts, used_.distance(), waves_);
        patches_ = std::move(chosen.patches);
        rule_ = std::move(chosen.rule);
        if (!chosen.note.empty()) notes_.push_back(std::move(chosen.note));
        for (const ExemplarWindow& patch : patches_) used_.add(patch);
        const int size = request_.size, half = size / 2;
        for (std::size_t tile = 0; tile < parts.tiles.size(); ++tile)
            for (int y = 0; y <= size; ++y)
                for (int x = 0; x <= size; ++x) {
                    const std::size_t corner = (y < half ? 0u : 2u) + (x < half ? 0u : 1u);
                    const ExemplarWindow& patch = patches_[parts.tiles[tile].corners[corner]];
                    const int dx = x < half ? x : x - size, dy = y < half ? y : y - size;
                    assembly_.show(cover_.pixel(tile, x, y), {static_cast<std::uint16_t>(patch.x + half + dx),
                                                              static_cast<std::uint16_t>(patch.y + half + dy)});
                }
        assembly_.count_tiles();
    }

    /// Makes the test of which windows may lie over a box of a site.
    WindowTest test_at(const Site& site, const SiteBox& box) const
    {
        const double half = request_.size / 2.0, reach = box.side / 2.0;
        const bool is_east = site.kind == Site::Kind::horizontal_edge || site.kind == Site::Kind::tile;
        const bool is_south = site.kind == Site::Kind::vertical_edge || site.kind == Site::Kind::tile;
        return window_test(rule_, (is_east ? half : 0) + box.x + reach, (is_south ? half : 0) + box.y + reach);
    }

    /// The moves of the windows that look most like what is in a box that gain most, the best first. New windows are
    /// not near those that are shown there, unless something is taken in any case.
    std::vector<Candidate> candidates(const Site& site, const SiteBox& box, const WindowSearch& search, int count,
                                      const UsedWindows& used, const PlaceTest& is_taken = {}) const
    {
        const SiteMove move(assembly_, site, box);
        std::vector<ExemplarWindow> shown;
        if (!is_taken)
            for (const Overlay& overlay : move.shown())
                shown.push_back({overlay.x + box.x, overlay.y + box.y, box.side});
        const std::vector<ExemplarWindow> windows =
            search.best(move.canvas(search.features()), used, shown, count, test_at(site, box));
        std::vector<Candidate> found(windows.size());
        tbb::parallel_for(std::size_t{0}, windows.size(), [&](std::size_t i) {
            const SiteChange change = move.best({windows[i].x - box.x, windows[i].y - box.y}, is_taken);
            found[i] = {windows[i], runs_of(change.pixels), change.seam_gain, change.gain};
        });
        std::ranges::stable_sort(found, std::greater{}, &Candidate::gain);
        if (found.size() > kept_moves) found.resize(kept_moves);
        return found;
    }

    /// Lays first pieces over all sites of a kind, so many being chosen by what is shown before any of them is; each is
    /// as far from all others as diversity asks, unless windows have phases.
    void lay_first(Site::Kind kind, const FirstPiece& piece, std::size_t at_once, const std::string& stage)
    {
        const std::vector<const Site*> sites = sites_of_kind(kind);
        const WindowSearch search(features_, piece.box.side, piece.counts());
        const auto look = [&](const Site& site) {
            return candidates(site, piece.box, search, request_.candidates, used_, piece.is_taken);
        };
        for (std::size_t first = 0; first < sites.size(); first += at_once) {
            std::vector<std::vector<Candidate>> found(std::min(at_once, sites.size() - first));
            for (std::size_t begin = 0; begin < found.size(); begin += sites_at_once) {
                const std::size_t end = std::min(begin + sites_at_once, found.size());
                tbb::parallel_for(begin, end, [&](std::size_t i) { found[i] = look(*sites[first + i]); });
                progress_(stage, first + end, sites.size());
            }
            for (std::size_t i = 0; i < found.size(); ++i) {
                const auto is_free = [&](const Candidate& each) { return used_.is_free(each.window); };
                if (std::ranges::none_of(found[i], is_free)) {
                    progress_(stage, first + found.size(), sites.size());
                    found[i] = look(*sites[first + i]);
                }
                auto best = std::ranges::find_if(found[i], is_free);
                // Few windows have a phase: where none is left that is far from others, one near them is taken.
                if (best == found[i].end() && !rule_.is_empty()) {
                    found[i] = candidates(*sites[first + i], piece.box, search, request_.candidates, UsedWindows(0),
                                          piece.is_taken);
                    best = found[i].begin();
                }
                if (best == found[i].end()) continue;
                assembly_.change(pixels_of(best->pixels));
                used_.add(best->window);
                laid_.push_back({best->window, sites[first + i], piece.box});
                found[i] = {};
            }
        }
    }

    /// Changes what is shown if that makes everything cheaper, by all costs as they are now.
    bool take(const std::vector<ChangedPixel>& pixels, std::int64_t seam_gain)
    {
        if (static_cast<double>(seam_gain) + assembly_.sums_gain(pixels) <= 0) return false;
        assembly_.change(pixels);
        return true;
    }

    /// Lays a window over the dearest box of each site that was not tried before.
    void improve(Site::Kind kind, const WindowSearch& search, int round)
    {
        const std::vector<const Site*> sites = sites_of_kind(kind);
        for (std::size_t first = 0; first < sites.size(); first += sites_at_once) {
            std::vector<std::vector<Candidate>> found(std::min(sites_at_once, sites.size() - first));
            std::vector<SiteBox> boxes(found.size());
            tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t i) {
                const Site& site = *sites[first + i];
                BoxPlaces& tried = tried_[static_cast<std::size_t>(&site - sites_.data())];
                const auto box = dearest_box(assembly_, site, search.side(), tried);
                if (!box) return;
                tried.insert({box->x, box->y});
                boxes[i] = *box;
                found[i] =
                    candidates(site, *box, search, windows_a_place, UsedWindows(0)); // small ones may be near others
            });
            for (std::size_t i = 0; i < found.size(); ++i)
                for (const Candidate& candidate : found[i])
                    if (take(pixels_of(candidate.pixels), candidate.seam_gain)) {
                        laid_.push_back({candidate.window, sites[first + i], boxes[i]});
                        break;
                    }
            tell_round(round - 1);
        }
    }

    /// Every window that a tile shows may grow or shrink in it: one cycle of expansion moves over all its labels.
    void settle()
    {
        const std::vector<const Site*> sites = sites_of_kind(Site::Kind::tile);
        const SiteBox whole{-request_.size / 2, -request_.size / 2, request_.size};
        for (std::size_t first = 0; first < sites.size(); first += sites_at_once) {
            const std::size_t count = std::min(sites_at_once, sites.size() - first);
            std::vector<std::unique_ptr<SiteMove>> moves(count);
            std::vector<std::vector<Overlay>> shown(count);
            tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
                moves[i] = std::make_unique<SiteMove>(assembly_, *sites[first + i], whole);
                shown[i] = moves[i]->shown();
            });
            std::size_t most = 0;
            for (const std::vector<Overlay>& overlays : shown) most = std::max(most, overlays.size());
            for (std::size_t k = 0; k < most; ++k) {
                std::vector<SiteChange> changes(count);
                tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
                    if (k < shown[i].size()) changes[i] = moves[i]->best(shown[i][k]);
                });
                for (const SiteChange& change : changes) take(change.pixels, change.seam_gain);
            }
            progress_("whole tiles", first + count, sites.size());
        }
    }

    TextureSources finished() const
    {
        TextureSources result{{}, assembly_.seams(), patches_, patches_.size()};
        result.notes = notes_;
        // Each tile has a list of its sources for each place of the exemplar that lies over its corner.
        std::vector<std::map<std::pair<int, int>, std::vector<SourcePixel>>> shown(cover_.parts().tiles.size());
        for (std::size_t tile = 0; tile < shown.size(); ++tile)
            for (int y = 0; y < request_.size; ++y)
                for (int x = 0; x < request_.size; ++x) {
                    const SourcePixel source = assembly_.source(cover_.pixel(tile, x, y));
                    result.sources.push_back(source);
                    shown[tile][{source.x - x, source.y - y}].push_back(source);
                }
        for (const LaidWindow& laid : laid_)
            if (std::ranges::any_of(laid.site->tiles, [&](const PlacedTile& tile) {
                    const auto there = shown[tile.tile].find(
                        {laid.window.x - laid.box.x + tile.x, laid.window.y - laid.box.y + tile.y});
                    return there != shown[tile.tile].end() && std::ranges::any_of(there->second, is_in(laid.window));
                }))
                result.windows.push_back(laid.window);
        return result;
    }

    const PngPixels& exemplar_;
    const TextureRequest& request_;
    const PieceProgress& progress_;
    PngPixels features_;
    SetCover cover_;
    std::vector<Site> sites_;
    std::vector<BoxPlaces> tried_; ///< by site
    std::vector<RegularWave> waves_;
    Assembly assembly_;
    UsedWindows used_;
    Patches patches_;
    PhaseRule rule_;
    std::vector<std::string> notes_;
    std::vector<LaidWindow> laid_; ///< pieces, of which some are laid over others
};

}

TextureSources make_joint_texture(const PngPixels& exemplar, const TextureRequest& request,
                                  const std::vector<TextureTile>& tiles, const PieceProgress& progress)
{
    return JointTexture(exemplar, request, tiles, progress).make();
}

}
