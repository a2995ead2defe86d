// What a solid is of, in the comments of mesh files that have no other place for it: "unit: mm",
// "component 1: liver".
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <tetloft/model.hpp>

#include "io/groups.hpp"

namespace tetloft::internal::io {

/// A line for each: `mark`, and the comment. Names stand as printable() makes them.
void append_comments(std::string& text, std::string_view mark, const Model& model,
                     const std::vector<ComponentGroup>& groups);

/// Takes such comments back; others say nothing to it.
class SolidComments {
 public:
  /// A comment without its mark.
  void take(std::string_view comment);

  [[nodiscard]] const std::map<std::int64_t, std::string>& names() const { return names_; }
  [[nodiscard]] const Description& about() const { return about_; }

 private:
  std::map<std::int64_t, std::string> names_;  // by number
  Description about_;
};

}  // namespace tetloft::internal::io
