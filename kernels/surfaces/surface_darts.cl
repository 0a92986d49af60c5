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
#include "kernels/common/surfaces/surface.clh"

typedef struct SurfaceRule Rule;
typedef struct SurfacePoint Point;

/// A place and its triangle.
typedef struct
{
    Place place;
    uint triangle;
} Spot;

/// BODY sees `link` and `point` of each point in a bucket near a place, and breaks out of one bucket's chain only.
#define FOR_EACH_NEAR(spot, cell, mask, heads, points, BODY)                                                          \
    uint buckets_[NEAREST_CELLS];                                                                                      \
    const uint count_ = find_buckets(&(spot)->place, cell, mask, buckets_);                                            \
    for (uint i_ = 0; i_ < count_; ++i_)                                                                               \
        for (uint link = heads[buckets_[i_]]; link != 0; link = points[link - 1].next) {                               \
            global const Point* point = &points[link - 1];                                                             \
            BODY                                                                                                       \
        }

bool are_in_conflict(const Spot* spot, global const Point* point, global const struct Triangle* triangles,
                     const Rule* rule)
{
    return squared_length(&spot->place, point->place) < rule->squared &&
           have_near_normals(&triangles[spot->triangle], &triangles[point->triangle], rule->least_cosine);
}

bool has_conflict(const Spot* spot, global const struct Triangle* triangles, const Rule* rule,
                  global const uint* heads, global const Point* points)
{
    FOR_EACH_NEAR(spot, rule->cell, rule->bucket_mask, heads, points,
                  { if (are_in_conflict(spot, point, triangles, rule)) return true; })
    return false;
}

/// The first piece whose weights, with all before it, are more than `target`. There always is one; the last piece is
/// asked for all the same, because llvmpipe lets idle lanes of its vectors run, which read zeros and would never end.
uint find_piece(ulong random, struct SurfaceBatch batch, global const ulong* ends, global const uint* guide)
{
    const ulong target = mul_hi(random, batch.total);
    uint piece = guide[random >> (64 - batch.guide_bits)];
    while (piece + 1 < batch.pieces && ends[piece] <= target) ++piece;
    return piece;
}

/// Shares of a place that is uniform on a piece, from two random words: half of a parallelogram is turned onto the other.
void find_shares(global const struct Piece* piece, uint u, uint v, uint* shares)
{
    if ((ulong)u + v > 0xffffffffu) {
        u = ~u;
        v = ~v;
    }
    for (int k = 0; k < 2; ++k) {
        const long origin = piece->shares[k];
        const long sum =
            ((long)piece->shares[2 + k] - origin) * (long)u + ((long)piece->shares[4 + k] - origin) * (long)v;
        shares[k] = (uint)(origin + (sum >> 32));
    }
}

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
    global const struct Piece* piece = &pieces[find_piece((ulong)words.x << 32 | words.y, batch, ends, guide)];
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
    const bool is_covered = has_conflict(&spot, triangles, &rule, heads, points);
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
    FOR_EACH_NEAR(&spot, rule->cell, batch.bucket_mask, dart_heads, darts, {
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

bool is_wider(const Place* a, const Place* b, ulong squared)
{
    ulong sum = 0;
    for (int k = 0; k < 3; ++k) {
        const long difference = (long)a->c[k] - b->c[k];
        sum += (ulong)(difference * difference);
    }
    return sum > squared;
}

/// Is the piece covered by one point's disk? Its edges are no longer than a disk is wide then.
bool is_covered(const Spot* corners, global const struct Triangle* triangles, const Rule* rule,
                global const uint* heads, global const Point* points)
{
    for (int i = 0; i < 3; ++i)
        if (is_wider(&corners[i].place, &corners[(i + 1) % 3].place, 4 * rule->covered)) return false;
    FOR_EACH_NEAR(&corners[0], rule->cell, rule->bucket_mask, heads, points, {
        bool is_inside = true;
        for (int i = 0; i < 3; ++i)
            is_inside = is_inside && squared_length(&corners[i].place, point->place) < rule->covered;
        if (is_inside && have_near_normals(&triangles[corners[0].triangle], &triangles[point->triangle],
                                           rule->least_cosine))
            return true;
    })
    return false;
}

kernel void cover_pieces(uint count, Rule rule, global const struct Triangle* triangles,
                         global const struct Piece* pieces, global const uint* heads, global const Point* points,
                         global uint* states)
{
    const uint id = get_global_id(0);
    if (id >= count) return;
    const struct Piece piece = pieces[id];
    Spot corners[3];
    for (int i = 0; i < 3; ++i) {
        corners[i].triangle = piece.triangle;
        find_place(&triangles[piece.triangle], piece.shares[2 * i], piece.shares[2 * i + 1], &corners[i].place);
    }
    states[id] = PIECE_OPEN;
    if (is_covered(corners, triangles, &rule, heads, points)) {
        states[id] = PIECE_COVERED;
    } else if (piece.halvings & LAST_PIECE) {
        Spot centre;
        centre.triangle = piece.triangle;
        const uint share_1 = (uint)(((ulong)piece.shares[0] + piece.shares[2] + piece.shares[4]) / 3);
        const uint share_2 = (uint)(((ulong)piece.shares[1] + piece.shares[3] + piece.shares[5]) / 3);
        find_place(&triangles[piece.triangle], share_1, share_2, &centre.place);
        if (has_conflict(&centre, triangles, &rule, heads, points)) states[id] = PIECE_SMALL;
    }
}
