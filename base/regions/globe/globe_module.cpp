// The module poissonlab_globe: see map_system.cpp.
#include "base/regions/globe/globe_functions.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>
#include <proj.h>

#include <cmath>
#include <limits>
#include <mutex>
#include <numbers>

namespace poissonlab {
namespace {

using ContextHandle = std::unique_ptr<PJ_CONTEXT, decltype(&proj_context_destroy)>;
using SystemHandle = std::unique_ptr<PJ, decltype(&proj_destroy)>;

ContextHandle silent_context()
{
    ContextHandle context(proj_context_create(), proj_context_destroy);
    proj_log_level(context.get(), PJ_LOG_NONE);
    proj_context_set_enable_network(context.get(), 0);
    return context;
}

SystemHandle handle(PJ* system) { return {system, proj_destroy}; }

/// The horizontal system of one with heights, or of one with a transformation.
SystemHandle horizontal(PJ_CONTEXT* context, SystemHandle system)
{
    for (int depth = 0; system && depth < 4; ++depth) {
        const PJ_TYPE type = proj_get_type(system.get());
        if (type == PJ_TYPE_COMPOUND_CRS)
            system = handle(proj_crs_get_sub_crs(context, system.get(), 0));
        else if (type == PJ_TYPE_BOUND_CRS)
            system = handle(proj_get_source_crs(context, system.get()));
        else
            break;
    }
    return system;
}

/// A definition of PROJ's own language says by `+type=crs` that it is a system.
std::string definition_of(const std::string& text)
{
    const bool lacks_type = text.starts_with('+') && text.find("+type=crs") == std::string::npos;
    return lacks_type ? text + " +type=crs" : text;
}

SystemHandle opened(PJ_CONTEXT* context, const std::string& text)
{
    SystemHandle system = handle(proj_create(context, definition_of(text).c_str()));
    if (!system || proj_is_crs(system.get()) == 0)
        throw InputError(fmt::format(
            "{}: PROJ knows no such system of coordinates; one is named as EPSG:4326 is, or planar says that "
            "coordinates are lengths",
            shortened(printable(text))));
    return horizontal(context, std::move(system));
}

bool has_angles(PJ_TYPE type) { return type == PJ_TYPE_GEOGRAPHIC_2D_CRS || type == PJ_TYPE_GEOGRAPHIC_3D_CRS; }

bool has_lengths(PJ_TYPE type)
{
    return type == PJ_TYPE_PROJECTED_CRS || type == PJ_TYPE_ENGINEERING_CRS || type == PJ_TYPE_OTHER_CRS;
}

double unit_of_axis(PJ_CONTEXT* context, const PJ* system)
{
    const SystemHandle axes = handle(proj_crs_get_coordinate_system(context, system));
    double factor = std::numbers::pi / 180;
    if (axes)
        proj_cs_get_axis_info(context, axes.get(), 0, nullptr, nullptr, nullptr, &factor, nullptr, nullptr, nullptr);
    return factor;
}

std::string ellipsoid_words(const MapSystem& system)
{
    if (system.inverse_flattening == 0) return fmt::format("+R={:.17g}", system.semi_major_axis);
    return fmt::format("+a={:.17g} +rf={:.17g}", system.semi_major_axis, system.inverse_flattening);
}

MapSystem system_of_proj(const std::string& text)
{
    const ContextHandle context = silent_context();
    const SystemHandle opened_system = opened(context.get(), text);
    const PJ_TYPE type = proj_get_type(opened_system.get());
    MapSystem system;
    system.text = text;
    system.title = proj_get_name(opened_system.get());
    system.has_angles = has_angles(type);
    if (!system.has_angles && !has_lengths(type))
        throw InputError(fmt::format("{}: is {}, a system neither of a plane nor of longitude and latitude",
                                     shortened(printable(text)), system.title));
    if (!system.has_angles) return system;
    system.angle = unit_of_axis(context.get(), opened_system.get());
    const SystemHandle ellipsoid = handle(proj_get_ellipsoid(context.get(), opened_system.get()));
    if (!ellipsoid || proj_ellipsoid_get_parameters(context.get(), ellipsoid.get(), &system.semi_major_axis, nullptr,
                                                    nullptr, &system.inverse_flattening) == 0)
        throw InputError(fmt::format("{}: PROJ knows no ellipsoid of it", shortened(printable(text))));
    return system;
}

class PlaneOfProj final : public LocalPlane
{
public:
    PlaneOfProj(const MapSystem& system, std::array<double, 2> middle) : system_(system), middle_(middle)
    {
        const double to_degrees = system.angle * 180 / std::numbers::pi;
        const std::string text = fmt::format("+proj=laea +lat_0={:.17g} +lon_0={:.17g} {}", middle[1] * to_degrees,
                                             middle[0] * to_degrees, ellipsoid_words(system));
        projection_ = handle(proj_create(context_.get(), text.c_str()));
        if (!projection_) throw InputError(fmt::format("{}: PROJ makes no such map", text));
    }

    void to_plane(std::span<double> places) const override;
    void to_file(std::span<double> places) const override;
    std::array<double, 2> middle() const override { return middle_; }
    double distortion_at(const std::array<double, 2>& place) const override;

private:
    MapSystem system_;
    std::array<double, 2> middle_;
    ContextHandle context_ = silent_context();
    SystemHandle projection_ = handle(nullptr);
    mutable std::mutex mutex_; // a PJ remembers errors
};

void PlaneOfProj::to_plane(std::span<double> places) const
{
    const double turn = 2 * std::numbers::pi / system_.angle;
    const std::lock_guard lock(mutex_);
    for (std::size_t i = 0; i + 1 < places.size(); i += 2) {
        // The two ends of the turn opposite to the middle are one place, to the last bit.
        const double longitude = places[i] - turn * std::floor((places[i] - middle_[0] + turn / 2) / turn);
        const PJ_COORD mapped = proj_trans(projection_.get(), PJ_FWD,
                                           proj_coord(longitude * system_.angle, places[i + 1] * system_.angle, 0, 0));
        places[i] = mapped.xy.x;
        places[i + 1] = mapped.xy.y;
    }
}

void PlaneOfProj::to_file(std::span<double> places) const
{
    const std::lock_guard lock(mutex_);
    PJ* const projection = projection_.get();
    for (std::size_t i = 0; i + 1 < places.size(); i += 2) {
        // PROJ's inverse is a series whose error, some tenths of a millimetre, goes with a second step.
        const PJ_COORD first = proj_trans(projection, PJ_INV, proj_coord(places[i], places[i + 1], 0, 0));
        const PJ_COORD there = proj_trans(projection, PJ_FWD, first);
        const PJ_COORD place = proj_trans(projection, PJ_INV,
                                          proj_coord(2 * places[i] - there.xy.x, 2 * places[i + 1] - there.xy.y, 0, 0));
        places[i] = place.lp.lam / system_.angle;
        places[i + 1] = place.lp.phi / system_.angle;
    }
}

double PlaneOfProj::distortion_at(const std::array<double, 2>& place) const
{
    const std::lock_guard lock(mutex_);
    const PJ_FACTORS factors =
        proj_factors(projection_.get(), proj_coord(place[0] * system_.angle, place[1] * system_.angle, 0, 0));
    if (!(factors.tissot_semiminor > 0)) return std::numeric_limits<double>::infinity();
    return std::max(factors.tissot_semimajor, 1 / factors.tissot_semiminor) - 1;
}

std::shared_ptr<const LocalPlane> plane_of_proj(const MapSystem& system, std::array<double, 2> middle)
{
    return std::make_shared<const PlaneOfProj>(system, middle);
}

std::function<void(std::span<double> places)> change_of_proj(const MapSystem& from, const MapSystem& to)
{
    struct Change
    {
        ContextHandle context = silent_context();
        SystemHandle change = handle(nullptr);
    };
    const auto change = std::make_shared<Change>();
    PJ_CONTEXT* const context = change->context.get();
    const SystemHandle source = opened(context, from.text), target = opened(context, to.text);
    const SystemHandle found =
        handle(proj_create_crs_to_crs_from_pj(context, source.get(), target.get(), nullptr, nullptr));
    if (found) change->change = handle(proj_normalize_for_visualization(context, found.get()));
    if (!change->change) throw InputError(fmt::format("PROJ knows no way from {} to {}", from.title, to.title));
    return [change](std::span<double> places) {
        for (std::size_t i = 0; i + 1 < places.size(); i += 2) {
            const PJ_COORD place = proj_trans(change->change.get(), PJ_FWD, proj_coord(places[i], places[i + 1], 0, 0));
            places[i] = place.xy.x;
            places[i + 1] = place.xy.y;
        }
    };
}

double scale_of_proj(const MapSystem& system, std::array<double, 2> place)
{
    const ContextHandle context = silent_context();
    const SystemHandle plane = opened(context.get(), system.text);
    const SystemHandle base = handle(proj_crs_get_geodetic_crs(context.get(), plane.get()));
    if (proj_get_type(plane.get()) != PJ_TYPE_PROJECTED_CRS || !base) return 1;
    const SystemHandle found =
        handle(proj_create_crs_to_crs_from_pj(context.get(), plane.get(), base.get(), nullptr, nullptr));
    const SystemHandle change =
        found ? handle(proj_normalize_for_visualization(context.get(), found.get())) : handle(nullptr);
    if (!change) return 1;
    const PJ_COORD there = proj_trans(change.get(), PJ_FWD, proj_coord(place[0], place[1], 0, 0));
    const double radians = unit_of_axis(context.get(), base.get());
    const PJ_FACTORS factors =
        proj_factors(plane.get(), proj_coord(there.lp.lam * radians, there.lp.phi * radians, 0, 0));
    return factors.tissot_semimajor > 0 ? std::sqrt(factors.tissot_semimajor * factors.tissot_semiminor) : 1;
}

}
}

extern "C" __attribute__((visibility("default"))) const poissonlab::GlobeFunctions* poissonlab_globe_functions()
{
    static constexpr poissonlab::GlobeFunctions functions{poissonlab::system_of_proj, poissonlab::plane_of_proj,
                                                          poissonlab::change_of_proj, poissonlab::scale_of_proj};
    return &functions;
}
