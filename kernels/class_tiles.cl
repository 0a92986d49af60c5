// Points of several classes in a batch of tiles at once: relaxation dart throwing around points that are there already,
// then pushing points apart that are too near for their classes.
//
// Wei, Multi-class blue noise sampling, 2010 (a distance for each pair of classes); Lagae, Tile-Based Methods in Computer
// Graphics, 2007, section 4.5 (the regions of tiles). Each work-group fills one torus of two tiles a side. Darts come
// class after class; those that are in the allowed cells and not too near to any point become points; after `attempts`
// failures in a row all squared distances become the next part of what they should be. The work-items look at BATCH darts
// at once, and the first then settles them in order, so the result is that of throwing them one after the other. The
// plain twin is host/tile_construction/reference/class_filling.cpp.
//
// Needs DIMENSION (2 or 3).

#pragma OPENCL FP_CONTRACT OFF

#include "kernels/common/tiles/smallest_of_group.clh"
#include "kernels/common/philox.clh"
#include "kernels/common/tiles/class_tiles.h"
#include "kernels/common/tiles/tile_torus.clh"
#include "kernels/common/tiles/limited_movement.clh"

/// The points of a torus: coordinates axis after axis, `capacity` apart, and their classes.
typedef struct
{
    global int* c;
    global const uint* classes;
    uint capacity;
} ClassedPoints;

Position point_at(const ClassedPoints* points, uint number)
{
    Position position;
    FOR_EACH_AXIS(k) position.c[k] = points->c[k * points->capacity + number];
    return position;
}

void put_point(const ClassedPoints* points, uint number, const Position* position)
{
    FOR_EACH_AXIS(k) points->c[k * points->capacity + number] = position->c[k];
}

Position dart_of(uint number, uint stream, const struct ClassFilling* filling)
{
    const uint4 words =
        philox((uint4)(number, stream, filling->attempt, filling->stage), (uint2)(filling->key_x, filling->key_y));
    const uint word[4] = {words.x, words.y, words.z, words.w};
    Position position;
    FOR_EACH_AXIS(k)
    {
        const ulong offset = (ulong)word[k] * filling->extent >> 32;
        position.c[k] = (filling->low + (int)offset) & TORUS_MASK;
    }
    return position;
}

/// Does a point keep this part of the squared distances `wanted` of its class from the first `count` points?
bool is_free(const ClassedPoints* points, uint count, const Position* position, global const uint* wanted, uint part)
{
    for (uint j = 0; j < count; ++j) {
        const Position other = point_at(points, j);
        const ulong squared = squared_between(position, &other);
        if (squared << PART_BITS < (ulong)part * wanted[points->classes[j]]) return false;
    }
    return true;
}

/// The state of a filling.
typedef struct
{
    uint points;
    uint level; // the part's number in the list
    uint failures;
    uint darts;
} Filling;

/// Work-group g fills torus g. classes: of the points that are held, and then of those that are wanted, in the order in
/// which they come. counts: points there are, afterwards.
kernel void throw_class_tile_darts(struct ClassFilling filling, global const uint* streams, global const uint* all_wanted,
                                   global const uint* parts, global const uint* held_counts,
                                   global const uint* targets, global const uint* all_classes, global int* all_points,
                                   global uint* counts)
{
    const uint capacity = filling.tori.capacity;
    const uint item = get_local_id(0);
    const uint items = get_local_size(0);
    const uint torus = get_group_id(0);
    const ClassedPoints points = {all_points + (ulong)torus * DIMENSION * capacity,
                                  all_classes + (ulong)torus * capacity, capacity};
    const Zone zone = zone_of(&filling.tori, points.c, 0);
    const uint stream = streams[torus];
    const uint target = targets[torus];

    local Filling state;
    local uchar is_candidate[BATCH];
    if (item == 0) {
        state.points = held_counts[torus];
        state.level = state.failures = state.darts = 0;
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    while (state.points < target && state.level < filling.levels && state.darts < MAX_DARTS) {
        const uint own = points.classes[state.points];
        global const uint* wanted = all_wanted + own * filling.classes;
        const uint reachable = state.level + (state.failures + BATCH - 1) / filling.attempts;
        const uint least = parts[min(reachable, filling.levels - 1)];
        for (uint i = item; i < BATCH; i += items) {
            const Position position = dart_of(state.darts + i, stream, &filling);
            is_candidate[i] = !is_allowed(&position, &zone)                             ? 2
                              : is_free(&points, state.points, &position, wanted, least) ? 1
                                                                                         : 0;
        }
        barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
        if (item == 0) {
            Filling f = state;
            for (uint i = 0; i < BATCH && f.points < target && f.level < filling.levels; ++i) {
                if (points.classes[f.points] != own || f.darts == MAX_DARTS) break;
                const Position position = dart_of(f.darts++, stream, &filling);
                if (is_candidate[i] == 2) continue; // not in the domain
                if (is_candidate[i] == 1 && is_free(&points, f.points, &position, wanted, parts[f.level])) {
                    put_point(&points, f.points++, &position);
                    f.failures = 0;
                } else if (++f.failures == filling.attempts) {
                    f.failures = 0;
                    ++f.level;
                }
            }
            state = f;
        }
        barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
    }
    if (item == 0) counts[torus] = state.points;
}

/// The points of a torus, of which those from `first` to `end` - 1 move.
typedef struct
{
    ClassedPoints points;
    uint first, end;
    global const uint* wanted;
    global const double* pushed;
    uint classes;
} PushedTorus;

/// The movement of a point away from all that are too near, by what they lack of the distance, half of it where the
/// other one moves. Lowers `part` to the part of the squared distances that it keeps.
Position movement_of(const PushedTorus* torus, uint i, uint* part)
{
    const Position position = point_at(&torus->points, i);
    const uint row = torus->points.classes[i] * torus->classes;
    double sum[DIMENSION];
    for (int k = 0; k < DIMENSION; ++k) sum[k] = 0;
    double limit = 0; // the largest distance of those that push
    for (uint j = 0; j < torus->end; ++j) {
        if (i == j) continue;
        const Position other = point_at(&torus->points, j);
        const uint pair = row + torus->points.classes[j];
        const uint squared = squared_between(&position, &other);
        const ulong wanted = torus->wanted[pair];
        if ((ulong)squared << PART_BITS < *part * wanted) *part = (uint)(((ulong)squared << PART_BITS) / wanted);
        const double distance = torus->pushed[pair];
        if (squared > (uint)(distance * distance)) continue;
        limit = max(limit, distance);
        const double length = sqrt((double)squared);
        const double push = (j >= torus->first ? 0.5 : 1.0) * (distance - length);
        if (squared == 0) {
            sum[0] += i < j ? -push : push;
            continue;
        }
        for (int k = 0; k < DIMENSION; ++k)
            sum[k] -= torus_difference_of(other.c[k] - position.c[k]) / length * push;
    }
    return limited_movement(sum, limit);
}

/// Until all distances are kept, or for so many passes; then the best is in `kept`, with the part of the squared distances
/// that it keeps in `parts`. Tori that are not filled are left alone.
kernel void push_class_tiles(struct ClassFilling filling, global const uint* all_wanted, global const double* pushed,
                             global const uint* held_counts, global const uint* targets, global const uint* counts,
                             global const uint* all_classes, global int* all_points, global int* all_moved,
                             global int* all_kept, global uint* parts)
{
    const uint capacity = filling.tori.capacity;
    const uint item = get_local_id(0);
    const uint items = get_local_size(0);
    const uint g = get_group_id(0);
    const ulong begin = (ulong)g * DIMENSION * capacity;
    global const uint* classes = all_classes + (ulong)g * capacity;
    const PushedTorus torus = {{all_points + begin, classes, capacity}, held_counts[g], targets[g],
                               all_wanted,                              pushed,         filling.classes};
    const ClassedPoints moved = {all_moved + begin, classes, capacity};
    const ClassedPoints kept = {all_kept + begin, classes, capacity};
    const Zone zone = zone_of(&filling.tori, torus.points.c, 0);
    local uint values[MAX_ITEMS];
    if (counts[g] < targets[g]) return; // all work-items

    uint best = 0;
    for (uint pass = 0; pass <= filling.passes; ++pass) {
        uint part = MOST_PART;
        for (uint i = torus.first + item; i < torus.end; i += items) {
            const Position position = point_at(&torus.points, i);
            const Position movement = movement_of(&torus, i, &part);
            const Position end = allowed_end(&position, &movement, &zone, true);
            put_point(&moved, i, &end);
        }
        part = smallest_of_group(part, values);
        if (pass == 0 || part > best) {
            best = part;
            for (uint i = torus.first + item; i < torus.end; i += items) {
                const Position position = point_at(&torus.points, i);
                put_point(&kept, i, &position);
            }
            if (item == 0) parts[g] = part;
        }
        if (part >= 1u << PART_BITS || pass == filling.passes) break;
        for (uint i = torus.first + item; i < torus.end; i += items) {
            const Position position = point_at(&moved, i);
            put_point(&torus.points, i, &position);
        }
        barrier(CLK_GLOBAL_MEM_FENCE);
    }
}
