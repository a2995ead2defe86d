// All steps of Geiger's algorithm, and the model.
#include <tetloft/geiger.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <tetloft/predicates.hpp>

#include "core/guard.hpp"
#include "core/option_rules.hpp"
#include "core/parallel.hpp"
#include "core/watched_work.hpp"
#include "geiger/elimination.hpp"
#include "geiger/obtuse.hpp"
#include "geiger/projection.hpp"
#include "model/scaling.hpp"
#include "sections/scaling.hpp"
#include "slab/delaunay.hpp"
#include "slab/slab.hpp"

namespace tetloft {

using namespace internal;

namespace {

class Geiger {
 public:
  /// Of the stack times 2^exponent. Nothing where the model, times 2^-exponent, is none.
  Geiger(const SectionStack& stack, int exponent, const GeigerOptions& options)
      : stack_(sections::scaled(stack, exponent)),
        exponent_(exponent),
        options_(options),
        work_(options.execution, 3 * stack.sections.size() - 1) {}

  Result<std::optional<GeigerModel>> run() {
    if (Result<void> made = make_sections(); !made) return as_given(made.error());
    if (Result<void> made = make_slabs(); !made) return as_given(made.error());
    assemble();
    if (!scale_exactly(model_, -exponent_)) return std::optional<GeigerModel>();
    return std::optional(GeigerModel{std::move(model_), report_});
  }

 private:
  struct SlabTets {
    SlabVertices vertices;
    std::vector<std::array<SlabVertexId, 4>> tets;
    std::vector<TetKind> kind;
    std::size_t external = 0;
    std::size_t singular = 0;
  };

  [[nodiscard]] std::size_t size() const { return stack_.sections.size(); }

  [[nodiscard]] Error as_given(Error error) const {
    if (error.where.point) error.where.point = scaled(*error.where.point, -exponent_);
    return error;
  }

  // Calls body(i) in parallel, each a step of the work.
  template <class Body>
  void for_each(std::size_t n, const Body& body) {
    parallel_for(n, options_.execution.threads, [&](std::size_t i) {
      work_.go_on();
      body(i);
      work_.step_done();
    });
  }

  // Steps 1 and 2.
  Result<void> make_sections() {
    std::vector<Section> contours(size());
    std::vector<ConformingSection> before(size());
    std::vector<std::size_t> feet(size(), 0);
    std::vector<std::optional<Error>> errors(size());
    for_each(size(), [&](std::size_t s) {
      const SectionId id(s);
      Result<Section> footed = options_.refine ? geiger::with_feet(stack_.sections[id], id, feet[s])
                                               : Result<Section>(stack_.sections[id]);
      if (!footed) {
        errors[s] = footed.error();
        return;
      }
      contours[s] = *std::move(footed);
      Result<ConformingSection> conforming = conform(contours[s], id);
      if (conforming) {
        before[s] = *std::move(conforming);
      } else {
        errors[s] = conforming.error();
      }
    });
    if (const auto error = first(errors)) return *error;
    sections_.resize(size());
    std::vector<std::size_t> projected(size(), 0);
    for_each(size(), [&](std::size_t s) {
      std::vector<Point2> candidates;
      for (const std::size_t other : {s - 1, s + 1}) {
        if (!options_.refine || other >= size()) continue;
        const auto found = geiger::external_skeleton_vertices(before[other]);
        candidates.insert(candidates.end(), found.begin(), found.end());
      }
      const std::vector<Point2> inside = geiger::projected_into(before[s], candidates);
      Result<ConformingSection> conforming =
          conform(contours[s], SectionId(s), {.interior = inside});
      if (conforming) {
        sections_[s] = *std::move(conforming);
        projected[s] = inside.size();
      } else {
        errors[s] = conforming.error();
      }
    });
    if (const auto error = first(errors)) return *error;
    for (std::size_t s = 0; s < size(); ++s) {
      report_.foot_vertices += feet[s];
      report_.projected_vertices += projected[s];
    }
    return {};
  }

  // Steps 3 to 5.
  Result<void> make_slabs() {
    slabs_.resize(size() - 1);
    std::vector<std::optional<Error>> errors(size() - 1);
    for_each(size() - 1, [&](std::size_t s) {
      const ConformingSection& lower = sections_[s];
      const ConformingSection& upper = sections_[s + 1];
      if (lower.vertex_count() == 0 || upper.vertex_count() == 0) return;
      Result<SlabDelaunay> d =
          slab_delaunay(SlabId(s), lower, upper, DelaunayEngine::slab, options_.work_limit);
      if (!d) {
        errors[s] = d.error();
        return;
      }
      const Slab slab(lower, upper, std::move(d.value()));
      const geiger::Elimination left = geiger::eliminate(slab);
      SlabTets& result = slabs_[s];
      result.external = left.external;
      result.singular = left.singular;
      result.vertices = slab.numbering();
      for (const TetId t : slab.tets()) {
        if (left.stays[t] == 0) continue;
        result.tets.push_back(slab.vertices(t));
        result.kind.push_back(slab.kind(t));
      }
    });
    if (const auto error = first(errors)) return *error;
    return {};
  }

  static std::optional<Error> first(const std::vector<std::optional<Error>>& errors) {
    const auto found =
        std::find_if(errors.begin(), errors.end(), [](const auto& e) { return e.has_value(); });
    return found == errors.end() ? std::nullopt : *found;
  }

  // Vertices of sections that a tet uses, and the tets, slab by slab.
  void assemble() {
    StackVertices stack;
    for (const ConformingSection& section : sections_) stack.add_section(section.vertex_count());
    std::vector<TetVertices> tets;  // over all vertices of the stack
    for (std::size_t s = 0; s < slabs_.size(); ++s) {
      const SlabId id(s);
      const SlabTets& slab = slabs_[s];
      report_.external_tets += slab.external;
      report_.singular_tets += slab.singular;
      const auto in_stack = [&](SlabVertexId v) {
        return stack.of(section_of(id, slab.vertices.is_upper(v)), slab.vertices.in_section(v));
      };
      for (const auto& [a, b, c, d] : slab.tets) {
        tets.push_back({in_stack(a), in_stack(b), in_stack(c), in_stack(d)});
        model_.slab.push_back(id);
      }
      model_.kind.raw().insert(model_.kind.end(), slab.kind.begin(), slab.kind.end());
    }
    number_vertices(tets, stack);
    find_components();
  }

  void number_vertices(const std::vector<TetVertices>& tets, const StackVertices& stack) {
    IdVector<VertexId, VertexId> number(stack.size());
    for (const TetVertices& tet : tets) {
      for (const VertexId v : tet) number[v] = VertexId(0);
    }
    for (std::size_t s = 0; s < size(); ++s) {
      const std::map<std::pair<double, double>, bool> input = input_points(s);
      std::vector<bool> seen(stack_.sections[SectionId(s)].contours.size(), false);
      for (const PlaneVertexId v : sections_[s].contour.ids()) {
        const ContourId contour = sections_[s].contour[v];
        const Point3 p = sections_[s].point3(v);
        const bool is_input = input.contains({p.x, p.y});
        report_.input_vertices += is_input ? 1U : 0U;
        report_.split_vertices += contour.valid() && !is_input ? 1U : 0U;
        VertexId& at = number[stack.of(SectionId(s), v)];
        if (!at.valid()) continue;
        if (contour.valid()) seen[contour.index()] = true;
        at = model_.points.push_back(p);
        model_.section.push_back(SectionId(s));
        model_.contour.push_back(contour);
        model_.origin.push_back(!contour.valid() ? PointOrigin::projected
                                : is_input       ? PointOrigin::input
                                                 : PointOrigin::contour_split);
      }
      report_.lost_contours +=
          static_cast<std::size_t>(std::count(seen.begin(), seen.end(), false));
    }
    report_.split_vertices -= report_.foot_vertices;
    for (const auto& [a, b, c, d] : tets) {
      model_.tets.push_back({number[a], number[b], number[c], number[d]});
    }
  }

  [[nodiscard]] std::map<std::pair<double, double>, bool> input_points(std::size_t s) const {
    std::map<std::pair<double, double>, bool> result;
    for (const Contour& contour : stack_.sections[SectionId(s)].contours) {
      for (const Point2& p : contour.vertices) result[{p.x, p.y}] = true;
    }
    return result;
  }

  // Face-connected parts, numbered by their lowest tet.
  void find_components() {
    const Result<TetMesh> mesh = half_faces(model_);
    TETLOFT_CHECK(accepted(mesh));
    model_.component = mesh->components();
    for (const ComponentId c : model_.component) {
      model_.component_count = std::max(model_.component_count, c.index() + 1);
    }
  }

  SectionStack stack_;
  int exponent_;
  const GeigerOptions& options_;
  std::vector<ConformingSection> sections_;
  std::vector<SlabTets> slabs_;
  Model model_;
  GeigerReport report_;
  WatchedWork work_;
};

}  // namespace

Result<GeigerModel> reconstruct_geiger(const SectionStack& stack,
                                       const GeigerOptions& given_options) {
  return guard_threads(given_options, [&](const GeigerOptions& options) -> Result<GeigerModel> {
    if (Result<void> sound = fp_self_check(); !sound) return sound.error();
    if (Result<void> good = check_work_limit(options.work_limit); !good) return good.error();
    const Result<void> valid = validate(stack, untold(options.execution));
    if (!valid) return valid.error();
    if (stack.sections.size() < 2) {
      return Error{ErrorCode::invalid_input, "Geiger's algorithm needs two sections or more", {}};
    }
    // In the stack's unit of length, unless the model has finer bits than the one given.
    auto made = Geiger(stack, sections::unit_of(stack).exponent(), options).run();
    if (made && !*made) made = Geiger(stack, 0, options).run();
    if (!made) return made.error();
    (*made)->model.frame = stack.frame;
    (*made)->model.about = stack.about;
    return std::move(**made);
  });
}

}  // namespace tetloft
