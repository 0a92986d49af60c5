// Keys whose values are lists with a number for each class of points, or for each pair of classes.
#pragma once

#include "host/settings/keys/keys.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace poissonlab {

/// Numbers of classes in `range`, as many as classes at most; `each` says what a number is.
Keys::Said class_list(Keys& keys, const std::string& key, std::vector<double>& values, Interval range,
                      const std::string& each, std::string help);

/// Whole numbers of classes, from 1 to `most`.
Keys::Said class_counts(Keys& keys, const std::string& key, std::vector<std::size_t>& counts, std::int64_t most,
                        std::string help);

/// The least distances of all pairs of classes, a symmetric matrix, row after row.
Keys::Said class_matrix(Keys& keys, const std::string& key, std::vector<double>& matrix, Interval range);

}
