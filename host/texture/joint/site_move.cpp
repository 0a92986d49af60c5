#include "host/texture/joint/site_move.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace poissonlab {
namespace {

bool is_beside(SourcePixel first, SourcePixel second, Neighbour neighbour)
{
    const bool is_east = neighbour == Neighbour::east;
    return second.x == first.x + (is_east ? 1 : 0) && second.y == first.y + (is_east ? 0 : 1);
}

}

SiteMove::SiteMove(const Assembly& assembly, const Site& site, const SiteBox& box)
    : assembly_(assembly), site_(site), box_(box), layers_(layers())
{
    add_pairs(add_pixels());
}

/// The largest number of tiles that lie at the same place.
int SiteMove::layers() const
{
    std::map<std::pair<int, int>, int> counts;
    int most = 1;
    for (const PlacedTile& tile : site_.tiles) most = std::max(most, ++counts[{tile.x, tile.y}]);
    return most;
}

/// Pixels that are shown elsewhere as well, by other tiles than the site's, stay as they are.
bool SiteMove::may_change(std::size_t pixel, int x, int y) const
{
    const SetCover& cover = assembly_.cover();
    if (cover.is_own(pixel) || site_.kind == Site::Kind::corner) return true;
    if (site_.kind == Site::Kind::tile || cover.is_corner(pixel)) return false;
    const int across = site_.kind == Site::Kind::vertical_edge ? x : y;
    return across >= -cover.ring() && across < cover.ring();
}

SiteMove::PixelPlaces SiteMove::add_pixels()
{
    PixelPlaces places;
    const SetCover& cover = assembly_.cover();
    for (const PlacedTile& tile : site_.tiles)
        for (int y = std::max(box_.y, tile.y); y < std::min(box_.y + box_.side, tile.y + cover.size()); ++y)
            for (int x = std::max(box_.x, tile.x); x < std::min(box_.x + box_.side, tile.x + cover.size()); ++x) {
                const std::size_t pixel = cover.pixel(tile.tile, x - tile.x, y - tile.y);
                if (!may_change(pixel, x, y)) continue;
                const auto [place, is_new] = places.insert({pixel, static_cast<int>(pixels_.size())});
                if (is_new) pixels_.push_back({pixel, x, y, x - tile.x, y - tile.y, 0});
                ++pixels_[static_cast<std::size_t>(place->second)].tiles;
            }
    return places;
}

void SiteMove::add_pairs(const PixelPlaces& places)
{
    const SetCover& cover = assembly_.cover();
    const int last = cover.size() - 1;
    std::map<std::tuple<std::size_t, std::size_t, Neighbour>, int> shared; // of pixels that several tiles have
    const auto place_of = [&](std::size_t pixel) {
        const auto found = places.find(pixel);
        return found == places.end() ? -1 : found->second;
    };
    const auto add = [&](std::size_t first, std::size_t second, Neighbour neighbour) {
        if (place_of(first) < 0 && place_of(second) < 0) return;
        if (cover.is_own(first) || cover.is_own(second))
            pairs_.push_back({first, second, place_of(first), place_of(second), neighbour, 1});
        else
            ++shared[{first, second, neighbour}];
    };
    for (const PlacedTile& tile : site_.tiles)
        for (int y = std::max(0, box_.y - tile.y - 1); y <= std::min(last, box_.y + box_.side - 1 - tile.y); ++y)
            for (int x = std::max(0, box_.x - tile.x - 1); x <= std::min(last, box_.x + box_.side - 1 - tile.x); ++x) {
                const std::size_t here = cover.pixel(tile.tile, x, y);
                add(here, cover.pixel(tile.tile, x + 1, y), Neighbour::east);
                add(here, cover.pixel(tile.tile, x, y + 1), Neighbour::south);
            }
    for (const auto& [pair, tiles] : shared) {
        const auto& [first, second, neighbour] = pair;
        pairs_.push_back({first, second, place_of(first), place_of(second), neighbour, tiles});
    }
}

PngPixels SiteMove::canvas(const PngPixels& picture) const
{
    const SetCover& cover = assembly_.cover();
    const auto channels = static_cast<std::size_t>(picture.channels);
    const auto places = static_cast<std::size_t>(box_.side) * static_cast<std::size_t>(box_.side);
    std::vector<int> sums(places * channels), counts(places);
    for (const PlacedTile& tile : site_.tiles)
        for (int y = std::max(box_.y, tile.y); y < std::min(box_.y + box_.side, tile.y + cover.size()); ++y)
            for (int x = std::max(box_.x, tile.x); x < std::min(box_.x + box_.side, tile.x + cover.size()); ++x) {
                const SourcePixel source = assembly_.source(cover.pixel(tile.tile, x - tile.x, y - tile.y));
                const auto place = static_cast<std::size_t>((y - box_.y) * box_.side + x - box_.x);
                ++counts[place];
                for (std::size_t c = 0; c < channels; ++c)
                    sums[place * channels + c] += picture.values[picture.at(source.x, source.y, static_cast<int>(c))];
            }
    PngPixels mean{box_.side, box_.side, picture.channels, {}};
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const int count = std::max(1, counts[i / channels]);
        mean.values.push_back(static_cast<std::uint8_t>((sums[i] + count / 2) / count));
    }
    return mean;
}

std::vector<SiteMove::Option> SiteMove::options(const Overlay& overlay,
                                                const std::function<bool(int x, int y)>& is_taken) const
{
    std::vector<Option> options;
    options.reserve(pixels_.size());
    int nodes = 0;
    for (const Pixel& pixel : pixels_) {
        Option& option = options.emplace_back();
        option.kept = assembly_.source(pixel.number);
        const int x = overlay.x + pixel.x, y = overlay.y + pixel.y;
        if (x < 0 || y < 0 || x >= assembly_.exemplar().width || y >= assembly_.exemplar().height) continue;
        option.taken = {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)};
        option.levels = assembly_.levels(option.kept, option.taken);
        option.is_taken = is_taken && is_taken(pixel.x, pixel.y);
        // A pixel that shows the window already has no choice.
        if (!option.is_taken && option.taken != option.kept) option.node = nodes++;
    }
    return options;
}

SiteChange SiteMove::best(const Overlay& overlay, const std::function<bool(int x, int y)>& is_taken) const
{
    std::vector<Option> all = options(overlay, is_taken);
    const auto nodes = std::ranges::count_if(all, [](const Option& option) { return option.node >= 0; });
    ExpansionMove move(static_cast<std::size_t>(nodes));
    for (std::size_t i = 0; i < all.size(); ++i)
        if (all[i].node >= 0)
            move.add_pixel(static_cast<std::size_t>(all[i].node), 0,
                           std::llround(assembly_.change_cost(changed(pixels_[i], all[i].taken), layers_)));
    for (const Pair& pair : pairs_) add_pair(move, pair, all);
    const ExpansionMove::Choice choice = move.best();
    SiteChange change;
    const std::vector<std::uint8_t> none(choice.taken.size(), 0);
    change.gain = static_cast<double>(move.cost(none) - choice.cost);
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].node >= 0) all[i].is_taken = choice.taken[static_cast<std::size_t>(all[i].node)] != 0;
        if (all[i].is_taken && all[i].taken != all[i].kept) change.pixels.push_back(changed(pixels_[i], all[i].taken));
    }
    change.seam_gain = seam_gain(all);
    return change;
}

ChangedPixel SiteMove::changed(const Pixel& pixel, SourcePixel source)
{
    return {pixel.number, source, pixel.tile_x, pixel.tile_y, pixel.tiles};
}

SiteMove::Option SiteMove::option_of(const std::vector<Option>& all, int place, std::size_t pixel) const
{
    if (place >= 0) return all[static_cast<std::size_t>(place)];
    Option fixed;
    fixed.kept = assembly_.source(pixel);
    return fixed;
}

PairChoice SiteMove::costs(const Pair& pair, const Option& first, const Option& second) const
{
    if (is_beside(first.kept, second.kept, pair.neighbour)) {
        // The usual case: both show one window, and may show another one.
        const std::int64_t apart = pair.tiles * assembly_.cost_of_levels(first.levels + second.levels, pair.neighbour);
        return {0, apart, apart, 0};
    }
    const auto cost = [&](SourcePixel a, SourcePixel b) {
        return pair.tiles * assembly_.seam_cost(a, b, pair.neighbour);
    };
    return {cost(first.kept, second.kept), cost(first.kept, second.taken), cost(first.taken, second.kept),
            cost(first.taken, second.taken)};
}

void SiteMove::add_pair(ExpansionMove& move, const Pair& pair, const std::vector<Option>& all) const
{
    const Option first = option_of(all, pair.first_in_pixels, pair.first),
                 second = option_of(all, pair.second_in_pixels, pair.second);
    if (first.node >= 0 && second.node >= 0) {
        const PairChoice its = costs(pair, first, second);
        if (its != PairChoice{})
            move.add_pair(static_cast<std::size_t>(first.node), static_cast<std::size_t>(second.node), its);
        return;
    }
    const auto cost = [&](SourcePixel a, SourcePixel b) {
        return pair.tiles * assembly_.seam_cost(a, b, pair.neighbour);
    };
    if (first.node >= 0)
        move.add_pixel(static_cast<std::size_t>(first.node), cost(first.kept, second.shown()),
                       cost(first.taken, second.shown()));
    else if (second.node >= 0)
        move.add_pixel(static_cast<std::size_t>(second.node), cost(first.shown(), second.kept),
                       cost(first.shown(), second.taken));
}

std::int64_t SiteMove::seam_gain(const std::vector<Option>& all) const
{
    std::int64_t gain = 0;
    for (const Pair& pair : pairs_) {
        const Option first = option_of(all, pair.first_in_pixels, pair.first),
                     second = option_of(all, pair.second_in_pixels, pair.second);
        if (!first.is_taken && !second.is_taken) continue;
        gain += pair.tiles * (assembly_.seam_cost(first.kept, second.kept, pair.neighbour) -
                              assembly_.seam_cost(first.shown(), second.shown(), pair.neighbour));
    }
    return gain;
}

std::vector<Overlay> SiteMove::shown() const
{
    std::map<std::pair<int, int>, int> overlays;
    for (const Pixel& pixel : pixels_) {
        const SourcePixel source = assembly_.source(pixel.number);
        ++overlays[{source.x - pixel.x, source.y - pixel.y}];
    }
    std::vector<Overlay> all;
    for (const auto& [place, count] : overlays) all.push_back({place.first, place.second});
    return all;
}

namespace {

/// The places where boxes of a site may begin, from the first ones to the last ones.
struct BoxRange
{
    int left, top, right, bottom;
};

/// The costs of the seams of a site where boxes lie, summed from the corner (-T, -T) of all that it shows to each
/// place.
class SeamMap
{
public:
    SeamMap(const Assembly& assembly, const Site& site, const BoxRange& range, int side)
        : size_(assembly.cover().size()), line_(static_cast<std::size_t>(2 * size_ + 1)), sums_(line_ * line_)
    {
        for (const PlacedTile& tile : site.tiles) add_seams(assembly, tile, range, side);
        for (std::size_t i = line_ + 1; i < sums_.size(); ++i)
            if (i % line_ != 0) sums_[i] += sums_[i - 1] + sums_[i - line_] - sums_[i - line_ - 1];
    }

    std::int64_t cost(const SiteBox& box) const
    {
        const int right = box.x + box.side, below = box.y + box.side;
        return sums_[at(right, below)] - sums_[at(box.x, below)] - sums_[at(right, box.y)] + sums_[at(box.x, box.y)];
    }

private:
    /// The place of the sum of all that is west and north of a place.
    std::size_t at(int x, int y) const
    {
        return static_cast<std::size_t>(y + size_) * line_ + static_cast<std::size_t>(x + size_);
    }

    void add_seams(const Assembly& assembly, const PlacedTile& tile, const BoxRange& range, int side)
    {
        const SetCover& cover = assembly.cover();
        const int right = std::min(size_, range.right + side - tile.x),
                  bottom = std::min(size_, range.bottom + side - tile.y);
        for (int y = std::max(0, range.top - tile.y); y < bottom; ++y)
            for (int x = std::max(0, range.left - tile.x); x < right; ++x) {
                const SourcePixel here = assembly.source(cover.pixel(tile.tile, x, y)),
                                  east = assembly.source(cover.pixel(tile.tile, x + 1, y)),
                                  south = assembly.source(cover.pixel(tile.tile, x, y + 1));
                sums_[at(x + tile.x + 1, y + tile.y + 1)] +=
                    assembly.seam_cost(here, east, Neighbour::east) + assembly.seam_cost(here, south, Neighbour::south);
            }
    }

    int size_;
    std::size_t line_;
    std::vector<std::int64_t> sums_;
};

}

std::optional<SiteBox> dearest_box(const Assembly& assembly, const Site& site, int side, const BoxPlaces& left_out)
{
    const int half = assembly.cover().size() / 2, step = std::max(1, half / 4);
    const bool is_fixed_x = site.kind == Site::Kind::corner || site.kind == Site::Kind::vertical_edge;
    const bool is_fixed_y = site.kind == Site::Kind::corner || site.kind == Site::Kind::horizontal_edge;
    const BoxRange range{is_fixed_x ? -side / 2 : -half, is_fixed_y ? -side / 2 : -half,
                         is_fixed_x ? -side / 2 : half - side, is_fixed_y ? -side / 2 : half - side};
    const SeamMap map(assembly, site, range, side);
    std::pair<std::int64_t, std::optional<SiteBox>> dearest; // and its cost
    for (int y = range.top; y <= range.bottom; y += step)
        for (int x = range.left; x <= range.right; x += step) {
            const std::int64_t cost = left_out.contains({x, y}) ? 0 : map.cost({x, y, side});
            if (cost > dearest.first) dearest = {cost, SiteBox{x, y, side}};
        }
    return dearest.second;
}

}
