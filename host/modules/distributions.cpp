// Points and objects that follow densities, fill regions, and lie on surfaces; masks, cells, classes.
#include "host/distribution/masks/mask_picture.hpp"
#include "host/distribution/regions/line_set.hpp"
#include "host/kinds/kinds.hpp"
#include "host/modules/laboratory.hpp"

namespace poissonlab {

void add_distributions(Laboratory& laboratory)
{
    for (Kind (*const kind)() :
         {warp_kind, object_kind, self_similar_kind, rank_kind, dart_kind, region_point_kind, class_kind,
          surface_point_kind, sampling_mask_kind, dither_mask_kind, mask_picture_kind, line_set_kind, cell_kind,
          stippling_kind, hatching_kind, icon_kind, instance_kind})
        laboratory.kinds.push_back(kind());
}

}
