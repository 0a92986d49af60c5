// A command of the program as data: its options, its help, and what it does.
//
// command_line.cpp makes a parser of it with CLI11, and argument_errors.cpp words for what that refuses. Its header
// takes five seconds to compile: no other file includes it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace poissonlab {

/// The variable that takes the value of an option. Its type decides which values are allowed: bool makes a flag, int is
/// a number of threads from 1 to 4096, and the other integers may have any value of their type.
using OptionTarget =
    std::variant<bool*, int*, double*, std::uint32_t*, std::uint64_t*, std::string*, std::filesystem::path*,
                 std::vector<std::int64_t>*, std::vector<std::string>*, std::vector<std::filesystem::path>*>;

/// Words for Option::is_required.
inline constexpr bool required = true;
inline constexpr bool optional = false;

struct Option
{
    std::string name; ///< "--out"; without dashes: an argument that has to be given, known by its place
    OptionTarget target;
    std::string help;
    std::string value_name{}; ///< what the help calls the value, "DIR"; empty: its type
    bool is_required = false;
    int most_values = 1;     ///< of a list of numbers
    std::string excludes{};  ///< the option that does not go together with this one
    std::string allowed{};   ///< "an integer from 1 to 64", for messages about others (empty texts); empty: any
    std::uint64_t least = 0; ///< that `allowed` names, of a natural number
    std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
    std::vector<std::string> words{}; ///< that shells complete; empty: names of files
    std::string alone{};              ///< the word that the option means without one; empty: it needs one
    bool may_be_left_out = false;     ///< of an argument that is known by its place
};

/// The option with the words for what its command takes, which alone refuses other values of the type.
inline Option allowing(Option option, std::string values)
{
    option.allowed = std::move(values);
    return option;
}

/// Natural numbers that an option takes.
struct Integers
{
    std::uint64_t least, most;

    std::string words() const { return "an integer from " + std::to_string(least) + " to " + std::to_string(most); }
};

/// The option that takes these numbers, and none beside them.
inline Option allowing(Option option, const Integers& integers)
{
    option.least = integers.least;
    option.most = integers.most;
    return allowing(std::move(option), integers.words());
}

/// Does the work of a command. Returns the exit status, or throws.
using Action = std::function<int()>;

struct Command
{
    std::string name;
    std::string summary;         ///< a line of the program's help
    std::vector<Option> options; ///< their targets live as long as `action`
    std::string notes;           ///< below the options in the command's help; empty: those of the program
    Action action;
    std::vector<Command> commands{}; ///< of a group, which has no action of its own
    /// The module that this program lacks and that alone knows the command, of which name and summary are all that is
    /// there; empty: it is all there.
    std::string absent_module{};
};

/// The action of a command that throws where it cannot do all of its work.
template <class Options>
Action action_on(std::shared_ptr<Options> options, void (*work)(const Options&))
{
    return [options = std::move(options), work] {
        work(*options);
        return 0;
    };
}

/// The exit status of wrong input.
inline constexpr int exit_wrong_input = 2;

/// The exit status of `diff` where something changed; other commands return 0 or throw.
inline constexpr int exit_changed = 4;

// Each function makes a command; its file is in the folder of its module. `typed` is the whole command as the user
// would type it again; results remember it.
Command run_command(const std::string& typed);
Command merge_command();
Command analyze_command(const std::string& typed);
Command report_command();
Command export_command();
Command diff_command();
Command tiling_command();
Command packing_command();
Command texture_advise_command();
Command texture_build_command();
Command texture_verify_command();
Command texture_tile_command();
Command texture_map_command();
Command texture_endless_command();
Command texture_export_command();
Command texture_cells_command();
Command texture_design_command();
Command texture_surface_command();
Command distribute_objects_command();
Command tiles_build_command();
Command tiles_points_command();
Command tiles_page_command();
Command tiles_picture_command();
Command tiles_verify_command();
Command aperiodic_sets_command();
Command aperiodic_convert_command();
Command aperiodic_verify_command();
Command points_dart_throwing_command();
Command points_gaussian_blue_noise_command();
Command points_lloyd_command();
Command distribute_warp_command();
Command distribute_rank_command();
Command distribute_classes_command();
Command distribute_surface_command();
Command distribute_surface_classes_command();
Command distribute_darts_command();
Command distribute_points_command();
Command distribute_dither_mask_command();
Command distribute_mri_mask_command();
Command distribute_stipple_command();
Command distribute_hatch_command();
Command distribute_icons_command();
Command distribute_instances_command();
Command distribute_recursive_command();
Command aperiodic_tile_command();
Command aperiodic_tables_command();
Command isohedral_list_command();
Command isohedral_draw_command();
Command devices_command();
Command samplers_command();
Command kinds_command();
Command completion_command(std::function<std::vector<Command>()> all_commands);
Command manual_command(std::function<std::vector<Command>()> all_commands);

}
