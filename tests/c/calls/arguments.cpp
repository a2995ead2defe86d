#include "c/calls/arguments.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <new>

#include "c/calls/samples.hpp"

namespace tetloft::c_test {

namespace {

constexpr unsigned char kJunk = 0xA5;

template <class Handle>
void* handle_or_null(tetloft_status status, Handle*& handle) {
  return status == TETLOFT_OK ? handle : nullptr;
}

// The stack, and what is made of it by `call`.
template <class Handle, class Call>
void* made_of_stack(Call&& call) {
  auto* const stack = static_cast<tetloft_stack*>(new_handle(Kind::stack));
  Handle* made = nullptr;
  const tetloft_status status = call(stack, &made);
  free_handle(Kind::stack, stack);
  return handle_or_null(status, made);
}

template <class Handle, class Call>
void* made_of_model(Call&& call) {
  auto* const model = static_cast<tetloft_model*>(new_handle(Kind::model));
  Handle* made = nullptr;
  const tetloft_status status = call(model, &made);
  free_handle(Kind::model, model);
  return handle_or_null(status, made);
}

void* new_verdict() {
  return made_of_stack<tetloft_verdict>([](tetloft_stack* stack, tetloft_verdict** made) {
    auto* const model = static_cast<tetloft_model*>(new_handle(Kind::model));
    // Two tets in a room of their own are not the solid of the stack: there are failures.
    const tetloft_status status = tetloft_check(model, stack, nullptr, made);
    free_handle(Kind::model, model);
    return status;
  });
}

void* new_warnings() {
  tetloft_stack* stack = nullptr;
  tetloft_warnings* warnings = nullptr;
  tetloft_stack_parse(kMendedText.data(), kMendedText.size(), "mended.cnt", nullptr, &stack,
                      &warnings);
  tetloft_stack_free(stack);
  return warnings;
}

// With constraints 0 to 3 along the sides.
void* new_plane() {
  tetloft_delaunay_plane* made = nullptr;
  tetloft_status status =
      tetloft_delaunay_plane_create(kPlanePoints.data(), kPlanePoints.size() / 2, nullptr, &made);
  if (status == TETLOFT_OK) {
    status = tetloft_delaunay_plane_insert_constraints(made, kOutline.data(), kOutline.size() / 2,
                                                       TETLOFT_CROSSING_REFUSE, nullptr);
  }
  if (status == TETLOFT_OK) return made;
  tetloft_delaunay_plane_free(made);
  return nullptr;
}

void* new_plane_cells() {
  tetloft_delaunay_plane* plane = nullptr;
  tetloft_plane_cells* made = nullptr;
  tetloft_status status =
      tetloft_delaunay_plane_create(kPlanePoints.data(), kPlanePoints.size() / 2, nullptr, &plane);
  if (status == TETLOFT_OK) status = tetloft_delaunay_plane_cells(plane, nullptr, nullptr, &made);
  tetloft_delaunay_plane_free(plane);
  return handle_or_null(status, made);
}

void* new_natural_neighbours() {
  auto* const delaunay = static_cast<tetloft_delaunay*>(new_handle(Kind::delaunay));
  tetloft_natural_neighbours* made = nullptr;
  const tetloft_status status = tetloft_delaunay_natural_neighbours_all(
      delaunay, kInnerPoint.data(), 1, TETLOFT_SIBSON, nullptr, &made);
  free_handle(Kind::delaunay, delaunay);
  return handle_or_null(status, made);
}

}  // namespace

tetloft_status free_handle(Kind kind, void* handle) {
  switch (kind) {
    case Kind::warnings: return tetloft_warnings_free(static_cast<tetloft_warnings*>(handle));
    case Kind::stop: return tetloft_stop_free(static_cast<tetloft_stop*>(handle));
    case Kind::bytes: return tetloft_bytes_free(static_cast<tetloft_bytes*>(handle));
    case Kind::stack: return tetloft_stack_free(static_cast<tetloft_stack*>(handle));
    case Kind::labels: return tetloft_labels_free(static_cast<tetloft_labels*>(handle));
    case Kind::links: return tetloft_links_free(static_cast<tetloft_links*>(handle));
    case Kind::model: return tetloft_model_free(static_cast<tetloft_model*>(handle));
    case Kind::surface: return tetloft_surface_free(static_cast<tetloft_surface*>(handle));
    case Kind::verdict: return tetloft_verdict_free(static_cast<tetloft_verdict*>(handle));
    case Kind::mesh: return tetloft_mesh_free(static_cast<tetloft_mesh*>(handle));
    case Kind::triangulation:
      return tetloft_triangulation_free(static_cast<tetloft_triangulation*>(handle));
    case Kind::points: return tetloft_points_free(static_cast<tetloft_points*>(handle));
    case Kind::delaunay: return tetloft_delaunay_free(static_cast<tetloft_delaunay*>(handle));
    case Kind::delaunay_plane:
      return tetloft_delaunay_plane_free(static_cast<tetloft_delaunay_plane*>(handle));
    case Kind::cells: return tetloft_cells_free(static_cast<tetloft_cells*>(handle));
    case Kind::plane_cells:
      return tetloft_plane_cells_free(static_cast<tetloft_plane_cells*>(handle));
    case Kind::natural_neighbours:
      return tetloft_natural_neighbours_free(static_cast<tetloft_natural_neighbours*>(handle));
    case Kind::periodic_tets:
      return tetloft_periodic_tets_free(static_cast<tetloft_periodic_tets*>(handle));
  }
  return TETLOFT_USAGE;
}

void* new_handle(Kind kind) {
  switch (kind) {
    case Kind::warnings: return new_warnings();
    case Kind::stop: {
      tetloft_stop* made = nullptr;
      return handle_or_null(tetloft_stop_create(&made), made);
    }
    case Kind::bytes:
      return made_of_stack<tetloft_bytes>([](tetloft_stack* stack, tetloft_bytes** made) {
        tetloft_write_options options;
        tetloft_write_options_defaults(&options);
        options.format = "cnt";
        return tetloft_stack_format(stack, &options, made, nullptr);
      });
    case Kind::stack: {
      tetloft_stack* made = nullptr;
      return handle_or_null(tetloft_stack_parse(kStackText.data(), kStackText.size(), "stack.cnt",
                                                nullptr, &made, nullptr),
                            made);
    }
    case Kind::labels: {
      tetloft_labels* made = nullptr;
      return handle_or_null(
          tetloft_labels_parse(kLabelText.data(), kLabelText.size(), "stack.labels", &made), made);
    }
    case Kind::links:
      return made_of_stack<tetloft_links>([](tetloft_stack* stack, tetloft_links** made) {
        return tetloft_links_find(stack, nullptr, nullptr, made, nullptr);
      });
    case Kind::model: {
      tetloft_model* made = nullptr;
      return handle_or_null(tetloft_model_parse(kModelText.data(), kModelText.size(), "two.vtu",
                                                nullptr, &made, nullptr),
                            made);
    }
    case Kind::surface: return made_of_model<tetloft_surface>(tetloft_model_boundary);
    case Kind::verdict: return new_verdict();
    case Kind::mesh: return made_of_model<tetloft_mesh>(tetloft_model_mesh);
    case Kind::triangulation: {
      tetloft_triangulation* made = nullptr;
      return handle_or_null(
          tetloft_conforming_delaunay2(kPlanePoints.data(), kPlanePoints.size() / 2,
                                       kSegments.data(), kSegments.size() / 2, nullptr, &made),
          made);
    }
    case Kind::points: {
      tetloft_points* made = nullptr;
      return handle_or_null(tetloft_points_parse(kPointText.data(), kPointText.size(), "points.xyz",
                                                 nullptr, &made, nullptr),
                            made);
    }
    case Kind::delaunay: {
      tetloft_delaunay* made = nullptr;
      return handle_or_null(
          tetloft_delaunay_create(kTetPoints.data(), kTetPoints.size() / 3, nullptr, &made), made);
    }
    case Kind::delaunay_plane: return new_plane();
    case Kind::cells: {
      tetloft_cells* made = nullptr;
      return handle_or_null(
          tetloft_periodic_voronoi(kTetPoints.data(), 2, kBoxVectors.data(), nullptr, &made), made);
    }
    case Kind::plane_cells: return new_plane_cells();
    case Kind::natural_neighbours: return new_natural_neighbours();
    case Kind::periodic_tets: {
      tetloft_periodic_tets* made = nullptr;
      return handle_or_null(
          tetloft_periodic_delaunay(kTetPoints.data(), 2, kBoxVectors.data(), nullptr, &made),
          made);
    }
  }
  return nullptr;
}

Arguments::~Arguments() {
  for (const HandleOutput& output : handle_outputs_) free_handle(output.kind, output.handle);
  for (const HandleOutput& changed : changed_) free_handle(changed.kind, changed.handle);
}

Arguments::Slot& Arguments::new_slot(std::size_t size, unsigned char fill) {
  Slot& slot = outputs_.emplace_back();
  slot.size = size;
  slot.bytes.fill(fill);
  return slot;
}

void* Arguments::choose_handle(Kind kind, Expected null) {
  constexpr Expected bad = Expected::bad_handle;
  const std::size_t variant = choose({Expected::ok, null, bad, bad, bad, bad, bad, bad});
  if (variant == 0) return right_handle(kind);
  return variant == 1 ? nullptr : wrong_handle(kind, variant - 2);
}

void* Arguments::choose_own(Kind kind) {
  constexpr Expected bad = Expected::bad_handle;
  const std::size_t variant = choose({Expected::ok, Expected::ok, bad, bad, bad, bad, bad, bad});
  if (variant == 0) {
    void* const made = new_handle(kind);
    if (made == nullptr) throw std::bad_alloc();
    return made;
  }
  return variant == 1 ? nullptr : wrong_handle(kind, variant - 2);
}

void* Arguments::choose_changing(Kind kind) {
  constexpr Expected bad = Expected::bad_handle;
  const std::size_t variant = choose({Expected::ok, bad, bad, bad, bad, bad, bad, bad});
  if (variant > 0) return variant == 1 ? nullptr : wrong_handle(kind, variant - 2);
  HandleOutput& changed = changed_.emplace_back(HandleOutput{kind, nullptr});
  changed.handle = new_handle(kind);
  if (changed.handle == nullptr) throw std::bad_alloc();
  return changed.handle;
}

void* Arguments::choose_handle_output(Kind kind, Expected null) {
  if (choose({Expected::ok, null}) != 0) return nullptr;
  HandleOutput& output = handle_outputs_.emplace_back();
  output.kind = kind;
  std::memset(&output.handle, kJunk, sizeof output.handle);
  return &output.handle;
}

void* Arguments::choose_output(std::size_t size, Expected null) {
  if (choose({Expected::ok, null}) != 0) return nullptr;
  return new_slot(size, kJunk).bytes.data();
}

void* Arguments::choose_result(std::size_t size, std::uint32_t version) {
  constexpr Expected wrong = Expected::usage;
  const std::size_t variant = choose({Expected::ok, wrong, wrong, wrong, wrong});
  if (variant == 1) return nullptr;
  Slot& slot = structs_.emplace_back();
  slot.size = size;
  slot.bytes.fill(kJunk);
  const std::uint32_t versions[] = {version, 0, 0, version + 1, 0xA5A5A5A5U};
  std::memcpy(slot.bytes.data(), &versions[variant], sizeof version);
  return slot.bytes.data();
}

const void* Arguments::choose_options(const void* usual, std::size_t size, std::uint32_t version,
                                      Expected null) {
  constexpr Expected wrong = Expected::usage;
  const std::size_t variant = choose({Expected::ok, null, wrong, wrong, wrong});
  if (variant == 1) return nullptr;
  Slot& slot = structs_.emplace_back();
  slot.size = size;
  std::memcpy(slot.bytes.data(), usual, size);
  const std::uint32_t versions[] = {version, 0, 0, version + 1, 0xA5A5A5A5U};
  std::memcpy(slot.bytes.data(), &versions[variant], sizeof version);
  return slot.bytes.data();
}

Arguments::Array<const void> Arguments::choose_array(const void* usual, std::size_t bytes,
                                                     std::size_t tuple) {
  const Expected null = bytes == 0 ? Expected::ok : Expected::usage;
  constexpr Expected refused = Expected::refused;
  const std::size_t variant = choose({Expected::ok, null, refused, refused});
  const std::size_t count = bytes / tuple;
  if (variant == 1) return {nullptr, count};
  std::vector<unsigned char>& copy = arrays_.emplace_back(bytes);
  if (bytes > 0) std::memcpy(copy.data(), usual, bytes);
  constexpr std::size_t kMost = std::numeric_limits<std::size_t>::max();
  // The last one times the size of an element is a small number, if nobody looks at overflow.
  const std::size_t counts[] = {count, 0, kMost, kMost / tuple + 2};
  return {copy.data(), counts[variant]};
}

const double* Arguments::numbers(const std::vector<double>& usual, Expected null) {
  if (choose({Expected::ok, null}) != 0) return nullptr;
  std::vector<double> given = reals(usual);
  given.resize(usual.size());
  return numbers_.emplace_back(std::move(given)).data();
}

Arguments::Array<void> Arguments::choose_output_array(std::size_t tuple, Expected null) {
  const std::size_t variant = choose({Expected::ok, Expected::ok, null, Expected::too_small});
  if (variant == 1) return {nullptr, 0};
  if (variant == 2) return {nullptr, kMostElements};
  if (variant == 3) return {arrays_.emplace_back(1).data(), 0};
  return {arrays_.emplace_back(kMostElements * tuple).data(), kMostElements};
}

const char* Arguments::text(const char* usual) {
  return choose({Expected::ok, Expected::usage}) == 0 ? usual : nullptr;
}

const char* Arguments::file(const char* name) {
  return text(paths_.emplace_back(folder_ + '/' + name).c_str());
}

const char* Arguments::optional_text(const char* usual) {
  return choose({Expected::ok, Expected::ok}) == 0 ? usual : nullptr;
}

bool Arguments::outputs_are_clear() const {
  for (const Slot& slot : outputs_) {
    const auto end = slot.bytes.begin() + static_cast<std::ptrdiff_t>(slot.size);
    if (std::any_of(slot.bytes.begin(), end, [](unsigned char b) { return b != 0; })) return false;
  }
  return std::all_of(handle_outputs_.begin(), handle_outputs_.end(),
                     [](const HandleOutput& output) { return output.handle == nullptr; });
}

}  // namespace tetloft::c_test
