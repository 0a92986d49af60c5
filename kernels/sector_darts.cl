// Sector darts: sets that grow from their first point, each in a work-item of its own.
//
// Dunbar and Humphreys, A spatial data structure for fast Poisson-disk sample generation, 2006; dissertation, section
// 6.13. Which point is next depends on all points so far: nothing is parallel within a set. The plain twin, which gives
// the same bytes, is host/sampling/reference/sector_darts.cpp; host/sampling/sectors/sector_darts.cpp calls a kernel
// again until every set is full:
//   grow_point_by_point   one random point after the other, until there is no room beside it: linear sets have darts
//                         in all that is left around the point, boundary sets at the least distance of it
//   grow_by_area          logarithmic sets: darts into what is left around all points, uniformly
// Angles and areas are of double precision, with directions by polynomials of our own (kernels/common/sectors/
// directions.h): bytes are the same everywhere.

#pragma OPENCL FP_CONTRACT OFF

#include "kernels/common/sectors/growing_set.clh"
#include "kernels/common/sectors/scalloped_region.clh"
#include "kernels/common/sectors/area_tree.clh"

/// Angles of a circle that are free, as ranges.
typedef struct
{
    uint count;
    double2 ranges[MAX_RANGES]; ///< begin and end
} FreeAngles;

/// Cuts a range of angles out. False where too many ranges are left.
bool cut_angles(FreeAngles* free, double begin, double end)
{
    double2 left[MAX_RANGES];
    uint count = 0;
    for (uint i = 0; i < free->count; ++i) {
        const double2 range = free->ranges[i];
        if (count + 2 > MAX_RANGES) return false;
        if (end <= range.x || begin >= range.y) {
            left[count++] = range;
            continue;
        }
        if (begin - range.x > LEAST_ANGLE) left[count++] = (double2)(range.x, begin);
        if (range.y - end > LEAST_ANGLE) left[count++] = (double2)(end, range.y);
    }
    for (uint i = 0; i < count; ++i) free->ranges[i] = left[i];
    free->count = count;
    return true;
}

/// Angles are from minus to plus half a turn: a range that reaches beyond comes in again at the other end.
void subtract_angles(Growing* set, FreeAngles* free, double angle, double half_width)
{
    const double begin = angle - half_width, end = angle + half_width;
    bool is_done = cut_angles(free, begin, end);
    if (begin < -HALF_TURN) is_done = is_done && cut_angles(free, begin + FULL_TURN, end + FULL_TURN);
    if (end > HALF_TURN) is_done = is_done && cut_angles(free, begin - FULL_TURN, end - FULL_TURN);
    if (!is_done) set->state.state = OUT_OF_ROOM;
}

/// A range by chance, whatever its length, and an angle in it.
double choose_angle(const FreeAngles* free, uint random, double u)
{
    const double2 range = free->ranges[choice_of(random, free->count)];
    return range.x + u * (range.y - range.x);
}

/// Half the angle that a point takes has the quotient of its distance and twice the reach as cosine.
void subtract_point(Growing* set, FreeAngles* free, uint point, uint other)
{
    const uint2 from = set->places[point], to = set->places[other];
    const ulong reach = (ulong)set->rules.reach;
    const ulong squared = squared_distance(from, to);
    if (squared >= 4 * reach * reach) return;
    const double across = sqrt((double)(4 * reach * reach - squared));
    const double angle = direction_of((int)(to.x - from.x), (int)(to.y - from.y));
    subtract_angles(set, free, angle, direction_of(sqrt((double)squared), across));
}

void fill_boundary(Growing* set, uint point)
{
    FreeAngles free;
    free.count = 1;
    free.ranges[0] = (double2)(-HALF_TURN, HALF_TURN);
    uint others[MAX_NEIGHBOURS];
    const uint count = points_around(set, set->places[point], 2 * set->rules.reach, point, others);
    for (uint i = 0; i < count && free.count > 0; ++i) subtract_point(set, &free, point, others[i]);
    while (free.count > 0 && set->state.state == GROWING) {
        const uint4 words = next_random(set, DART_USE);
        PolarPlace place;
        place.angle = choose_angle(&free, words.x, uniform_number(words.y));
        place.distance = set->rules.reach;
        if (throw_dart(set, point, place))
            subtract_point(set, &free, point, set->state.points - 1);
        else // rounded too near to a point: a sliver that holds none
            subtract_angles(set, &free, place.angle, REJECTED_ANGLE);
    }
}

/// The annulus around a point without the disks around others, and without what belongs to points before it.
void cut_region_of(Growing* set, uint point, CutRegion* cut)
{
    const uint2 place = set->places[point];
    const double reach = set->rules.reach;
    uint others[MAX_NEIGHBOURS];
    double gaps[MAX_NEIGHBOURS];
    const uint count = points_around(set, place, 4 * reach, point, others);
    // The points that take most come first: often nothing is left soon.
    for (uint i = 0; i < count; ++i) {
        const uint other = others[i];
        const double radius = other < point ? 2 * reach : reach;
        const double gap = sqrt((double)squared_distance(place, set->places[other])) - radius;
        uint k = i;
        for (; k > 0 && (gaps[k - 1] > gap || (gaps[k - 1] == gap && others[k - 1] > other)); --k) {
            gaps[k] = gaps[k - 1];
            others[k] = others[k - 1];
        }
        gaps[k] = gap;
        others[k] = other;
    }
    begin_region(cut, reach);
    for (uint i = 0; i < count && region_now(cut)->count > 0 && gaps[i] < 2 * reach; ++i)
        cut_off_point(cut, place, set->places[others[i]], others[i] < point ? 2 * reach : reach);
    if (cut->is_too_large) set->state.state = OUT_OF_ROOM;
}

void fill_region(Growing* set, uint point)
{
    CutRegion cut;
    cut_region_of(set, point, &cut);
    while (region_now(&cut)->count > 0 && set->state.state == GROWING) {
        const uint4 words = next_random(set, DART_USE);
        const PolarPlace place = place_in(region_now(&cut), uniform_number(words.x), uniform_number(words.y));
        if (throw_dart(set, point, place))
            cut_off_point(&cut, set->places[point], set->places[set->state.points - 1], set->rules.reach);
        else
            cut_off_rejected(&cut, place);
        if (cut.is_too_large) set->state.state = OUT_OF_ROOM;
    }
}

/// Random points are done one after the other: all darts that fit beside each.
void grow_from_points(Growing* set, global uint* open)
{
    if (set->state.points == 0) {
        throw_first_dart(set);
        open[set->state.open++] = 0;
    }
    for (uint step = 0; step < set->rules.steps && set->state.state == GROWING; ++step) {
        if (set->state.open == 0) {
            set->state.state = FULL;
            break;
        }
        const uint chosen = choice_of(next_random(set, CHOICE_USE).x, set->state.open);
        const uint point = open[chosen];
        open[chosen] = open[--set->state.open];
        const uint before = set->state.points;
        if (set->rules.variant == BOUNDARY)
            fill_boundary(set, point);
        else
            fill_region(set, point);
        for (uint i = before; i < set->state.points; ++i) open[set->state.open++] = i;
    }
}

kernel void grow_point_by_point(struct SectorRules rules, global struct GrowingSet* sets, global uint2* places,
                                global uint* heads, global uint* next, global uint* open)
{
    const uint number = get_global_id(0);
    if (number >= rules.sets) return;
    Growing set = growing_set(rules, number, sets, places, heads, next);
    grow_from_points(&set, open + (size_t)number * rules.capacity);
    sets[number] = set.state;
}

/// Cuts the disks around a new point off what is left around those near it.
void cut_off_around(AreaTree* tree, CutRegion* cut, uint added)
{
    Growing* set = tree->set;
    uint others[MAX_NEIGHBOURS];
    const uint count = points_around(set, set->places[added], 3 * set->rules.reach, added, others);
    for (uint i = 0; i < count; ++i) {
        const uint other = others[i];
        if (tree->regions[other] == 0) continue;
        load_region(tree, other, cut);
        cut_off_point(cut, set->places[other], set->places[added], set->rules.reach);
        keep_region(tree, other, cut);
        set->state.open -= tree->regions[other] == 0;
    }
}

/// Keeps what is left around a new point.
void add_region(AreaTree* tree, CutRegion* cut, uint added)
{
    cut_region_of(tree->set, added, cut);
    tree->regions[added] = 0;
    keep_region(tree, added, cut);
    tree->set->state.open += tree->regions[added] != 0;
}

/// A dart into all that is left.
void throw_by_area(AreaTree* tree, CutRegion* cut)
{
    Growing* set = tree->set;
    const uint4 words = next_random(set, DART_USE);
    uint point = min(leaf_at(tree, uniform_number(words.z)), set->state.points - 1);
    while (tree->regions[point] == 0) point = (point + 1) % set->state.points; // what rounding leaves
    load_region(tree, point, cut);
    const PolarPlace place = place_in(region_now(cut), uniform_number(words.x), uniform_number(words.y));
    if (throw_dart(set, point, place)) {
        const uint added = set->state.points - 1;
        cut_off_around(tree, cut, added);
        add_region(tree, cut, added);
    } else {
        cut_off_rejected(cut, place);
        keep_region(tree, point, cut);
        set->state.open -= tree->regions[point] == 0;
    }
}

kernel void grow_by_area(struct SectorRules rules, global struct GrowingSet* sets, global uint2* places,
                         global uint* heads, global uint* next, global uint* regions,
                         global struct KeptSector* sectors, global double* areas)
{
    const uint number = get_global_id(0);
    if (number >= rules.sets) return;
    Growing set = growing_set(rules, number, sets, places, heads, next);
    AreaTree tree = area_tree(&set, number, regions, sectors, areas);
    CutRegion cut;
    if (set.state.points == 0) {
        throw_first_dart(&set);
        begin_region(&cut, rules.reach);
        tree.regions[0] = 0;
        keep_region(&tree, 0, &cut);
        set.state.open = 1;
    }
    for (uint step = 0; step < rules.steps && set.state.state == GROWING; ++step) {
        if (set.state.open == 0)
            set.state.state = FULL;
        else
            throw_by_area(&tree, &cut);
    }
    sets[number] = set.state;
}
