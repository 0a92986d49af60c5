// The speed of tile-based texture mapping on a device.
#pragma once

#include "host/texture/mapping/texture_map.hpp"

namespace poissonlab {

inline constexpr int frame_width = 1024, frame_height = 576; ///< pixels

/// Frames of the endless plane that the device draws and hands over in a second, the median of several: between mipmap
/// levels, from the packed atlas, as graphics cards do. It differs from run to run. Throws InputError
/// where the device has too little memory, and Interrupted.
double frames_a_second(Device& device, const TexturePyramid& pyramid);

}
