// Arguments for the functions of tetloft.h, of which any may be wrong: who derives from this
// chooses which, and how. See calls.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <initializer_list>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <tetloft/tetloft.h>

namespace tetloft::c_test {

/// What a call with one wrong argument must come to.
enum class Expected {
  ok,
  usage,
  bad_handle,
  too_small,
  refused,  ///< usage or invalid_input
};

enum class Kind {
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
inline constexpr int kKinds = 18;

template <class Handle>
struct KindOf;
#define TETLOFT_KIND(NAME)                    \
  template <>                                 \
  struct KindOf<tetloft_##NAME> {             \
    static constexpr Kind value = Kind::NAME; \
  };
TETLOFT_KIND(warnings)
TETLOFT_KIND(stop)
TETLOFT_KIND(bytes)
TETLOFT_KIND(stack)
TETLOFT_KIND(labels)
TETLOFT_KIND(links)
TETLOFT_KIND(model)
TETLOFT_KIND(surface)
TETLOFT_KIND(verdict)
TETLOFT_KIND(mesh)
TETLOFT_KIND(triangulation)
TETLOFT_KIND(points)
TETLOFT_KIND(delaunay)
TETLOFT_KIND(delaunay_plane)
TETLOFT_KIND(cells)
TETLOFT_KIND(plane_cells)
TETLOFT_KIND(natural_neighbours)
TETLOFT_KIND(periodic_tets)
#undef TETLOFT_KIND

/// The _free function of a kind.
tetloft_status free_handle(Kind kind, void* handle);
/// A new handle; null where memory ends.
void* new_handle(Kind kind);

class Arguments {
 public:
  /// Files are in `folder`.
  explicit Arguments(std::string folder) : folder_(std::move(folder)) {}
  /// Frees the handles that calls made.
  virtual ~Arguments();
  Arguments(const Arguments&) = delete;
  Arguments& operator=(const Arguments&) = delete;

  template <class Handle>
  Handle* handle() {
    return static_cast<Handle*>(choose_handle(KindOf<Handle>::value, Expected::bad_handle));
  }
  /// NULL is right, too.
  template <class Handle>
  Handle* optional_handle() {
    return static_cast<Handle*>(choose_handle(KindOf<Handle>::value, Expected::ok));
  }
  /// For a call that frees it.
  template <class Handle>
  Handle* own_handle() {
    return static_cast<Handle*>(choose_own(KindOf<Handle>::value));
  }
  /// For a call that changes what it names: made for it alone, and freed with the arguments.
  template <class Handle>
  Handle* changing_handle() {
    return static_cast<Handle*>(choose_changing(KindOf<Handle>::value));
  }

  template <class Handle>
  Handle** handle_output() {
    return static_cast<Handle**>(choose_handle_output(KindOf<Handle>::value, Expected::usage));
  }
  template <class Handle>
  Handle** optional_handle_output() {
    return static_cast<Handle**>(choose_handle_output(KindOf<Handle>::value, Expected::ok));
  }
  template <class T>
  T* output() {
    return static_cast<T*>(choose_output(sizeof(T), Expected::usage));
  }
  template <class T>
  T* optional_output() {
    return static_cast<T*>(choose_output(sizeof(T), Expected::ok));
  }
  /// A struct for results.
  template <class Struct>
  Struct* result(std::uint32_t version) {
    static_assert(offsetof(Struct, version) == 0 && sizeof(Struct) <= kMostBytes);
    return static_cast<Struct*>(choose_result(sizeof(Struct), version));
  }
  /// Options, which are copied. `null`: what NULL must come to.
  template <class Struct>
  const Struct* options(const Struct& usual, Expected null = Expected::ok) {
    static_assert(offsetof(Struct, version) == 0 && sizeof(Struct) <= kMostBytes);
    static_assert(std::is_trivially_copyable_v<Struct>);
    return static_cast<const Struct*>(choose_options(&usual, sizeof(Struct), usual.version, null));
  }

  template <class T>
  struct Array {
    T* data = nullptr;
    std::size_t size = 0;
  };
  /// For reading: `tuple` numbers in each element.
  template <class T>
  Array<const T> array(const std::vector<T>& usual, std::size_t tuple = 1) {
    const auto chosen = choose_array(usual.data(), usual.size() * sizeof(T), tuple * sizeof(T));
    return {static_cast<const T*>(chosen.data), chosen.size};
  }
  /// So many numbers as usual, without their count. `null`: what NULL must come to.
  const double* numbers(const std::vector<double>& usual, Expected null = Expected::usage);
  /// For writing: of a result that is not empty and takes no more than kMostElements. `null`: what
  /// NULL with a capacity must come to.
  template <class T>
  Array<T> output_array(std::size_t tuple = 1, Expected null = Expected::usage) {
    const auto chosen = choose_output_array(tuple * sizeof(T), null);
    return {static_cast<T*>(chosen.data), chosen.size};
  }
  static constexpr std::size_t kMostElements = 4096;

  const char* text(const char* usual);
  /// The path of a file of the folder.
  const char* file(const char* name);
  /// NULL is right, too.
  const char* optional_text(const char* usual);

  // Numbers: the usual one unless a derived class has others.
  virtual std::int64_t integer(std::int64_t usual) { return usual; }
  virtual double real(double usual) { return usual; }
  virtual std::vector<double> reals(std::vector<double> usual) { return usual; }
  virtual std::vector<std::uint32_t> ids(std::vector<std::uint32_t> usual) { return usual; }

  /// Are all outputs, but arrays, 0? They hold something else before the call.
  [[nodiscard]] bool outputs_are_clear() const;

 protected:
  /// Which variant of an argument: 0 the right one, i the one that must come to expected[i].
  virtual std::size_t choose(std::initializer_list<Expected> expected) = 0;
  /// A handle that is right.
  virtual void* right_handle(Kind kind) = 0;
  /// One that names nothing any more, or never did.
  virtual void* wrong_handle(Kind kind, std::size_t which) = 0;
  static constexpr std::size_t kWrongHandles = 6;

  struct HandleOutput {
    Kind kind;
    void* handle;
  };
  /// What calls wrote so far.
  [[nodiscard]] std::deque<HandleOutput>& handle_outputs() { return handle_outputs_; }

 private:
  static constexpr std::size_t kMostBytes = 160;
  struct Slot {
    alignas(16) std::array<unsigned char, kMostBytes> bytes;
    std::size_t size = 0;
  };
  void* choose_handle(Kind kind, Expected null);
  void* choose_own(Kind kind);
  void* choose_changing(Kind kind);
  void* choose_handle_output(Kind kind, Expected null);
  void* choose_output(std::size_t size, Expected null);
  void* choose_result(std::size_t size, std::uint32_t version);
  const void* choose_options(const void* usual, std::size_t size, std::uint32_t version,
                             Expected null);
  Array<const void> choose_array(const void* usual, std::size_t bytes, std::size_t tuple);
  Array<void> choose_output_array(std::size_t tuple, Expected null);
  Slot& new_slot(std::size_t size, unsigned char fill);

  // Deques: what is handed out stays where it is.
  std::deque<Slot> outputs_;
  std::deque<Slot> structs_;
  std::deque<HandleOutput> handle_outputs_;
  std::deque<HandleOutput> changed_;
  std::deque<std::vector<unsigned char>> arrays_;
  std::deque<std::vector<double>> numbers_;
  std::deque<std::string> paths_;
  std::string folder_;
};

}  // namespace tetloft::c_test
