// Dart throwing by Voronoi cells, in batches: darts fall into what each point's disk leaves of its cell.
//
// Jones, Efficient generation of Poisson-disk sampling patterns, journal of graphics tools 11(2), 2006; dissertation,
// section 6.12. The plain twin of these kernels, which gives the same bytes, is
// host/sampling/reference/voronoi_darts.cpp; host/sampling/voronoi_darts.cpp runs them, batch after batch:
//   measure_cells   the free area of cells as an integer
//   choose_sites    the cell whose free area each dart falls into
//   throw_darts     places that are uniform in all free area, one dart each; those that a point rejects are told
//   resolve_darts   (in rounds) a dart is rejected when an earlier dart of the batch within the minimum distance is
//                   accepted, and accepted when all of those are rejected: exactly what throwing them one by one gives
//   insert_darts    accepted darts become points
// Work-items that follow each other look into neighbouring rows of the grid, or memory far away would keep those of large
// sets waiting: count_sites and choose_sites count what is in each row, and order_items lists sites and darts by rows. In
// which order they are worked on decides about the time only.
// Double precision serves the geometry, without library functions but the square root, which is rounded correctly, so
// that bytes are the same everywhere. Neighbours cut a cell in the order of the list of offsets.

#pragma OPENCL FP_CONTRACT OFF

#define DIMENSION 2
#define LARGE_DISKS 0

#include "kernels/common/philox.clh"
#include "kernels/common/polygon.clh"
#include "kernels/common/torus.clh"
#include "kernels/common/darts/voronoi_darts.h"

#define UNITS 4294967296.0
#define QUARTER_TURN 1.5707963267948966
#define ROOM_FOR_ROUNDING (1 + 0x1p-40)

uint cell_of(uint coordinate, uint grid_size) { return (uint)(((ulong)coordinate * grid_size) >> 32); }

/// The number of this work-item's site or dart: in the order of rows, if there is one.
uint item_of(uint is_ordered, global const uint* order, uint count)
{
    const uint id = get_global_id(0);
    return is_ordered && id < count ? order[id] : id;
}

/// The Voronoi cell of a point; no vertices where its disk covers it. False where it is unknown.
bool find_cell(struct Torus torus, constant const struct Offset* offsets, global const uint* slots,
               global const uint* places, uint x, uint y, Polygon* cell)
{
    const uint cell_x = cell_of(x, torus.grid_size);
    const uint cell_y = cell_of(y, torus.grid_size);
    const double far = MAX_GAP * sqrt(torus.squared_cell);
    *cell = square_around(far);
    double squared_radius = 2 * far * far;
    for (uint i = 1; i < torus.offsets; ++i) {
        const struct Offset offset = offsets[i];
        if (offset.squared_gap * torus.squared_cell > 4 * squared_radius * ROOM_FOR_ROUNDING) return true;
        int turns_x, turns_y;
        const uint other_x = turned_cell(cell_x, offset.x, (int)torus.grid_size, &turns_x);
        const uint other_y = turned_cell(cell_y, offset.y, (int)torus.grid_size, &turns_y);
        const uint other = other_y * torus.grid_size + other_x;
        const uint slot = slots[other];
        if (slot == 0) continue;
        const double to_x = (double)places[2 * other] - (double)x + turns_x * UNITS;
        const double to_y = (double)places[2 * other + 1] - (double)y + turns_y * UNITS;
        if (to_x * to_x + to_y * to_y >= 4 * squared_radius) continue;
        if (!cut(cell, to_x, to_y, slot)) return false;
        squared_radius = squared_radius_of(cell);
        if (squared_radius <= (double)torus.squared_min_distance) {
            cell->count = 0;
            return true;
        }
    }
    return false;
}

/// The angle of a direction with y >= 0, from 0 to half a turn.
double angle_of(double x, double y)
{
    const double across = x < 0 ? -x : x;
    const double big = across > y ? across : y;
    const double small = across > y ? y : across;
    // A rotation reduces the angle to a sixteenth of half a turn, for which the series of the arcus tangent is summed.
    double base = 0, along = big, up = small;
    if (small > big * 0.66817863791929888) {
        base = QUARTER_TURN / 2;
        along = big + small;
        up = small - big;
    } else if (small > big * 0.19891236737965800) {
        base = QUARTER_TURN / 4;
        along = big + small * 0.41421356237309503;
        up = small - big * 0.41421356237309503;
    }
    const double z = up / along;
    const double square_z = z * z;
    double series = 1.0 / 25;
    for (int n = 23; n > 0; n -= 2) series = 1.0 / n - square_z * series;
    const double small_angle = base + z * series;
    const double angle = across > y ? small_angle : QUARTER_TURN - small_angle;
    return x < 0 ? 2 * QUARTER_TURN - angle : angle;
}

/// A part of an edge that is outside of the site's disk: `begin` to `end` along the edge's line, from its foot.
typedef struct
{
    double direction_x, direction_y;
    double height; // of the line above the site
    double begin, end;
} Piece;

/// The parts of an edge that are outside of the disk: at most two, some of them empty.
uint pieces_of(const Polygon* cell, uint edge, double squared_min_distance, Piece* pieces)
{
    const uint next = edge + 1 < cell->count ? edge + 1 : 0;
    const double ax = cell->x[edge], ay = cell->y[edge];
    const double bx = cell->x[next], by = cell->y[next];
    const double length = sqrt((bx - ax) * (bx - ax) + (by - ay) * (by - ay));
    if (!(length > 0)) return 0;
    Piece piece;
    piece.direction_x = (bx - ax) / length;
    piece.direction_y = (by - ay) / length;
    piece.height = (ax * by - ay * bx) / length;
    piece.begin = ax * piece.direction_x + ay * piece.direction_y;
    piece.end = bx * piece.direction_x + by * piece.direction_y;
    pieces[0] = pieces[1] = piece;
    const double squared_half_chord = squared_min_distance - piece.height * piece.height;
    if (!(squared_half_chord > 0)) return 1;
    const double half_chord = sqrt(squared_half_chord);
    if (pieces[0].end > -half_chord) pieces[0].end = -half_chord;
    if (pieces[1].begin < half_chord) pieces[1].begin = half_chord;
    return 2;
}

/// The area between a piece and the disk, rounded.
ulong area_of(const Piece* piece, double squared_min_distance)
{
    const double length = piece->end - piece->begin;
    if (!(length > 0 && piece->height > 0)) return 0;
    const double angle =
        angle_of(piece->height * piece->height + piece->begin * piece->end, piece->height * length);
    const double area = (piece->height * length - squared_min_distance * angle) / 2;
    return area > 0 ? (ulong)(area + 0.5) : 0;
}

/// One work-item owns one of the sites, and the free area of its cell.
kernel void measure_cells(struct Torus torus, constant const struct Offset* offsets, global const uint* points,
                          global const uint* slots, global const uint* places, global const uint* sites,
                          uint site_count, uint is_ordered, global const uint* order, global ulong* areas)
{
    const uint id = item_of(is_ordered, order, site_count);
    if (id >= site_count) return;
    const double squared_min_distance = (double)torus.squared_min_distance;
    Polygon cell;
    ulong area = 0;
    const uint site = sites[id];
    if (find_cell(torus, offsets, slots, places, points[2 * site], points[2 * site + 1], &cell)) {
        for (uint edge = 0; edge < cell.count; ++edge) {
            Piece pieces[2];
            const uint count = pieces_of(&cell, edge, squared_min_distance, pieces);
            for (uint k = 0; k < count; ++k) area += area_of(&pieces[k], squared_min_distance);
        }
    } else {
        area = UNKNOWN_AREA;
    }
    areas[id] = area;
}

ulong long_word(uint high, uint low) { return (ulong)high << 32 | low; }

/// A uniform place between a piece and the disk: a place on the piece, by how much there is between it and the disk,
/// and a distance. False for a dart that is lost.
bool place_in(const Piece* piece, double squared_min_distance, uint dart, uint batch, uint2 key, double2* place)
{
    const double squared_height = piece->height * piece->height;
    const double squared_begin = squared_height + piece->begin * piece->begin;
    const double squared_end = squared_height + piece->end * piece->end;
    const double farthest = squared_begin > squared_end ? squared_begin : squared_end;
    const double most = (farthest - squared_min_distance) / farthest;
    for (uint trial = 1; trial <= MAX_TRIALS; ++trial) {
        const uint4 words = philox((uint4)(dart, batch, trial, 0), key);
        const double part = (double)(long_word(words.x, words.y) >> 11) * 0x1p-53;
        const double along = piece->begin + part * (piece->end - piece->begin);
        const double squared = squared_height + along * along;
        if (!(words.z * 0x1p-32 * most * squared < squared - squared_min_distance)) continue;
        const double squared_distance =
            squared_min_distance + (words.w + 0.5) * 0x1p-32 * (squared - squared_min_distance);
        const double scale = sqrt(squared_distance / squared);
        place->x = (piece->height * piece->direction_y + along * piece->direction_x) * scale;
        place->y = (along * piece->direction_y - piece->height * piece->direction_x) * scale;
        return true;
    }
    return false;
}

/// The place of free area number `rest` of a cell.
bool place_in_cell(const Polygon* cell, ulong rest, double squared_min_distance, uint dart, uint batch, uint2 key,
                   double2* place)
{
    for (uint edge = 0; edge < cell->count; ++edge) {
        Piece pieces[2];
        const uint count = pieces_of(cell, edge, squared_min_distance, pieces);
        for (uint k = 0; k < count; ++k) {
            const ulong area = area_of(&pieces[k], squared_min_distance);
            if (rest < area) return place_in(&pieces[k], squared_min_distance, dart, batch, key, place);
            rest -= area;
        }
    }
    return false;
}

uint to_units(double length) { return (uint)(long)floor(length + 0.5); }

/// Is a point nearer than the minimum distance?
bool is_covered(struct Torus torus, constant const struct Offset* offsets, global const uint* slots,
                global const uint* places, const Position* position)
{
    const uint cell_x = cell_of(position->c[0], torus.grid_size);
    const uint cell_y = cell_of(position->c[1], torus.grid_size);
    for (uint i = 0; i < torus.near_offsets; ++i) {
        int turns;
        const uint other_x = turned_cell(cell_x, offsets[i].x, (int)torus.grid_size, &turns);
        const uint other_y = turned_cell(cell_y, offsets[i].y, (int)torus.grid_size, &turns);
        const uint cell = other_y * torus.grid_size + other_x;
        if (slots[cell] == 0) continue;
        const Position other = {{places[2 * cell], places[2 * cell + 1]}};
        if (squared_distance(&other, position) < torus.squared_min_distance) return true;
    }
    return false;
}

/// The random words that choose a dart's place.
uint4 words_of(uint dart, struct Batch batch)
{
    return philox((uint4)(dart, batch.number, 0, 0), (uint2)(batch.key_x, batch.key_y));
}

/// The place of a dart in all free area.
ulong chosen_area(uint4 words, struct Batch batch) { return mul_hi(long_word(words.x, words.y), batch.free_area); }

/// One work-item owns one site. Stores its row of the grid, and adds it to those that the row has.
kernel void count_sites(uint grid_size, global const uint* points, global const uint* sites, uint site_count,
                        global uint* rows, global uint* counts)
{
    const uint id = get_global_id(0);
    if (id >= site_count) return;
    const uint row = cell_of(points[2 * sites[id] + 1], grid_size);
    rows[id] = row;
    atomic_inc(&counts[row]);
}

/// One work-item owns one dart. Stores the place in the list of the site into whose cell it falls, and the row of the
/// grid that it falls into or near, and adds it to those that the row has. `ends` are the sums of the sites' areas, each
/// with those before.
kernel void choose_sites(struct Torus torus, struct Batch batch, global const uint* points, global const uint* sites,
                         global const ulong* ends, global uint* chosen, global uint* rows, global uint* counts)
{
    const uint id = get_global_id(0);
    if (id >= batch.darts) return;
    const uint4 words = words_of(id, batch);
    uint y = words.y;
    if (batch.free_area > 0) {
        const ulong area = chosen_area(words, batch);
        uint begin = 0, end = batch.sites - 1;
        while (begin < end) {
            const uint middle = (begin + end) / 2;
            if (ends[middle] > area) {
                end = middle;
            } else {
                begin = middle + 1;
            }
        }
        chosen[id] = begin;
        y = points[2 * sites[begin] + 1];
    }
    const uint row = cell_of(y, torus.grid_size);
    rows[id] = row;
    atomic_inc(&counts[row]);
}

/// One work-item owns one site or dart. Lists it with those of its row, whose free place in the list is `next`.
kernel void order_items(uint count, global const uint* rows, global uint* next, global uint* order)
{
    const uint id = get_global_id(0);
    if (id < count) order[atomic_inc(&next[rows[id]])] = id;
}

/// One work-item owns one dart: its place, its state, and its link in the chain of its cell. `heads` hold 0, or 1 + the
/// number of a dart.
kernel void throw_darts(struct Torus torus, struct Batch batch, constant const struct Offset* offsets,
                        global const uint* points, global const uint* slots, global const uint* places,
                        global const uint* sites, global const ulong* ends, global const uint* chosen,
                        uint is_ordered, global const uint* order, global uint* darts, global uint* states,
                        global uint* next, global uint* heads)
{
    const uint id = item_of(is_ordered, order, batch.darts);
    if (id >= batch.darts) return;
    const uint2 key = (uint2)(batch.key_x, batch.key_y);
    const uint4 words = words_of(id, batch);
    Position position = {{words.x, words.y}};
    bool is_there = true;
    if (batch.free_area > 0) {
        const uint begin = chosen[id];
        const ulong rest = chosen_area(words, batch) - (begin > 0 ? ends[begin - 1] : 0);
        const uint x = points[2 * sites[begin]];
        const uint y = points[2 * sites[begin] + 1];
        Polygon cell;
        double2 place = 0;
        find_cell(torus, offsets, slots, places, x, y, &cell);
        is_there = place_in_cell(&cell, rest, (double)torus.squared_min_distance, id, batch.number, key, &place);
        position.c[0] = x + to_units(place.x);
        position.c[1] = y + to_units(place.y);
    }
    darts[2 * id] = position.c[0];
    darts[2 * id + 1] = position.c[1];
    if (!is_there || is_covered(torus, offsets, slots, places, &position)) {
        states[id] = REJECTED;
        return;
    }
    states[id] = UNDECIDED;
    const uint cell =
        cell_of(position.c[1], torus.grid_size) * torus.grid_size + cell_of(position.c[0], torus.grid_size);
    next[id] = atomic_xchg(&heads[cell], id + 1);
}

/// One work-item owns one dart and its next state; the states that the round before left are only read. Where a dart
/// has to wait, `waiting` becomes 1.
kernel void resolve_darts(struct Torus torus, uint dart_count, constant const struct Offset* offsets,
                          uint is_ordered, global const uint* order, global const uint* darts,
                          global const uint* next, global const uint* heads, global const uint* states,
                          global uint* next_states, global uint* waiting)
{
    const uint id = item_of(is_ordered, order, dart_count);
    if (id >= dart_count) return;
    uint state = states[id];
    if (state == UNDECIDED) {
        const Position position = {{darts[2 * id], darts[2 * id + 1]}};
        const uint cell_x = cell_of(position.c[0], torus.grid_size);
        const uint cell_y = cell_of(position.c[1], torus.grid_size);
        bool waits = false;
        for (uint i = 0; i < torus.near_offsets && state == UNDECIDED; ++i) {
            int turns;
            const uint other_x = turned_cell(cell_x, offsets[i].x, (int)torus.grid_size, &turns);
            const uint other_y = turned_cell(cell_y, offsets[i].y, (int)torus.grid_size, &turns);
            for (uint link = heads[other_y * torus.grid_size + other_x]; link > 0; link = next[link - 1]) {
                const uint other = link - 1;
                if (other >= id || states[other] == REJECTED) continue;
                const Position other_position = {{darts[2 * other], darts[2 * other + 1]}};
                if (squared_distance(&other_position, &position) >= torus.squared_min_distance) continue;
                if (states[other] == ACCEPTED) {
                    state = REJECTED;
                    break;
                }
                waits = true;
            }
        }
        if (state == UNDECIDED && !waits) state = ACCEPTED;
        if (state == UNDECIDED) *waiting = 1;
    }
    next_states[id] = state;
}

/// One work-item owns one dart: forgets the chain of its cell, and makes it a point if it has a number (from 1 on).
kernel void insert_darts(uint grid_size, uint dart_count, global const uint* darts, global const uint* numbers,
                         global uint* points, global uint* slots, global uint* places, global uint* heads)
{
    const uint id = get_global_id(0);
    if (id >= dart_count) return;
    const uint x = darts[2 * id];
    const uint y = darts[2 * id + 1];
    const uint cell = cell_of(y, grid_size) * grid_size + cell_of(x, grid_size);
    heads[cell] = 0;
    const uint number = numbers[id];
    if (number == 0) return;
    slots[cell] = number;
    places[2 * cell] = x;
    places[2 * cell + 1] = y;
    points[2 * number - 2] = x;
    points[2 * number - 1] = y;
}
