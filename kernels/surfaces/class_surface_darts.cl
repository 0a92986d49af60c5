// Darts of several classes on a surface of triangles, with a distance for each pair of classes.
//
// Wei, Multi-class blue noise sampling, 2010; Cline, Jeschke, White, Razdan, Wonka, Dart throwing on surfaces, EGSR 2009,
// for the pieces of triangles. The order in which classes get points is known beforehand: slot i is the place of the
// point that comes as number i, and its class. Each slot has darts of its own, and the first of them that is far enough
// from all points of slots before becomes its point:
//
//   find_class_darts    a work-item a slot: its first dart that no point of former batches rejects
//   settle_class_darts  a work-item: slot after slot, that dart if no point of this batch rejects it, else the first one
//                       after it that no point rejects
//   cover_class_pieces  a work-item a piece: whether one point covers it
//
// Darts fall on pieces that may have room for their class, by weights: areas, times the class's density. When TRIES darts
// of a slot failed, the batch ends there, and the host refines these pieces. Each class has buckets of its own, whose
// cells are twice as wide as the largest distance that any class keeps from it.
//
// The twin is host/sampling/surfaces/reference/class_surface_darts.cpp.

#include "kernels/common/philox.clh"
#include "kernels/common/surfaces/class_surface.h"
#include "kernels/common/surfaces/surface_pieces.clh"

/// Points of all classes, and the surface.
typedef struct
{
    global const Rule* rules; ///< of the class that is asked for, with each class
    global const struct Triangle* triangles;
    global const uint* heads;
    global const Point* points;
    uint classes;
} SeenPoints;

/// The pieces of all classes, their weights and guides.
typedef struct
{
    global const struct Piece* pieces;
    global const ulong* ends;
    global const uint* guide;
} ListedPieces;

/// The darts of a slot of the batch.
typedef struct
{
    uint slot;
    uint own; ///< its class
    uint target;
    uint skipped;
    struct OpenPieces list;
    uint2 key;
} SlotDarts;

/// Is a point too near to the spot? Those before number `since` do not count; links fall along chains.
bool meets_point(const SeenPoints* seen, const Spot* spot, uint since)
{
    for (uint other = 0; other < seen->classes; ++other) {
        const Rule rule = seen->rules[other];
        if (has_conflict(spot, seen->triangles, &rule, seen->heads + rule.first, seen->points, since)) return true;
    }
    return false;
}

/// Makes a dart of a slot from four random words. Where pieces have targets, they are in an order in which neighbours are
/// near each other, and the first darts fall into the interval of 2^spread units of that order that has the slot's
/// target, the next ones into intervals around it that are 4, 16, ... times as long, and the last ones anywhere: targets
/// are evenly spread, so that numbers of points follow weights although points reject each other.
void draw_dart(const SlotDarts* darts, uint tried, const ListedPieces* all, global const struct Triangle* triangles,
               Spot* spot, uint* shares)
{
    const uint number = darts->skipped + tried;
    const uint4 words = philox((uint4)(darts->slot, number, darts->own, 0), darts->key);
    uint upper = words.x;
    if (darts->list.spread > 0 && number < TRIES - TRIES_BEFORE) {
        const uint bits = min(32u, darts->list.spread + 2 * (number / TRIES_BEFORE));
        const uint random = (uint)((1ul << bits) - 1);
        upper = (darts->target & ~random) | (words.x & random);
    }
    const uint chosen = find_piece((ulong)upper << 32 | words.y, darts->list.total, darts->list.guide_bits,
                                   darts->list.count, all->ends + darts->list.first,
                                   all->guide + darts->list.first_guide);
    global const struct Piece* piece = &all->pieces[darts->list.first + chosen];
    find_shares(piece, words.z, words.w, shares);
    spot->triangle = piece->triangle;
    find_place(&triangles[piece->triangle], shares[0], shares[1], &spot->place);
}

/// Finds the first dart from `number` on that no point rejects; returns its number, or TRIES where there is none.
uint first_free(const SlotDarts* darts, uint number, const SeenPoints* seen, const ListedPieces* all, Spot* spot,
                uint* shares)
{
    for (; number < TRIES; ++number) {
        draw_dart(darts, number, all, seen->triangles, spot, shares);
        if (!meets_point(seen, spot, 0)) break;
    }
    return number;
}

void find_slot_darts(struct SurfaceSlots batch, uint id, global const struct SurfaceSlot* slots,
                     global const struct OpenPieces* lists, SlotDarts* darts)
{
    darts->slot = batch.first + id;
    darts->own = slots[id].own;
    darts->target = slots[id].target;
    darts->skipped = id == 0 ? batch.skipped : 0;
    darts->list = lists[darts->own];
    darts->key = (uint2)(batch.key_x, batch.key_y);
}

void find_seen(uint own, uint classes, global const Rule* rules, global const struct Triangle* triangles,
               global const uint* heads, global const Point* points, SeenPoints* seen)
{
    seen->rules = &rules[own * classes];
    seen->triangles = triangles;
    seen->heads = heads;
    seen->points = points;
    seen->classes = classes;
}

void write_dart(const Spot* spot, const uint* shares, uint number, global Point* to)
{
    for (int k = 0; k < 3; ++k) to->place[k] = spot->place.c[k];
    for (int k = 0; k < 2; ++k) to->shares[k] = shares[k];
    to->triangle = spot->triangle;
    to->next = 0;
    to->number = number;
}

/// candidates: the dart of each slot, with its number among the slot's darts, or TRIES.
kernel void find_class_darts(struct SurfaceSlots batch, global const struct SurfaceSlot* slots,
                             global const Rule* rules, global const struct OpenPieces* lists,
                             global const struct Triangle* triangles, global const struct Piece* pieces,
                             global const ulong* ends, global const uint* guide, global const uint* heads,
                             global const Point* points, global Point* candidates)
{
    const uint id = get_global_id(0);
    if (id >= batch.slots) return;
    SlotDarts darts;
    find_slot_darts(batch, id, slots, lists, &darts);
    SeenPoints seen;
    find_seen(darts.own, batch.classes, rules, triangles, heads, points, &seen);
    const ListedPieces all = {pieces, ends, guide};
    Spot spot;
    uint shares[2];
    const uint number = first_free(&darts, 0, &seen, &all, &spot, shares);
    write_dart(&spot, shares, number, &candidates[id]);
}

/// One work-item.
kernel void settle_class_darts(struct SurfaceSlots batch, global const struct SurfaceSlot* slots,
                               global const Rule* rules, global const struct OpenPieces* lists,
                               global const struct Triangle* triangles, global const struct Piece* pieces,
                               global const ulong* ends, global const uint* guide, global uint* heads,
                               global Point* points, global const Point* candidates, global uint* counters)
{
    if (get_global_id(0) != 0) return;
    const ListedPieces all = {pieces, ends, guide};
    counters[REDRAWN] = 0;
    uint id = 0;
    for (; id < batch.slots; ++id) {
        SlotDarts darts;
        find_slot_darts(batch, id, slots, lists, &darts);
        SeenPoints seen;
        find_seen(darts.own, batch.classes, rules, triangles, heads, points, &seen);
        uint number = candidates[id].number;
        if (number == TRIES) break;
        Spot spot;
        for (int k = 0; k < 3; ++k) spot.place.c[k] = candidates[id].place[k];
        spot.triangle = candidates[id].triangle;
        uint shares[2] = {candidates[id].shares[0], candidates[id].shares[1]};
        if (meets_point(&seen, &spot, batch.first)) {
            ++counters[REDRAWN];
            number = first_free(&darts, number + 1, &seen, &all, &spot, shares);
            if (number == TRIES) break;
        }
        write_dart(&spot, shares, 0, &points[darts.slot]);
        const Rule rule = seen.rules[darts.own];
        global uint* head = &heads[rule.first + own_bucket(&spot.place, rule.cell, rule.bucket_mask)];
        points[darts.slot].next = *head;
        *head = darts.slot + 1;
    }
    counters[SETTLED] = id;
}

kernel void cover_class_pieces(uint classes, uint own, struct OpenPieces list, global const Rule* rules,
                               global const struct Triangle* triangles, global const struct Piece* pieces,
                               global const uint* heads, global const Point* points, global uint* states)
{
    const uint id = get_global_id(0);
    if (id >= list.count) return;
    SeenPoints seen;
    find_seen(own, classes, rules, triangles, heads, points, &seen);
    const struct Piece piece = pieces[list.first + id];
    Spot corners[3];
    find_corners(&piece, triangles, corners);
    states[id] = PIECE_OPEN;
    for (uint other = 0; other < classes; ++other) {
        const Rule rule = seen.rules[other];
        if (!is_covered(corners, triangles, &rule, heads + rule.first, points)) continue;
        states[id] = PIECE_COVERED;
        return;
    }
    if (!(piece.halvings & LAST_PIECE)) return;
    Spot centre;
    find_centre(&piece, triangles, &centre);
    if (meets_point(&seen, &centre, 0)) states[id] = PIECE_SMALL;
}
