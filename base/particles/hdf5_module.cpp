// The module poissonlab_particles: see base/points/hdf5_points.cpp.
#include "base/points/hdf5_files.hpp"

extern "C" __attribute__((visibility("default"))) const poissonlab::Hdf5Files* poissonlab_hdf5_files()
{
    static constexpr poissonlab::Hdf5Files files{poissonlab::write_hdf5_file, poissonlab::columns_of_hdf5_file,
                                                 poissonlab::head_of_hdf5_file, poissonlab::stream_hdf5_file,
                                                 poissonlab::parts_of_hdf5_file};
    return &files;
}
