#include "host/sampling/cells/domain.hpp"

#include "kernels/common/domain.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace poissonlab {
namespace {

struct Contact
{
    double part = 1; ///< of the movement, until it is stopped
    Vector normal{};
};

double inner_product(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Moves the contact to where a movement from `start` (relative to the region's centre) enters the region, if
/// that is earlier. Deep inside, the nearest boundary counts as the one that is being entered.
void enter_region(const ConvexRegion& region, const Vector& start, const Vector& movement, Contact& contact)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double entry = -infinity;
    double exit = infinity;
    double nearest = -infinity;
    double nearest_rise = 0;
    const HalfSpace* entered = nullptr;
    const HalfSpace* nearest_boundary = nullptr;
    for (const HalfSpace& half_space : region.half_spaces) {
        const double height = inner_product(half_space.normal, start) - half_space.offset;
        const double rise = inner_product(half_space.normal, movement);
        if (height >= -contract::domain::BOUNDARY_DEPTH && rise >= 0) return; // on it or above it, and not going down
        if (height > nearest) {
            nearest = height;
            nearest_rise = rise;
            nearest_boundary = &half_space;
        }
        if (rise < 0) {
            if (-height / rise > entry) {
                entry = -height / rise;
                entered = &half_space;
            }
        } else if (rise > 0) {
            exit = std::min(exit, -height / rise);
        }
    }
    if (nearest_boundary == nullptr) return;           // no half-spaces
    if (nearest < -contract::domain::BOUNDARY_DEPTH) { // may leave by the nearest boundary, or stay as deep as it is
        entered = nearest_boundary;
        entry = 0;
        if (nearest_rise >= 0) return;
    } else if (!(entry < exit)) {
        return;
    }
    entry = std::max(entry, 0.0);
    if (entry < contact.part) contact = {entry, entered->normal};
}

/// Calls enter_region() for all images of the region on the torus that the movement can meet.
void enter_images(const ConvexRegion& region, const Vector& position, const Vector& movement, Contact& contact)
{
    // The movement may leave the half torus around the centre and enter the region from its other side.
    Vector start;
    Vector image_shift;
    for (int k = 0; k < 3; ++k) {
        const double difference = position[k] - region.centre[k];
        start[k] = difference - std::rint(difference);
        const double end = start[k] + movement[k];
        image_shift[k] = end > 0.5 ? -1 : end < -0.5 ? 1 : 0;
    }
    for (int image = 0; image < 8; ++image) {
        Vector image_start = start;
        bool is_needed = true;
        for (int k = 0; k < 3; ++k) {
            if (!(image >> k & 1)) continue;
            is_needed = is_needed && image_shift[k] != 0;
            image_start[k] += image_shift[k];
        }
        if (is_needed) enter_region(region, image_start, movement, contact);
    }
}

}

Vector allowed_displacement(const Domain& domain, const Vector& position, const Vector& displacement, bool slides)
{
    Vector movement = displacement;
    Vector done{};
    for (int number = 0; number < contract::domain::MAX_CONTACTS; ++number) {
        Contact contact;
        Vector here;
        for (int k = 0; k < 3; ++k) here[k] = position[k] + done[k];
        for (const ConvexRegion& region : domain.forbidden) enter_images(region, here, movement, contact);
        for (int k = 0; k < 3; ++k) done[k] += contact.part * movement[k];
        if (contact.part == 1 || !slides) break;
        for (double& m : movement) m *= 1 - contact.part;
        double size = 0;
        for (const double m : movement) size += std::abs(m);
        const double into = inner_product(movement, contact.normal) -
                            (contract::domain::LIFT_PART * size + contract::domain::LIFT_DISTANCE);
        for (int k = 0; k < 3; ++k) movement[k] -= into * contact.normal[k];
    }
    return done;
}

}
