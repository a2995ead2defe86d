// The structures of a file, all of them, and names of files for what is made of each.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <tetloft/tetloft.hpp>

namespace tetloft::cli {

struct Structure {
  std::string asked;  ///< what ReadOptions::structure chooses it by
  std::string name;   ///< as the file has it; may be empty
  std::string number;
  double value = 0;  ///< the same
};

/// The ROIs, objects or labels that a solid could be made of, in the order of the file; those
/// without closed contours, and the label 0, are left out.
[[nodiscard]] std::vector<Structure> structures_of(const FileSummary& file);

/// "OUT-lung.vtu" of "OUT.vtu", for each structure: of its name what any system takes as part of a
/// file's name, else its number; no two are the same, whatever the case.
[[nodiscard]] std::vector<std::string> outputs_of(const std::string& path,
                                                  const std::vector<Structure>& structures);

}  // namespace tetloft::cli
