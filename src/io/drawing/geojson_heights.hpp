// Which property of a GeoJSON file is the height of its lines.
//
// 1. The one that is asked for. 2. A pair "X_MIN", "X_MAX" of an elevation (or nothing else) whose
// ranges hold for all lines, or a name that means elevation; then one that means a level of any
// kind. Several that agree on all lines are one. 3. Third coordinates that are constant along each
// line and differ between lines. 4. The only other property that varies: names that number, style
// or measure things are none. 5. Third coordinates that are all the same. Whether a name means
// something does not depend on its case. Else the heights are not told.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <tetloft/result.hpp>

#include "io/drawing/geojson_scan.hpp"

namespace tetloft::internal::io {

struct GeoHeights {
  std::string source;  ///< "the property 'ELEV'", for messages
  bool bands = false;  ///< lines bound regions between two heights, of which this is the lower
  std::vector<std::optional<double>> of;  ///< by line
};

/// `asked` names a property, or is empty. Error usage: `asked` is none, or several come into
/// question, which are listed; invalid_input: nothing does.
[[nodiscard]] Result<GeoHeights> find_heights(const GeoContents& contents,
                                              const std::string& asked);

}  // namespace tetloft::internal::io
