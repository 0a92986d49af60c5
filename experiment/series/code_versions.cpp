#include "experiment/series/code_versions.hpp"

#include "code_hashes.hpp"

namespace poissonlab {

CodeVersions CodeVersions::current()
{
    return {POISSONLAB_SAMPLING_VERSION, POISSONLAB_ANALYSIS_VERSION, POISSONLAB_PICTURE_VERSION,
            POISSONLAB_DISTRIBUTION_VERSION};
}

}
