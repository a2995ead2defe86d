#include "render/subject.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

#include <tetloft/tet_mesh.hpp>

#include "core/enums.hpp"
#include "model/well_formed.hpp"
#include "render/evidence.hpp"
#include "render/normals.hpp"
#include "render/outlines.hpp"
#include "render/vector.hpp"

namespace tetloft {

using namespace internal;

const char* name_of(ColourBy colour) {
  switch (colour) {
    case ColourBy::component: return "component";
    case ColourBy::slab: return "slab";
    case ColourBy::kind: return "kind";
    case ColourBy::dihedral: return "dihedral";
    case ColourBy::evidence: return "evidence";
  }
  return "unknown";
}

}  // namespace tetloft

namespace tetloft::internal::render {

namespace {

Error invalid(std::string message) { return {ErrorCode::invalid_input, std::move(message), {}}; }

// The angles between faces i and j are π less that between their outward normals.
float smallest_dihedral(const std::array<Point3, 4>& p) {
  std::array<Point3, 4> normal;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& f = kFaceVertex[i];
    const auto at = [&](int k) { return p[static_cast<std::size_t>(k)]; };
    normal[i] = unit(cross(at(f[1]) - at(f[0]), at(f[2]) - at(f[0])), {});
  }
  double largest_cosine = -1;
  for (const auto& [i, j] : kEdgeVertex) {
    const double cosine =
        -dot(normal[static_cast<std::size_t>(i)], normal[static_cast<std::size_t>(j)]);
    largest_cosine = std::max(largest_cosine, cosine);
  }
  return static_cast<float>(std::acos(std::clamp(largest_cosine, -1.0, 1.0)) * 180 /
                            std::numbers::pi);
}

// Usage error for what is out of range.
Result<void> check_options(const RenderOptions& options) {
  const auto usage = [](const char* what) { return Error{ErrorCode::usage, what, {}}; };
  if (options.width < 1 || options.width > kLargestPictureSide || options.height < 1 ||
      options.height > kLargestPictureSide) {
    return usage("width and height of a picture are 1 to 8192 pixels");
  }
  if (!is_enumerator(options.colour, ColourBy::evidence)) {
    return usage("there is no such colouring: component, slab, kind, dihedral or evidence");
  }
  if (!std::isfinite(options.azimuth)) return usage("azimuth is not finite");
  if (!(options.elevation >= -90 && options.elevation <= 90)) {
    return usage("elevation is not between -90 and 90 degrees");
  }
  if (!(options.explode >= 0 && options.explode <= 100)) {
    return usage("slabs can be moved apart by 0 to 100 heights");
  }
  // Heights stay far within float32, and visible.
  constexpr double kLargestPictureSideStretched = 1e6;
  if (!(options.stretch <= kLargestPictureSideStretched &&
        options.stretch >= 1 / kLargestPictureSideStretched)) {
    return usage("z can be stretched by 1e-6 to 1e6");
  }
  if (options.cut && (options.cut->axis < 0 || options.cut->axis > 2)) {
    return usage("a cut is by x, y or z");
  }
  if (options.cut && !std::isfinite(options.cut->position)) {
    return usage("the position of the cut is not finite");
  }
  return {};
}

Result<void> check_model(const Model& model) {
  if (model.tets.empty()) return invalid("the model has no tets to draw");
  if (Result<void> formed = check_well_formed(model); !formed) return formed;
  for (const Point3& p : model.points) {
    if (!(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z))) {
      return invalid("the model has a coordinate that is not finite");
    }
  }
  return {};
}

Result<void> check_contours(const SectionStack& stack) {
  for (std::size_t s = 0; s < stack.sections.size(); ++s) {
    const Section& section = stack.sections[SectionId(s)];
    bool fine = std::isfinite(section.z);
    for (const Contour& contour : section.contours) {
      for (const Point2& p : contour.vertices)
        fine = fine && std::isfinite(p.x) && std::isfinite(p.y);
    }
    if (fine) continue;
    Error error = invalid("the contours have a coordinate that is not finite");
    error.where.section = s;
    return error;
  }
  return {};
}

// The least exponent e for which all coordinates are below 2^e.
int exponent_of(const Model& model, const SectionStack* contours) {
  double largest = 0;
  const auto include = [&](double value) { largest = std::max(largest, std::abs(value)); };
  for (const Point3& p : model.points) {
    include(p.x);
    include(p.y);
    include(p.z);
  }
  if (contours != nullptr) {
    for (const Section& section : contours->sections) {
      include(section.z);
      for (const Contour& contour : section.contours) {
        for (const Point2& p : contour.vertices) {
          include(p.x);
          include(p.y);
        }
      }
    }
  }
  int exponent = 0;
  std::frexp(std::isfinite(largest) ? largest : 0.0, &exponent);
  return exponent;
}

// Order of the tets by slab, slabs renumbered from 0 without gaps.
void sort_by_slab(const Model& model, Subject& subject) {
  const std::size_t n = model.tets.size();
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto slab = [&](std::size_t t) {
    return model.slab.empty() ? 0U : model.slab.raw()[t].value();
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return slab(a) < slab(b); });
  subject.tets.reserve(n);
  subject.slab.reserve(n);
  for (const std::size_t t : order) {
    subject.tets.push_back(model.tets.raw()[t]);
    if (subject.slab_count == 0 || slab(t) != slab(order[subject.slab.size() - 1])) {
      ++subject.slab_count;
      subject.slab_number.push_back(slab(t));
    }
    subject.slab.push_back(static_cast<std::uint32_t>(subject.slab_count - 1));
    if (!model.component.empty()) subject.component.push_back(model.component.raw()[t].value());
    if (!model.kind.empty()) subject.kind.push_back(model.kind.raw()[t]);
  }
}

void find_faces(const TetMesh& mesh, Subject& subject) {
  subject.boundary = mesh.boundary();
  for (std::size_t h = 0; h < 4 * subject.tets.size(); ++h) {
    const HalfFaceId other = mesh.opposite(HalfFaceId(h));
    if (other.valid() && subject.slab[other.index() / 4] != subject.slab[h / 4]) {
      subject.walls.push_back(HalfFaceId(h));
    }
  }
}

void number_components(const TetMesh& mesh, Subject& subject) {
  if (subject.component.empty()) {
    for (const ComponentId c : mesh.components()) subject.component.push_back(c.value());
  }
  // Files may number them in any way.
  std::map<std::uint32_t, std::uint32_t> number;
  for (const std::uint32_t c : subject.component) number.emplace(c, 0U);
  for (auto& [c, k] : number) {
    k = static_cast<std::uint32_t>(subject.component_count++);
    subject.component_number.push_back(c);
  }
  for (std::uint32_t& c : subject.component) c = number[c];
}

void measure(Subject& subject) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  subject.low = {kInfinity, kInfinity, kInfinity};
  subject.high = {-kInfinity, -kInfinity, -kInfinity};
  subject.dihedral.reserve(subject.tets.size());
  for (const TetVertices& tet : subject.tets) {
    std::array<Point3, 4> p;
    for (std::size_t i = 0; i < 4; ++i) {
      p[i] = subject.points[tet[i].index()];
      subject.low = {std::min(subject.low.x, p[i].x), std::min(subject.low.y, p[i].y),
                     std::min(subject.low.z, p[i].z)};
      subject.high = {std::max(subject.high.x, p[i].x), std::max(subject.high.y, p[i].y),
                      std::max(subject.high.z, p[i].z)};
    }
    subject.dihedral.push_back(smallest_dihedral(p));
  }
  subject.mean_gap = (subject.high.z - subject.low.z) / static_cast<double>(subject.slab_count);
}

}  // namespace

Rgb Subject::colour(std::size_t tet, ColourBy by) const {
  switch (by) {
    case ColourBy::component: return component_colour(component[tet]);
    case ColourBy::slab:
      return slab_colour(slab_count < 2 ? 0.5
                                        : static_cast<double>(slab[tet]) /
                                              static_cast<double>(slab_count - 1));
    case ColourBy::kind: return kind_colour(kind[tet]);
    case ColourBy::dihedral:
      return dihedral_colour(static_cast<double>(dihedral[tet]) / kBestDihedral);
    case ColourBy::evidence: return evidence_colour(evidence[tet]);
  }
  return {};
}

Result<Subject> subject_of(const Model& model, const SectionStack* contours,
                           const RenderOptions& options) {
  for (Result<void> checked : {check_options(options), check_model(model),
                               contours == nullptr ? Result<void>() : check_contours(*contours)}) {
    if (!checked) return checked.error();
  }
  if (options.colour == ColourBy::kind && model.kind.empty()) {
    return Error{ErrorCode::usage, "the model does not tell the kind of its tets", {}};
  }
  if (options.colour == ColourBy::evidence && !tells_evidence(model)) {
    return Error{ErrorCode::usage, "the model does not tell its links", {}};
  }
  Subject subject;
  subject.points.reserve(model.points.size());
  subject.exponent = exponent_of(model, contours);
  const auto scaled = [&](double value) { return std::ldexp(value, -subject.exponent); };
  for (const Point3& p : model.points) {
    subject.points.push_back({scaled(p.x), scaled(p.y), options.stretch * scaled(p.z)});
  }
  sort_by_slab(model, subject);
  const Result<TetMesh> mesh = TetMesh::from_tets(model.points.size(), subject.tets);
  if (!mesh) return mesh.error();
  find_faces(*mesh, subject);
  number_components(*mesh, subject);
  measure(subject);
  if (tells_evidence(model)) {
    subject.evidence = evidence_by_tet(model, *mesh, subject);
    for (const RegionLink& link : model.links) {
      if (link.fate == LinkFate::made) ++subject.links[static_cast<std::size_t>(link.evidence)];
    }
  }
  subject.normals = smooth_normals(subject);
  add_contours(model, contours, options.stretch, subject);
  return subject;
}

}  // namespace tetloft::internal::render
