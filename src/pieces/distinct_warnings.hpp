// What building slabs warns of, each once: windows share sections, and slabs may be built again.
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/result.hpp>

namespace tetloft::internal::pieces {

class DistinctWarnings {
 public:
  void add(std::vector<Warning> more) {
    for (Warning& warning : more) {
      if (known_.insert(to_string(warning)).second) all_.push_back(std::move(warning));
    }
  }
  /// In the order in which they came.
  [[nodiscard]] const std::vector<Warning>& all() const { return all_; }

 private:
  std::set<std::string> known_;
  std::vector<Warning> all_;
};

}  // namespace tetloft::internal::pieces
