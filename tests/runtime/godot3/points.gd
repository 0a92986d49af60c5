# runtime/godot/poisson_tiles.gd in Godot 3, as godot3.sh starts it: godot3-server --path PROJECT -s points.gd. What it is
# to do is in files of the project, one line a piece of work; any problem is printed with "FAILED".
extends SceneTree

const Tiles = preload("poisson_tiles.gd")


func _init():
	check_vectors()
	for line in lines_of("res://windows.txt"):
		write_window(line.split(" "))
	say_problems()
	check_scatter()
	print("DONE")
	quit()


func bytes_of(name):
	var file = File.new()
	if file.open(name, File.READ) != OK:
		print("FAILED: no ", name)
		return PoolByteArray()
	return file.get_buffer(file.get_len())


func lines_of(name):
	return bytes_of(name).get_string_from_ascii().strip_edges().split("\n")


func tiles_of(name):
	var tiles = Tiles.new()
	var problem = tiles.read(bytes_of("res://" + name + ".ptiles"))
	if problem != "":
		print("FAILED: ", name, ": ", problem)
	return tiles


# test_vectors.csv: tiles, points, ids, levels.
func check_vectors():
	var lines = lines_of("res://test_vectors.csv")
	var sets = {}
	for n in range(1, lines.size()):
		var words = lines[n].split(",")
		if not sets.has(words[0]):
			sets[words[0]] = tiles_of(words[0])
		var tiles = sets[words[0]]
		var v = []
		for word in words:
			v.append(int(word))
		tiles.tiling_seed = v[1]
		tiles.period = v[2]
		var place = [v[3], v[4], v[5]]
		var number = tiles.tile(v[3], v[4], v[5])
		var p = tiles.point_at(place, number, v[7])
		var found = [number]
		for axis in range(3):
			found.append(int((p.position[axis] - place[axis] if axis < tiles.dimension else 0.0) * 65536))
		found.append(p.id)
		if found != [v[6], v[8], v[9], v[10], v[11]] or abs(p.level - float(words[12])) > 1e-12:
			print("FAILED: ", lines[n], ": ", found, " ", p.level)
	print(lines.size() - 1, " vectors")


# A line: set, seed, density, axes, low, size, file. Writes coordinates from the lowest corner, doubles.
func write_window(words):
	var tiles = tiles_of(words[0])
	tiles.tiling_seed = int(words[1])
	var axes = int(words[3])
	var low = []
	var high = []
	for axis in range(axes):
		low.append(float(words[4 + axis]))
		high.append(low[axis] + float(words[4 + axes + axis]))
	var file = File.new()
	file.open("res://" + words[4 + 2 * axes], File.WRITE)
	for point in tiles.points_in_window(low, high, float(words[2])):
		for axis in range(axes):
			file.store_double(point.position[axis] - low[axis])
	file.close()


# What is said of damaged files: one line each.
func say_problems():
	var good = bytes_of("res://corner-c3-n64-r075.ptiles")
	var cut = good.subarray(0, 99)
	var other = PoolByteArray(good)
	other[0] = 88
	var version = PoolByteArray(good)
	version[8] = 9
	var colors = PoolByteArray(good)
	colors[24] = 4
	var longer = PoolByteArray(good)
	longer.append(0)
	for bytes in [cut, other, version, colors, longer]:
		print("problem: ", Tiles.new().read(bytes))


# The node: no two instances are nearer than its spacing, and less density takes some away and moves none.
func check_scatter():
	var node = load("res://poisson_scatter_godot3.gd").new()
	node.tile_set = "res://corner-c3-n64-r075.ptiles"
	node.spacing = 1.5
	var all = node.places()
	var least = 1e9
	for a in range(all.size()):
		for b in range(a):
			least = min(least, all[a].origin.distance_to(all[b].origin))
	node.density = 0.5
	var origins = {}
	for transform in all:
		origins[transform.origin] = true
	var moved = 0
	var half = node.places()
	for transform in half:
		if not origins.has(transform.origin):
			moved += 1
	node.multimesh = MultiMesh.new()
	node.scatter()
	print("scatter: ", all.size(), " ", half.size(), " ", moved, " ", least, " ", node.multimesh.instance_count)
	node.tile_set = "res://sphere-c2-n128-r075.ptiles"
	if node.places().size() != 0:
		print("FAILED: tiles of space in the plane")
	node.tile_set = "res://corner-c3-n64-r075.ptiles"
	node.spacing = 0.001
	node.size = Vector2(10000, 10000)
	if node.places().size() != 0:
		print("FAILED: too many points were made")
	node.spacing = 1000.0
	node.tile_set = ""
	if node.places().size() != 0:
		print("FAILED: points of no file")
	node.free()
