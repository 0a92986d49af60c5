// A small experiment with every kind of work, for tests that disturb it.
#pragma once

namespace poissonlab {

/// Series of several parts and of one, iterations, a tile set, a deterministic set, a tiling and a construction.
inline constexpr const char* survival_config = R"(title = "Survival"
[analysis]
points = 64
realizations = 34
[[method]]
sampler = "random"
[[method]]
sampler = "dart-throwing"
relative_radius = 0.65
[[method]]
sampler = "lloyd"
iterations = 4
start = "random"
[[method]]
sampler = "corner-tiles"
colors = 1
points_per_tile = 32
relative_radius = 0.6
lloyd_iterations = 2
[[method]]
sampler = "regular"
[[tiling]]
kind = "corner"
colors = 2
window = [0, 0, 8, 8]
[[construction]]
kind = "corner"
show = "corner"
colors = 2
points_per_tile = 32
relative_radius = 0.6
lloyd_iterations = 2
)";

}
