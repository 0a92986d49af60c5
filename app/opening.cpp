#include "app/opening.hpp"

namespace poissonlab {

const char* const opening_words =
    R"(poissonlab makes Poisson disk point sets and tiles, measures them, and writes reports.

  run configs/quick.toml                       make point sets, measure them, write a report: out/quick/index.html
  analyze points.csv --gallery                 measure your own points, beside every method of the laboratory
  report out/quick out/mine --out both         one report over several results
  diff before after                            which numbers changed beyond their error
  tiles build corner --colors 4 --points 64 --border chain --ranked --out endless.ptiles
                                               points without end, at the cost of a look-up
  tiles page endless.ptiles --out page.html    see them, paint densities, in a browser
  distribute stipple --image photo.jpg --points 40000 --out dots.svg
                                               a picture in dots
  texture build corner --colors 3 --exemplar photo.jpg --size 64 --out tiles
                                               an endless texture from a photograph
  export out/quick --out for-the-paper         plots for LaTeX, points for other programs
  samplers                                     every method of making points, and its parameters

`poissonlab help` lists all commands, `poissonlab help COMMAND` explains one.
)";

}
