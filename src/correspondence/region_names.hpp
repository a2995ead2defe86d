// What errors call regions; and voids, which the same rules are asked about.
#pragma once

#include <string>

#include <tetloft/nesting.hpp>
#include <tetloft/result.hpp>

#include "sections/complement.hpp"

namespace tetloft::internal {

class RegionNames {
 public:
  /// Must outlive this. `voids`: they are those of complements (sections/complement.hpp).
  explicit RegionNames(const IdVector<SectionId, Nesting>& nestings, bool voids = false)
      : nestings_(nestings), voids_(voids) {}

  [[nodiscard]] const char* many() const { return voids_ ? "voids" : "regions"; }
  [[nodiscard]] std::string of(SectionId s, RegionId r) const {
    if (is_exterior(r)) return "the outside";
    return "contour " + std::to_string(nestings_[s].outer[r].index());
  }
  [[nodiscard]] Place place(SectionId s, RegionId r) const {
    Place place;
    place.section = s.index();
    if (!is_exterior(r)) place.contour = nestings_[s].outer[r].index();
    return place;
  }

 private:
  [[nodiscard]] bool is_exterior(RegionId r) const { return voids_ && r == sections::kExterior; }

  const IdVector<SectionId, Nesting>& nestings_;
  bool voids_;
};

}  // namespace tetloft::internal
