// What handles name. A handle is no address: it is looked up, never followed, so one that was
// freed, is of another type or is made up can be told from one that is good.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <shared_mutex>

namespace tetloft::internal::c {

enum class HandleType : std::uint8_t {
  warnings,
  stop,
  bytes,
  stack,
  labels,
  links,
  model,
  surface,
  verdict,
  mesh,
  triangulation,
  points,
  delaunay,
  delaunay_plane,
  cells,
  plane_cells,
  natural_neighbours,
  periodic_tets,
};
/// "stack", with its article: "a stack".
[[nodiscard]] const char* name_of(HandleType type);

using HandleName = std::uintptr_t;

/// What a name stands for; `value` is null where it stands for nothing.
struct Named {
  HandleType type = HandleType::warnings;
  std::shared_ptr<const void> value;
};

/// Safe to use from several threads at once.
class Registry {
 public:
  /// Where so many names were given already.
  explicit Registry(HandleName last_serial = 0) : last_serial_(last_serial) {}

  /// The one of the process. It is never destroyed: handles may be freed by what ends later.
  static Registry& of_process();

  /// A new name, never 0, and none that there was before. Throws std::bad_alloc where memory or
  /// names end.
  [[nodiscard]] HandleName add(Named named);
  [[nodiscard]] Named find(HandleName name) const;
  /// Takes the name away; what it stood for lives on in the result alone.
  Named remove(HandleName name) noexcept;

 private:
  mutable std::shared_mutex mutex_;
  std::map<HandleName, Named> named_;
  HandleName last_serial_;
};

}  // namespace tetloft::internal::c
