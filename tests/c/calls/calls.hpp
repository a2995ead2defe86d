// Every function of tetloft.h, with arguments that are right unless the one who hands them out has
// others: one table for tests of wrong arguments, of memory that ends, of threads, and to fuzz.
#pragma once

#include <span>
#include <vector>

#include <tetloft/tetloft.h>

#include "c/calls/arguments.hpp"

namespace tetloft::c_test {

struct Call {
  const char* function;
  /// Asks for the same arguments in the same order each time.
  tetloft_status (*call)(Arguments&);
};

[[nodiscard]] std::span<const Call> calls_of_values();    // names, options, warnings, bytes, stops
[[nodiscard]] std::span<const Call> calls_of_stacks();    // with labels and links
[[nodiscard]] std::span<const Call> calls_of_models();    // with reconstruction, surfaces, pictures
[[nodiscard]] std::span<const Call> calls_of_meshes();    // with verdicts, triangulations, points
[[nodiscard]] std::span<const Call> calls_of_delaunay();  // triangulations that change
[[nodiscard]] std::span<const Call> calls_of_planes();    // the same in the plane
[[nodiscard]] std::span<const Call> calls_of_cells();     // with natural neighbours, periodic sets
[[nodiscard]] std::span<const Call> calls_of_plane_cells();

/// All of them, by name.
[[nodiscard]] std::vector<Call> all_calls();

// Structs with the numbers that `arguments` has for their fields.
[[nodiscard]] const tetloft_execution* execution(Arguments& arguments);
[[nodiscard]] const tetloft_read_options* read_options(Arguments& arguments);
/// In a format by name; `null`: what no options must come to.
[[nodiscard]] const tetloft_write_options* write_options(Arguments& arguments, const char* format,
                                                         Expected null);
[[nodiscard]] const tetloft_correspondence* correspondence(Arguments& arguments);

/// A status for functions that return a text.
[[nodiscard]] inline tetloft_status told(const char* text) {
  return text != nullptr ? TETLOFT_OK : TETLOFT_INTERNAL;
}

/// An array of what a handle names.
template <class Handle, class T, class Get>
tetloft_status get_array(Arguments& a, Get get) {
  auto* const handle = a.handle<Handle>();
  auto* const array = a.output<const T*>();
  return get(handle, array, a.output<std::size_t>());
}

/// Of a stack or a model.
template <class Handle>
tetloft_status description(Arguments& a, tetloft_status (*get)(const Handle*, const char**,
                                                               const char**, const char**)) {
  auto* const handle = a.handle<Handle>();
  const char** const name = a.optional_output<const char*>();
  const char** const unit = a.optional_output<const char*>();
  return get(handle, name, unit, a.optional_output<const char*>());
}

}  // namespace tetloft::c_test
