// Printed by edges.py.
#pragma once

namespace poissonlab {

/// Gaussians of growing width in whole 65,536ths, from the middle to one side.
inline constexpr int edge_blurs[8][10] = {
    {65034, 251, 0, 0, 0, 0, 0, 0, 0, 0},
    {60242, 2647, 0, 0, 0, 0, 0, 0, 0, 0},
    {51550, 6976, 17, 0, 0, 0, 0, 0, 0, 0},
    {37346, 13461, 630, 4, 0, 0, 0, 0, 0, 0},
    {26146, 15858, 3538, 290, 9, 0, 0, 0, 0, 0},
    {17430, 13957, 7166, 2359, 498, 67, 6, 0, 0, 0},
    {13074, 11536, 7929, 4244, 1769, 574, 145, 29, 4, 1},
    {8728, 8256, 6989, 5294, 3588, 2176, 1181, 574, 249, 97},
};

/// The change of edges that is natural for the exemplar.
inline constexpr double edge_natural = 0.073734549272;

/// Lost and added edges of another picture by the same law; of it by these blurs; of blocks of 12, 48 and 96
/// pixels; and of three pictures that are added with weights of 85 and 148 in 256.
inline constexpr double edge_changes[14][2] = {
    {0.0350957792966, 5.48140290504e-05},
    {0.0546540634742, 0},
    {0.25117672383, 0},
    {0.540144499615, 0},
    {0.818469039728, 0},
    {0.933600454394, 0},
    {1.01790392016, 0},
    {1.05047535082, 0},
    {1.06169571076, 0},
    {0, 0.298840865999},
    {0, 0.0274135400048},
    {0, 0.0229863935919},
    {0.801272252299, 0},
    {0.353398923314, 0.420627197782},
};

}
