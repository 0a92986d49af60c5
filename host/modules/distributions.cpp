// Points and objects that follow densities, masks, and the discrepancy of sets.
#include "host/distribution/discrepancy.hpp"
#include "host/distribution/masks/mask_picture.hpp"
#include "host/kinds/kinds.hpp"
#include "host/modules/laboratory.hpp"

namespace poissonlab {

void add_distributions(Laboratory& laboratory)
{
    for (Kind (*const kind)() :
         {warp_kind, object_kind, self_similar_kind, rank_kind, sampling_mask_kind, dither_mask_kind, mask_picture_kind,
          stippling_kind, hatching_kind, icon_kind, instance_kind, discrepancy_kind})
        laboratory.kinds.push_back(kind());
}

}
