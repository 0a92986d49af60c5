# SPDX-License-Identifier: MIT-0
#
# Poisson disk (sphere) distributions without end, from a tile set file, in GDScript: the look-ups of poisson_tiles.h,
# to the last bit. The same text is for Godot 3 and Godot 4.
#
#     var tiles = PoissonTiles.new()
#     var problem = tiles.read(bytes)    # the bytes of a .ptiles file; "" if they can be used
#     for point in tiles.points_in_window([0, 0], [16, 9], 0.5):
#         plant(point.position, point.id)
#
# Tiles have side 1, the tile [i, j, k] has its lowest corner there. Positions are arrays of numbers, which have 64 bits:
# a Vector2 is too short for places a million tiles away. docs/tile-set-file.md describes the file.
extends Resource
class_name PoissonTiles

# Which tiling: every seed of 32 bits is another one. It closes after `period` tiles along each axis; 0: never.
var tiling_seed: int = 1
var period: int = 0

var kind: int = 0 # 0: tiles by colours of corners, 1: by colours of edges, 2: template tiles
var dimension: int = 0 # 0: nothing was read
var colors: int = 0
var tile_count: int = 0
var points_per_tile: int = 0
var min_distance: float = 0.0 # no two points of any tiling are nearer, in tiles; 0: the file has no proof
var exponent: int = 2 # power goes to 0 with this power of the frequency, at least
var below: int = 0 # units of 1/65536 tile that points are below their tile's square at most
var above: int = 0
var ranked: bool = false
var class_points: Array = [] # of each class in a tile; empty: points have none

var _low: int = 0 # the stored number u is the coordinate low + step * u, in units
var _step: int = 1
var _coordinates: Array = [] # in tiles: tile after tile, point after point, x before y before z
var _ranks: Array = []


# Reads the bytes of a file. "": they can be used; otherwise what is wrong. Does not check the checksum.
func read(bytes) -> String:
	dimension = 0
	if bytes.size() < 128:
		return "shorter than the header of a tile set file"
	var magic = [0x50, 0x54, 0x49, 0x4c, 0x45, 0x53, 13, 10]
	for i in range(8):
		if bytes[i] != magic[i]:
			return "not a tile set file"
	var version = _word(bytes, 8)
	if version < 1 or version > 3 or _word(bytes, 12) != 128:
		return "an unknown version of the file format"
	var problem = _read_header(bytes, version)
	if problem != "":
		return problem
	var axes = _word(bytes, 20)
	var chains = version > 1 and _word(bytes, 88) == 1
	var count = tile_count * points_per_tile
	var before_ranks = count * axes + (2 * colors * colors if chains else 0)
	var end = 128 + 2 * (before_ranks + (count if ranked else 0))
	var classes = _word(bytes, 36) if version > 2 else 0
	if classes > 32 or (version > 2 and classes == 0) or bytes.size() != end + 4 * classes + 8 * classes * (classes + 1):
		return "too short or too long for its points"
	problem = _read_classes(bytes, end, classes)
	if problem != "":
		return problem
	_coordinates = []
	_coordinates.resize(count * axes)
	for n in range(count * axes):
		_coordinates[n] = (_low + _step * (bytes[128 + 2 * n] | bytes[129 + 2 * n] << 8)) / 65536.0
	_ranks = []
	if ranked:
		_ranks.resize(count)
		for n in range(count):
			var at = 128 + 2 * (before_ranks + n)
			_ranks[n] = bytes[at] | bytes[at + 1] << 8
	dimension = axes
	return ""


func _read_header(bytes, version: int) -> String:
	kind = _word(bytes, 16)
	var axes = _word(bytes, 20)
	colors = _word(bytes, 24)
	tile_count = _word(bytes, 28)
	points_per_tile = _word(bytes, 32)
	var chains = _word(bytes, 88) if version > 1 else 0
	below = _word(bytes, 100) if version > 1 else 0
	above = _word(bytes, 104) if version > 1 else 0
	var has_ranks = _word(bytes, 108) if version > 1 else 0
	if has_ranks > 1 or chains > 1 or below > 32768 or above > 32768:
		return "an unknown kind of borders or ranks"
	if kind > 2 or (axes != 2 and (axes != 3 or kind != 0)):
		return "an unknown kind of tiles"
	if colors == 0 or tile_count == 0 or points_per_tile == 0 or points_per_tile > 65536 \
			or (kind != 2 and tile_count != _number_of_tiles(axes)):
		return "numbers of colours, tiles and points that do not fit together"
	ranked = has_ranks == 1
	_low = -32768 if chains == 1 else 0
	_step = 2 if chains == 1 else 1
	exponent = 2 * ((_word(bytes, 112) if version > 1 else 0) + 1)
	min_distance = sqrt(_word(bytes, 40) + 4294967296.0 * _word(bytes, 44)) / 65536.0
	return ""


func _read_classes(bytes, at: int, classes: int) -> String:
	class_points = []
	var sum = 0
	for c in range(classes):
		class_points.append(_word(bytes, at + 4 * c))
		sum += class_points[c]
	if classes > 0 and sum != points_per_tile:
		return "classes that have not all points of a tile"
	return ""


func _word(bytes, at: int) -> int:
	return bytes[at] | bytes[at + 1] << 8 | bytes[at + 2] << 16 | bytes[at + 3] << 24


# How many tiles a set has that knows so many colours; 0: more than there can be.
func _number_of_tiles(axes: int) -> int:
	var count = 1
	for _digit in range(12 if kind == 1 else 1 << axes):
		count *= colors
		if count > 0xffffffff:
			return 0
	return count


# The class of a point by its index in its tile, where points come class after class; 0 where they have none.
func class_of(index: int) -> int:
	var c = 0
	while c + 1 < class_points.size() and index >= class_points[c]:
		index -= class_points[c]
		c += 1
	return c


# The number of the tile at a place; k is 0 in 2D.
func tile(i: int, j: int, k: int = 0) -> int:
	var x = _place(i)
	var y = _place(j)
	var z = _place(k)
	if kind == 2:
		return tile_hash(tiling_seed, x, y, 0) % tile_count
	if kind == 1:
		return _edges(x, y)
	if dimension == 2:
		return _corners(x, y, 0)
	return _corners(x, y, _after(z)) * colors * colors * colors * colors + _corners(x, y, z)


# All points with low <= position < high along each axis and a level below `density`, from 0 to 1. Rows of tiles from
# south to north (3D: layers from the bottom), in each from west to east. A point is a dictionary: position, tile (its
# place), index (in its tile), id (32 random bits that stay with it), level (the density above which it is there).
func points_in_window(low, high, density: float = 1.0) -> Array:
	var first = [0, 0, 0]
	var last = [0, 0, 0]
	for axis in range(dimension):
		first[axis] = int(floor(low[axis] - above / 65536.0))
		last[axis] = int(floor(high[axis] + below / 65536.0))
	var found = []
	for k in range(first[2], last[2] + 1):
		for j in range(first[1], last[1] + 1):
			for i in range(first[0], last[0] + 1):
				_add_points([i, j, k], low, high, density, found)
	return found


func _add_points(place: Array, low, high, density: float, found: Array) -> void:
	var number = tile(place[0], place[1], place[2])
	for index in range(points_per_tile):
		var at = (number * points_per_tile + index) * dimension
		var inside = true
		for axis in range(dimension):
			var x = place[axis] + _coordinates[at + axis]
			inside = inside and x >= low[axis] and x < high[axis]
		if inside and (density >= 1 or level(place, number, index) < density):
			found.append(point_at(place, number, index))


# A point of the tile at a place, whose number is `number`.
func point_at(place: Array, number: int, index: int) -> Dictionary:
	var position = [0.0, 0.0, 0.0]
	for axis in range(dimension):
		position[axis] = place[axis] + _coordinates[(number * points_per_tile + index) * dimension + axis]
	return {
		"position": position,
		"tile": place,
		"index": index,
		"id": id(place, index),
		"level": level(place, number, index),
	}


# The density, from 0 to 1, above which a point is there.
func level(place: Array, number: int, index: int) -> float:
	if ranked:
		return (_ranks[number * points_per_tile + index] + 0.5) / points_per_tile
	return id(place, index) / 4294967296.0


# Random bits that stay with a point (and its repetitions).
func id(place: Array, index: int) -> int:
	return _mix(tile_hash(tiling_seed, _place(place[0]), _place(place[1]), _place(place[2])) + 1 + index)


# Numbers of 32 bits. Products are those of 64 bits, of which the lower half is right.
func _mix(v: int) -> int:
	v &= 0xffffffff
	v = ((v ^ v >> 16) * 0x21f0aaad) & 0xffffffff
	v = ((v ^ v >> 15) * 0xd35a2d97) & 0xffffffff
	return v ^ v >> 15


# The hash that says which tile is where.
func tile_hash(number: int, x: int, y: int, z: int) -> int:
	return _mix(_mix(_mix(_mix(number) + x) + y) + z)


# A place as the hash function takes it, and those after and before it.
func _place(i: int) -> int:
	return i & 0xffffffff if period == 0 else ((i % period) + period) % period


func _after(x: int) -> int:
	return 0 if x + 1 == period else (x + 1) & 0xffffffff


func _before(x: int) -> int:
	return ((period if x == 0 else x) - 1) & 0xffffffff


# The colour at a lattice point: of the corner, or of the edge that goes east (z = 0) or north (z = 1).
func _color(x: int, y: int, z: int) -> int:
	return tile_hash(tiling_seed, x, y, z) % colors


func _corners(x: int, y: int, z: int) -> int:
	var east = _after(x)
	var north = _after(y)
	var number = _color(east, north, z) * colors + _color(east, y, z)
	return (number * colors + _color(x, y, z)) * colors + _color(x, north, z)


func _edges(x: int, y: int) -> int:
	var east = _after(x)
	var west = _before(x)
	var north = _after(y)
	var south = _before(y)
	var edges = [[x, north, 0], [east, y, 1], [x, y, 0], [x, y, 1], [east, north, 0], [east, north, 1],
			[east, y, 0], [east, south, 1], [west, y, 0], [x, south, 1], [west, north, 0], [x, north, 1]]
	var number = 0
	for edge in edges:
		number = number * colors + _color(edge[0], edge[1], edge[2])
	return number
