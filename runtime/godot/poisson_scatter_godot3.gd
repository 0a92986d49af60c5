# SPDX-License-Identifier: MIT-0
#
# A node of Godot 3 that scatters a mesh over a rectangle around its origin, in its x and z, by a tile set file: nothing is
# nearer than `spacing`, and neighbouring rectangles of one seed and spacing fit without a seam. Copy it with
# poisson_tiles.gd into a project, add a PoissonScatter, and give its MultiMesh a mesh. Exports need *.ptiles among the
# files that are not resources.
tool
extends MultiMeshInstance
class_name PoissonScatter

const Tiles = preload("poisson_tiles.gd")

# The tiles of a rectangle may have so many points: more take minutes and gigabytes.
const MOST_POINTS = 10000000

export(String, FILE, "*.ptiles") var tile_set = "" setget set_tile_set
export(float, 0.001, 1000000) var spacing = 1.0 setget set_spacing # the least distance of two instances
export(Vector2) var size = Vector2(20, 20) setget set_size
export(float, 0, 1) var density = 1.0 setget set_density # the part of the instances that is there; none moves
export(int) var tiling_seed = 1 setget set_tiling_seed
export(Vector2) var offset = Vector2(0, 0) setget set_offset # of the rectangle in the tiling

var _tiles = Tiles.new()
var _read_file = ""


func _ready():
	scatter()


# The part of the instances that is there at a place of x and z: scripts that extend this one say it. From 0 to `density`.
func density_at(_place: Vector2) -> float:
	return density


# The transforms of instances: turned by random bits that belong to each.
func places() -> Array:
	var problem = _read()
	if problem != "":
		push_error("%s: %s" % [tile_set, problem])
		return []
	var side = spacing / _tiles.min_distance
	var count = (size.x / side + 1) * (size.y / side + 1) * _tiles.points_per_tile
	if not count <= MOST_POINTS:
		push_error("%s: %.0f points: must be at most %d" % [tile_set, count, MOST_POINTS])
		return []
	var corner = offset - size / 2
	_tiles.tiling_seed = tiling_seed
	var found = []
	for point in _tiles.points_in_window([corner.x / side, corner.y / side],
			[(corner.x + size.x) / side, (corner.y + size.y) / side], density):
		var place = Vector2(point.position[0] * side - offset.x, point.position[1] * side - offset.y)
		if point.level < density_at(place):
			var turn = TAU * (point.id & 0xffff) / 65536.0
			found.append(Transform(Basis(Vector3.UP, turn), Vector3(place.x, 0, place.y)))
	return found


# Places the instances anew.
func scatter() -> void:
	if tile_set == "" or multimesh == null:
		return
	var transforms = places()
	multimesh.instance_count = 0
	multimesh.transform_format = MultiMesh.TRANSFORM_3D
	multimesh.instance_count = transforms.size()
	for i in range(transforms.size()):
		multimesh.set_instance_transform(i, transforms[i])


func _read() -> String:
	if tile_set == "":
		return "no file is named"
	if _read_file == tile_set:
		return ""
	var file = File.new()
	if file.open(tile_set, File.READ) != OK:
		return "cannot be opened"
	var problem = _tiles.read(file.get_buffer(file.get_len()))
	if problem == "" and _tiles.dimension != 2:
		problem = "tiles of space: must be a tile set in the plane"
	if problem == "" and _tiles.min_distance == 0:
		problem = "the file has no proven distance"
	_read_file = tile_set if problem == "" else ""
	return problem


func _changed() -> void:
	if is_inside_tree():
		scatter()


func set_tile_set(value):
	tile_set = value
	_changed()


func set_spacing(value):
	spacing = value
	_changed()


func set_size(value):
	size = value
	_changed()


func set_density(value):
	density = value
	_changed()


func set_tiling_seed(value):
	tiling_seed = value
	_changed()


func set_offset(value):
	offset = value
	_changed()
