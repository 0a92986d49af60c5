#include "experiment/measuring/region_series.hpp"

#include "analysis/regions/region_curves.hpp"
#include "analysis/regions/region_distances.hpp"
#include "analysis/regions/region_tapers.hpp"
#include "analysis/regions/region_transform.hpp"
#include "analysis/regions/taper_covariance.hpp"
#include "base/regions/region_source.hpp"
#include "results/file_names.hpp"
#include "results/pictures/mark_picture.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace poissonlab {
namespace {

constexpr double longest_side = 4096; ///< of the picture: its numbers have two decimals
constexpr std::size_t most_dots = 100'000;

/// Draws outlines and holes as lines, points as disks; of more than some 100,000 the first ones.
MarkPicture region_picture_of(const FramedRegion& region, const PointSet& points)
{
    const RegionBox box = box_of(region.polygons());
    const double margin = longest_side / 100, scale = (longest_side - 2 * margin) / box.longest();
    const auto placed = [&](double x, double y) {
        return std::array{margin + (x - box.low[0]) * scale, margin + (y - box.low[1]) * scale};
    };
    MarkPicture picture{box.width() * scale + 2 * margin, box.height() * scale + 2 * margin};
    MarkGroup lines{"#8a8f98"}, dots{"#000000"};
    for (const RegionEdge& e : region.boundary().edges()) {
        const auto [x0, y0] = placed(e.from[0], e.from[1]);
        const auto [x1, y1] = placed(e.to[0], e.to[1]);
        lines.strokes.push_back({x0, y0, x1, y1, longest_side / 500});
    }
    const double spacing = region.unit_length() / std::sqrt(static_cast<double>(points.size()));
    const double radius = std::min(spacing * scale / 5, longest_side / 200);
    for (std::size_t i = 0; i < std::min(points.size(), most_dots); ++i) {
        const auto [x, y] = placed(points[i][0], points[i][1]);
        dots.disks.push_back({x, y, radius});
    }
    picture.groups = {std::move(lines), std::move(dots)};
    return picture;
}

std::vector<double> powers_of_rings(const std::vector<RadialBin>& curve)
{
    std::vector<double> powers;
    for (const RadialBin& ring : curve) powers.push_back(ring.power);
    return powers;
}

class RegionSeriesOf final : public RegionSeries
{
public:
    explicit RegionSeriesOf(const RegionOptions& options) : options_(options) {}

    NearestDistances nearest(const PointSet& points) const override
    {
        const auto [least, mean] = nearest_in_plane(points, region());
        return {least / region().unit_length(), mean / region().unit_length()};
    }

    void start_spectrum(SpectrumEstimate& estimate, int size, PeriodogramMethod method) override
    {
        const bool is_exact = method == PeriodogramMethod::exact;
        if (options_.tapers) {
            tapered_ = std::make_shared<TaperedPeriodogram>(options_.region, options_.tapers, size, is_exact);
            return;
        }
        const auto periodogram = std::make_shared<RegionPeriodogram>(options_.region, size, is_exact);
        estimate.compute_by(
            [periodogram](const PointSet& points, HalfSpectrum& power) { periodogram->compute(points, power); });
    }

    void add_to(SpectrumEstimate& estimate, const PointSet& points) const override
    {
        if (!tapered_) return estimate.add(points);
        for (std::size_t taper = 0; taper < tapers(); ++taper) {
            estimate.compute_by(
                [this, taper](const PointSet& set, HalfSpectrum& power) { tapered_->compute(set, taper, power); });
            estimate.add(points);
        }
    }

    std::size_t tapers() const override { return tapered_ ? options_.tapers->count() : 0; }

    std::vector<double> ring_errors(const std::vector<RadialBin>& curve, int size, double bin_width) const override
    {
        return covariance().of_rings(size, bin_width).errors(powers_of_rings(curve));
    }

    CurveErrors curve_errors(const std::vector<RadialBin>& mean, int size) const override
    {
        return {powers_of_rings(mean),
                [rings = covariance().of_rings(size, 1)](const auto& curve, const CurveErrors::Statistic& statistic) {
                    return rings.error_of(curve, statistic);
                }};
    }

    void start_curves(std::size_t points) override
    {
        curves_.emplace(options_.region, options_.density, points, options_.envelope);
    }

    void leave_out_curves() override { curves_.reset(); }
    bool has_curves() const override { return curves_.has_value(); }

    void add(const PointSet& points, const std::string& name) override
    {
        if (curves_) curves_->add(points, name);
    }

    void append(const RegionSeries& next) override
    {
        if (curves_) curves_->append(dynamic_cast<const RegionSeriesOf&>(next).curves_.value());
    }

    std::vector<RegionCurveRow> rows() const override
    {
        return curves_ ? curves_->rows() : std::vector<RegionCurveRow>{};
    }

    std::vector<PairCorrelationBin> pair_correlation(const std::vector<std::size_t>& groups) const override
    {
        return curves_ ? curves_->pair_correlation(groups) : std::vector<PairCorrelationBin>{};
    }

    RegionResult result() const override
    {
        RegionResult result;
        result.name = region().name();
        result.area = region().own_area();
        result.unit_length = region().unit_length() * region().side();
        for (const RegionEdge& e : region().boundary().edges())
            result.perimeter += std::hypot(e.to[0] - e.from[0], e.to[1] - e.from[1]) * region().side();
        result.polygons = region().polygons().polygons.size();
        result.corners = corner_count(region().polygons());
        result.is_in_metres = is_mapped(region().own_polygons());
        result.has_density = options_.density != nullptr;
        result.tapers = tapers();
        if (!curves_ || curves_->distances().count == 0) return result;
        result.envelope = options_.envelope;
        result.covariance_error = curves_->covariance().table_error();
        result.file = file_names::region_curves;
        return result;
    }

    std::string picture(const PointSet& points) const override
    {
        return mark_picture_json(region_picture_of(region(), points));
    }

    void write(ByteWriter& archive) const override
    {
        if (curves_) archive(*curves_);
    }

    void read(ByteReader& archive) override
    {
        if (curves_) archive(*curves_);
    }

private:
    const FramedRegion& region() const { return *options_.region; }

    const TaperCovariance& covariance() const
    {
        if (!covariance_) covariance_.emplace(*options_.tapers);
        return *covariance_;
    }

    RegionOptions options_;
    std::shared_ptr<TaperedPeriodogram> tapered_;       ///< with tapers
    mutable std::optional<TaperCovariance> covariance_; ///< once it was asked for
    std::optional<RegionCurves> curves_;
};

}

std::unique_ptr<RegionSeries> make_region_series(const RegionOptions& options)
{
    return std::make_unique<RegionSeriesOf>(options);
}

}
