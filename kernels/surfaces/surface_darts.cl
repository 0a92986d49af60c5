// Darts on a surface of triangles, side by side, with the result of the sequential algorithm: each dart becomes a point
// if no point before it is in conflict.
//
// Cline, Jeschke, White, Razdan, Wonka, Dart throwing on surfaces, EGSR 2009: darts fall on pieces of triangles that may
// be uncovered, by their areas, and pieces that one disk covers are dropped, others divided. The host divides, see
// host/sampling/surfaces/surface_darts.hpp.
//
//   find_darts    a work-item a dart: where it falls, and whether points of former batches cover it; darts are in the
//                 order of their pieces, and their numbers decide which come first
//   settle_darts  (again and again) a work-item a dart: accepted if no dart before it in the batch is in conflict that
//                 is accepted or may be
//   clear_darts   takes darts of a batch out of their buckets
//   add_points    puts accepted darts among the points
//   cover_pieces  a work-item a piece: whether one point covers it
//
// The twin is host/sampling/surfaces/reference/surface_darts.cpp.

#include "kernels/common/philox.clh"
#include "kernels/common/surfaces/surface_pieces.clh"

/// order: the batch's darts by their pieces, so that work-items side by side look at the same points.
kernel void find_darts(struct SurfaceBatch batch, Rule rule, global const uint* order,
                       global const struct Triangle* triangles, global const struct Piece* pieces, global const ulong* ends, global const uint* guide,
                       global const uint* heads, global const Point* points, global Point* darts, global uint* states,
                       global uint* dart_heads)
{
    const uint id = get_global_id(0);
    if (id >= batch.darts) return;
    const ulong number = batch.first + order[id];
    const uint4 words = philox((uint4)((uint)number, (uint)(number >> 32), 0, 0), (uint2)(batch.key_x, batch.key_y));
    global const struct Piece* piece = &pieces[find_piece((ulong)words.x << 32 | words.y, batch.total, batch.guide_bits,
                                                           batch.pieces, ends, guide)];
    uint shares[2];
    find_shares(piece, words.z, words.w, shares);
    Spot spot;
    spot.triangle = piece->triangle;
    find_place(&triangles[spot.triangle], shares[0], shares[1], &spot.place);
    global Point* dart = &darts[id];
    for (int k = 0; k < 3; ++k) dart->place[k] = spot.place.c[k];
    for (int k = 0; k < 2; ++k) dart->shares[k] = shares[k];
    dart->triangle = spot.triangle;
    dart->next = 0;
    dart->number = order[id];
    const bool is_covered = has_conflict(&spot, triangles, &rule, heads, points, 0);
    states[id] = is_covered ? COVERED : UNDECIDED;
    if (!is_covered)
        dart->next = atomic_xchg(&dart_heads[own_bucket(&spot.place, rule.cell, batch.bucket_mask)], id + 1);
}

/// The state of a dart that is undecided, from those of darts before it.
uint state_among(uint id, struct SurfaceBatch batch, const Rule* rule, global const struct Triangle* triangles,
                 global const Point* darts, global const uint* dart_heads, global volatile uint* states)
{
    Spot spot;
    for (int k = 0; k < 3; ++k) spot.place.c[k] = darts[id].place[k];
    spot.triangle = darts[id].triangle;
    uint state = ACCEPTED;
    FOR_EACH_NEAR(&spot, rule->cell, batch.bucket_mask, dart_heads, darts, 0, {
        if (point->number >= darts[id].number) continue;
        const uint other = atomic_or(&states[link - 1], 0); // others write them
        if (other == REJECTED || !are_in_conflict(&spot, point, triangles, rule)) continue;
        if (other == ACCEPTED) return REJECTED;
        state = UNDECIDED;
    })
    return state;
}

/// States only change from undecided to what they are in the end, so that it does not matter when others see them.
kernel void settle_darts(struct SurfaceBatch batch, Rule rule, global const struct Triangle* triangles,
                         global const Point* darts, global const uint* dart_heads, global volatile uint* states,
                         global uint* undecided)
{
    const uint id = get_global_id(0);
    if (id >= batch.darts || atomic_or(&states[id], 0) != UNDECIDED) return;
    const uint state = state_among(id, batch, &rule, triangles, darts, dart_heads, states);
    if (state == UNDECIDED)
        atomic_inc(undecided);
    else
        atomic_xchg(&states[id], state);
}

kernel void clear_darts(struct SurfaceBatch batch, Rule rule, global const Point* darts, global const uint* states,
                        global uint* dart_heads)
{
    const uint id = get_global_id(0);
    if (id >= batch.darts || states[id] == COVERED) return;
    Place place;
    for (int k = 0; k < 3; ++k) place.c[k] = darts[id].place[k];
    dart_heads[own_bucket(&place, rule.cell, batch.bucket_mask)] = 0;
}

/// points: `count` of them are new, from number `first` on.
kernel void add_points(Rule rule, uint first, uint count, global Point* points, global uint* heads)
{
    const uint id = get_global_id(0);
    if (id >= count) return;
    Place place;
    for (int k = 0; k < 3; ++k) place.c[k] = points[first + id].place[k];
    points[first + id].next =
        atomic_xchg(&heads[own_bucket(&place, rule.cell, rule.bucket_mask)], first + id + 1);
}

kernel void cover_pieces(uint count, Rule rule, global const struct Triangle* triangles,
                         global const struct Piece* pieces, global const uint* heads, global const Point* points,
                         global uint* states)
{
    const uint id = get_global_id(0);
    if (id >= count) return;
    const struct Piece piece = pieces[id];
    Spot corners[3];
    find_corners(&piece, triangles, corners);
    states[id] = PIECE_OPEN;
    if (is_covered(corners, triangles, &rule, heads, points)) {
        states[id] = PIECE_COVERED;
    } else if (piece.halvings & LAST_PIECE) {
        Spot centre;
        find_centre(&piece, triangles, &centre);
        if (has_conflict(&centre, triangles, &rule, heads, points, 0)) states[id] = PIECE_SMALL;
    }
}
