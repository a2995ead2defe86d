// What each type of handle stands for. Values never change once they are made, but for
// ChangingValue.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <shared_mutex>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/tetloft.h>
#include <tetloft/check.hpp>
#include <tetloft/correspondence.hpp>
#include <tetloft/delaunay.hpp>
#include <tetloft/delaunay_triangulation2.hpp>
#include <tetloft/delaunay_triangulation3.hpp>
#include <tetloft/links.hpp>
#include <tetloft/model.hpp>
#include <tetloft/periodic.hpp>
#include <tetloft/point.hpp>
#include <tetloft/report.hpp>
#include <tetloft/section_stack.hpp>
#include <tetloft/tet_mesh.hpp>

#include "c/registry.hpp"

namespace tetloft::internal::c {

/// Each in one line.
struct WarningsValue {
  std::vector<std::string> lines;
};

struct ModelValue {
  Model model;
  std::optional<ReconstructReport> report;  ///< of a model that was reconstructed
};

struct LinksValue {
  std::vector<tetloft_link> regions;
  std::vector<tetloft_link> voids;
  ContourPartition partition;
  std::size_t components = 0;
  std::size_t cavities = 0;
};

struct SurfaceValue {
  Surface surface;
  SurfaceComponents components;
};

struct VerdictValue {
  CheckReport report;
  std::vector<std::int64_t> genus;
};

struct TriangulationValue {
  Triangulation2 triangulation;
  std::vector<std::uint8_t> internal;              ///< of a section
  std::vector<std::vector<PlaneVertexId>> chains;  ///< of segments
};

/// A triangulation that changes, for several threads: those who ask share it, those who change it
/// are alone. Who comes waits at the door until the one before him is in, so that one who changes
/// it is not kept waiting by ever more who ask.
template <class Of>
class ChangingValue {
 public:
  using Triangulation = Of;

  explicit ChangingValue(Triangulation triangulation)
      : shared_(std::make_unique<Shared>(std::move(triangulation))) {}

  template <class Ask>
  auto ask(Ask&& ask) const {
    std::unique_lock door(shared_->door);
    const std::shared_lock lock(shared_->mutex);
    door.unlock();
    return ask(std::as_const(shared_->triangulation));
  }
  template <class Change>
  auto change(Change&& change) const {
    std::unique_lock door(shared_->door);
    const std::unique_lock lock(shared_->mutex);
    door.unlock();
    return change(shared_->triangulation);
  }

 private:
  struct Shared {
    explicit Shared(Triangulation of) : triangulation(std::move(of)) {}
    std::mutex door;
    std::shared_mutex mutex;
    Triangulation triangulation;
  };
  std::unique_ptr<Shared> shared_;
};

/// Cells one after the other. What begins at begin[i] ends at begin[i + 1]: these arrays have one
/// element more than what they divide.
struct CellsValue {
  std::vector<std::uint64_t> sites;
  std::vector<std::uint8_t> bounded;
  std::vector<double> volumes;
  std::vector<std::size_t> corner_begin{0};  ///< of cells, in corners
  std::vector<Point3> corners;
  std::vector<std::size_t> face_begin{0};  ///< of cells, in the arrays of faces:
  std::vector<std::uint64_t> neighbours;
  std::vector<std::uint8_t> sides;
  std::vector<std::uint8_t> faces_bounded;
  std::vector<double> areas;
  std::vector<std::size_t> face_corner_begin{0};  ///< of faces, in face_corners
  std::vector<std::uint32_t> face_corners;        ///< places in corners
  std::vector<LatticeShift> shifts;               ///< of faces of periodic sets
  std::vector<Point3> normals;                    ///< likewise
};

/// The same in the plane.
struct PlaneCellsValue {
  std::vector<std::uint64_t> sites;
  std::vector<std::uint8_t> bounded;
  std::vector<double> areas;
  std::vector<std::size_t> corner_begin{0};
  std::vector<Point2> corners;
  std::vector<std::size_t> edge_begin{0};
  std::vector<std::uint64_t> neighbours;
  std::vector<std::uint8_t> sides;
  std::vector<std::uint8_t> inside;
  std::vector<std::array<std::uint32_t, 2>> ends;  ///< places in corners, or TETLOFT_NO_ID
  std::vector<double> lengths;
};

/// Of points one after the other.
struct NaturalNeighboursValue {
  std::vector<std::size_t> begin;
  std::vector<std::uint64_t> vertices;
  std::vector<double> weights;
};

struct PeriodicTetsValue {
  std::vector<std::array<std::uint32_t, 4>> points;
  std::vector<std::array<LatticeShift, 4>> shifts;
};

/// The value and the type behind a handle of C.
template <class Handle>
struct HandleTraits;

template <class V, HandleType type>
struct HandleTraitsOf {
  using Value = V;
  static constexpr HandleType kType = type;
};

template <>
struct HandleTraits<tetloft_warnings> : HandleTraitsOf<WarningsValue, HandleType::warnings> {};
template <>
struct HandleTraits<tetloft_stop> : HandleTraitsOf<std::stop_source, HandleType::stop> {};
template <>
struct HandleTraits<tetloft_bytes> : HandleTraitsOf<std::string, HandleType::bytes> {};
template <>
struct HandleTraits<tetloft_stack> : HandleTraitsOf<SectionStack, HandleType::stack> {};
template <>
struct HandleTraits<tetloft_labels> : HandleTraitsOf<Labels, HandleType::labels> {};
template <>
struct HandleTraits<tetloft_links> : HandleTraitsOf<LinksValue, HandleType::links> {};
template <>
struct HandleTraits<tetloft_model> : HandleTraitsOf<ModelValue, HandleType::model> {};
template <>
struct HandleTraits<tetloft_surface> : HandleTraitsOf<SurfaceValue, HandleType::surface> {};
template <>
struct HandleTraits<tetloft_verdict> : HandleTraitsOf<VerdictValue, HandleType::verdict> {};
template <>
struct HandleTraits<tetloft_mesh> : HandleTraitsOf<TetMesh, HandleType::mesh> {};
template <>
struct HandleTraits<tetloft_triangulation>
    : HandleTraitsOf<TriangulationValue, HandleType::triangulation> {};
template <>
struct HandleTraits<tetloft_points> : HandleTraitsOf<std::vector<Point3>, HandleType::points> {};
template <>
struct HandleTraits<tetloft_delaunay>
    : HandleTraitsOf<ChangingValue<DelaunayTriangulation3>, HandleType::delaunay> {};
template <>
struct HandleTraits<tetloft_delaunay_plane>
    : HandleTraitsOf<ChangingValue<DelaunayTriangulation2>, HandleType::delaunay_plane> {};
template <>
struct HandleTraits<tetloft_cells> : HandleTraitsOf<CellsValue, HandleType::cells> {};
template <>
struct HandleTraits<tetloft_plane_cells>
    : HandleTraitsOf<PlaneCellsValue, HandleType::plane_cells> {};
template <>
struct HandleTraits<tetloft_natural_neighbours>
    : HandleTraitsOf<NaturalNeighboursValue, HandleType::natural_neighbours> {};
template <>
struct HandleTraits<tetloft_periodic_tets>
    : HandleTraitsOf<PeriodicTetsValue, HandleType::periodic_tets> {};

}  // namespace tetloft::internal::c
