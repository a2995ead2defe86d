// Work over a stack's sections or slabs, in parallel, each of which may fail.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include <tetloft/result.hpp>

#include "core/guard.hpp"
#include "core/parallel.hpp"
#include "core/watched_work.hpp"

namespace tetloft::internal {

/// Runs body(id) -> std::optional<Error> for all ids, while the caller does not stop it; the error
/// of the first id that has one. Ids ascend, each once: what belongs to one is one body's alone.
template <class IdType, class Body>
std::optional<Error> first_error(const std::vector<IdType>& ids, unsigned threads,
                                 const WatchedWork& work, const Body& body) {
  TETLOFT_CHECK(std::adjacent_find(ids.begin(), ids.end(), std::greater_equal<>()) == ids.end());
  std::vector<std::optional<Error>> errors(ids.size());
  parallel_for(ids.size(), threads, [&](std::size_t i) {
    work.go_on();
    errors[i] = body(ids[i]);
  });
  for (std::optional<Error>& error : errors) {
    if (error) return std::move(error);
  }
  return std::nullopt;
}

/// All ids below n.
template <class IdType>
std::vector<IdType> all_ids(std::size_t n) {
  std::vector<IdType> ids;
  ids.reserve(n);
  for (const IdType id : IdRange<IdType>(n)) ids.push_back(id);
  return ids;
}

}  // namespace tetloft::internal
