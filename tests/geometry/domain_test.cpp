#include "geometry/domain.hpp"
