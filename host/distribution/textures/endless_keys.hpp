// The keys of endless textures that are no tiles: of tables [[texture]], and of `texture endless`.
#pragma once

#include "host/settings/keys/keys.hpp"
#include "host/texture/endless/endless_request.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

/// All but the method and the exemplar.
void endless_keys(Keys& keys, EndlessRequest& request);

/// Throws InputError for keys that are given although the method does not take them; `key` chooses the method.
void check_keys_of_method(const Keys& keys, EndlessMethod method, const std::string& key);

/// Checks a request that was read against the size of its exemplar, by the header of its file, or of a pattern.
void check_exemplar_size(const Keys& keys, const EndlessRequest& request, const std::filesystem::path& exemplar,
                         int pattern_size);

/// "Gravel: hexagons of 148 pixels, variance restored"
std::string endless_label(const EndlessRequest& request, const std::string& exemplar);

/// The words of `show` that a method has.
std::vector<std::string> endless_shows(EndlessMethod method);

}
