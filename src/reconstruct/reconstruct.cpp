// The API: validates, runs the steps over all sections and slabs, glues, reports.
#include <tetloft/reconstruct.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include <tetloft/predicates.hpp>

#include "core/check.hpp"
#include "core/cpu_clock.hpp"
#include "core/enums.hpp"
#include "core/option_rules.hpp"
#include "core/parallel.hpp"
#include "core/watched_work.hpp"
#include "model/scaling.hpp"
#include "reconstruct/assembly.hpp"
#include "reconstruct/correspondence.hpp"
#include "reconstruct/drift_links.hpp"
#include "reconstruct/slab_solid.hpp"
#include "reconstruct/work_limit.hpp"
#include "sections/scaling.hpp"

namespace tetloft {

namespace {

using Clock = std::chrono::steady_clock;

// Steps that the caller's callback hears of; an empty stack is refused.
std::size_t step_count(const SectionStack& stack) {
  const std::size_t sections = stack.sections.size();
  return sections == 0 ? 0 : 2 * sections - 1;
}

// In which unit of length a model is made: README.md, "Scale".
enum class Unit : std::uint8_t { of_the_stack, as_given };

class Reconstructor {
 public:
  Reconstructor(const SectionStack& stack, const ReconstructOptions& options, Unit unit)
      : given_(stack),
        options_(options),
        unit_(unit),
        work_(options.execution, step_count(stack)) {}

  /// Nothing where the model, made in the stack's unit, is none in the one given.
  Result<std::optional<Reconstruction>> run() {
    auto made = make();
    if (made) return made;
    Error error = made.error();
    if (error.where.point) error.where.point = scaled(*error.where.point, -exponent_);
    return error;
  }

 private:
  Result<std::optional<Reconstruction>> make() {
    const auto start = Clock::now();
    if (auto error = check_options()) return *error;
    if (auto error = prepare_sections()) return *error;
    if (auto error = place_ends()) return *error;

    // Usually once; again when a class needs Gabriel edges to be connectable.
    for (;;) {
      if (auto error = find_correspondence()) return *error;
      const WorkStopwatch watch;
      Assembly assembly(sections_, correspondence_);
      add_seconds(Step::assembly, watch);
      Result<std::optional<Unconnected>> built = build_parts(assembly);
      if (!built) return built.error();
      if (*built) {
        if (auto error = refine(**built)) return *error;
        continue;
      }
      result_.model = assembly.take();
      if (!scale_exactly(result_.model, -exponent_)) return std::optional<Reconstruction>();
      result_.partition = std::move(correspondence_.partition);
      report(assembly.tally(), std::chrono::duration<double>(Clock::now() - start).count());
      return std::optional(std::move(result_));
    }
  }

  struct Unconnected {
    SlabId slab;
    std::vector<SlabRegionId> regions;
  };
  // Where the prisms beyond the first and last section end.
  struct EndPlanes {
    double below;
    double above;
  };

  [[nodiscard]] std::size_t section_count() const { return given_.sections.size(); }
  [[nodiscard]] std::size_t slab_count() const { return section_count() - 1; }

  void add_seconds(Step step, const WorkStopwatch& watch) {
    result_.report.seconds[static_cast<std::size_t>(step)] += watch.seconds();
  }

  // Runs body(i) -> std::optional<Error> in parallel; the error of the lowest index, if any.
  template <class Body>
  std::optional<Error> parallel_errors(std::size_t n, const Body& body) const {
    std::vector<std::optional<Error>> errors(n);
    parallel_for(n, options_.execution.threads, [&](std::size_t i) {
      work_.go_on();
      errors[i] = body(i);
    });
    for (std::optional<Error>& error : errors) {
      if (error) return std::move(error);
    }
    return std::nullopt;
  }

  [[nodiscard]] std::optional<Error> check_options() const {
    const Result<void> sensible = check_correspondence_options(options_.correspondence);
    if (!sensible) return sensible.error();
    if (!is_enumerator(options_.ends, Ends::half)) {
      return Error{ErrorCode::usage, "there are no such ends: flat or half", {}};
    }
    if (!is_enumerator(options_.delaunay, DelaunayEngine::slab)) {
      return Error{ErrorCode::usage, "there is no such Delaunay engine", {}};
    }
    Result<void> good = check_work_limit(options_.work_limit);
    if (good && options_.thickness) good = check_length(*options_.thickness, "the thickness");
    if (!good) return good.error();
    return std::nullopt;
  }

  std::optional<Error> prepare_sections() {
    const WorkStopwatch watch;
    const Result<void> valid = validate(given_, untold(options_.execution));
    if (!valid) return valid.error();
    choose_unit();
    nestings_.resize(section_count());
    sections_.resize(section_count());
    gabriel_.resize(section_count());
    auto error = parallel_errors(section_count(), [&](std::size_t s) {
      nestings_[SectionId(s)] = nest(stack_.sections[SectionId(s)]);
      auto failed = conform_section(SectionId(s));
      work_.step_done();
      return failed;
    });
    add_seconds(Step::sections, watch);
    return error;
  }

  void choose_unit() {
    if (unit_ == Unit::of_the_stack) {
      UnitOfLength unit = sections::unit_of(given_);
      if (section_count() == 1 && options_.thickness) unit.include(*options_.thickness);
      exponent_ = unit.exponent();
    }
    stack_ = sections::scaled(given_, exponent_);
  }

  std::optional<Error> conform_section(SectionId s) {
    std::size_t vertices = 0;
    for (const Contour& contour : stack_.sections[s].contours) vertices += contour.vertices.size();
    Result<ConformingSection> section = conform(
        stack_.sections[s], s,
        {.gabriel = gabriel_[s], .most_inserted = most_inserted(options_.work_limit, vertices)});
    if (!section) return section.error();
    sections_[s] = std::move(section.value());
    return std::nullopt;
  }

  std::optional<Error> find_correspondence() {
    const WorkStopwatch watch;
    IdVector<SlabId, std::vector<Link>> candidates(slab_count());
    auto error = parallel_errors(slab_count(), [&](std::size_t k) {
      return find_candidates(SlabId(k), candidates[SlabId(k)]);
    });
    if (error) return error;
    if (options_.correspondence.drift) {
      if (auto stopped = add_drift_links(candidates)) return stopped;
    }
    Result<Correspondence> decided =
        decide_correspondence(stack_, nestings_, candidates, options_.correspondence.labels);
    if (!decided) return decided.error();
    correspondence_ = std::move(decided.value());
    add_seconds(Step::correspondence, watch);
    return std::nullopt;
  }

  std::optional<Error> find_candidates(SlabId slab, std::vector<Link>& links) const {
    const SectionId below(slab.index());
    const SectionId above(slab.index() + 1);
    if (options_.correspondence.criterion == Criterion::overlap) {
      links = overlap_links(slab, stack_.sections[below], nestings_[below], stack_.sections[above],
                            nestings_[above], options_.correspondence.tau);
      return std::nullopt;
    }
    if (sections_[below].vertex_count() == 0 || sections_[above].vertex_count() == 0) {
      return std::nullopt;
    }
    Result<TetMesh> d = slab_delaunay(slab, sections_[below], sections_[above], options_.delaunay,
                                      options_.work_limit);
    if (!d) return d.error();
    links = reverse_links(slab, Slab(sections_[below], sections_[above], std::move(d.value())));
    return std::nullopt;
  }

  std::optional<Error> add_drift_links(IdVector<SlabId, std::vector<Link>>& candidates) const {
    IdVector<SlabId, std::vector<Link>> further(slab_count());
    auto error = parallel_errors(slab_count(), [&](std::size_t k) -> std::optional<Error> {
      further[SlabId(k)] =
          drift_links(SlabId(k), stack_, nestings_, candidates, *options_.correspondence.drift);
      return std::nullopt;
    });
    for (std::size_t k = 0; k < slab_count(); ++k) {
      std::vector<Link>& links = candidates[SlabId(k)];
      links.insert(links.end(), further[SlabId(k)].begin(), further[SlabId(k)].end());
    }
    return error;
  }

  // Builds all parts, each glued as soon as those below it are; or the lowest class that is
  // not connectable.
  Result<std::optional<Unconnected>> build_parts(Assembly& assembly) {
    const std::size_t ends_below = ends_ ? 1 : 0;
    if (ends_) {
      const SectionId first(0);
      assembly.add(0, {SlabId(0), SectionId(), first, build_end(sections_[first], ends_->below)});
    }
    IdVector<SlabId, std::vector<Unconnectable>> unconnectable(slab_count());
    auto error = parallel_errors(slab_count(), [&](std::size_t k) -> std::optional<Error> {
      const SectionId below(k);
      const SectionId above(k + 1);
      Result<SlabSolid> solid = build_slab_solid(SlabId(k), sections_[below], sections_[above],
                                                 correspondence_.links[SlabId(k)],
                                                 options_.delaunay, options_.work_limit);
      if (!solid) return solid.error();
      unconnectable[SlabId(k)] = std::move(solid->unconnectable);
      assembly.add(ends_below + k, {SlabId(k), below, above, std::move(solid.value())});
      if (refinements_ == 0) work_.step_done();  // each slab counts once
      return std::nullopt;
    });
    if (error) return *error;
    for (std::size_t k = 0; k < slab_count(); ++k) {
      const SlabId slab(k);
      if (unconnectable[slab].empty()) continue;
      return std::optional(Unconnected{slab, unconnectable[slab].front().regions});
    }
    if (ends_) {
      const SectionId last(section_count() - 1);
      const SlabId last_slab(section_count() == 1 ? 0 : slab_count() - 1);
      assembly.add(ends_below + slab_count(),
                   {last_slab, last, SectionId(), build_end(sections_[last], ends_->above)});
    }
    return std::optional<Unconnected>();
  }

  // Refines the contours of a class to Gabriel edges, after which overlapping regions have
  // an own–own edge of D between them.
  std::optional<Error> refine(const Unconnected& unconnected) {
    const SectionId below(unconnected.slab.index());
    const SectionId above(unconnected.slab.index() + 1);
    const std::size_t lows = nestings_[below].outer.size();
    bool news = false;
    for (const SlabRegionId r : unconnected.regions) {
      const bool upper = r.index() >= lows;
      const SectionId s = upper ? above : below;
      const RegionId region(upper ? r.index() - lows : r.index());
      const Nesting& nesting = nestings_[s];
      if (gabriel_[s].empty()) gabriel_[s].assign(nesting.region.size(), false);
      for (std::size_t c = 0; c < nesting.region.size(); ++c) {
        if (nesting.region[ContourId(c)] != region || gabriel_[s][ContourId(c)]) continue;
        gabriel_[s][ContourId(c)] = true;
        news = true;
      }
    }
    if (!news) return cannot_connect(unconnected);
    ++refinements_;
    const WorkStopwatch watch;
    auto error = conform_section(below);
    if (!error) error = conform_section(above);
    add_seconds(Step::sections, watch);
    return error;
  }

  [[nodiscard]] Error cannot_connect(const Unconnected& unconnected) const {
    const SectionId below(unconnected.slab.index());
    const std::size_t lows = nestings_[below].outer.size();
    std::string names;
    for (const SlabRegionId r : unconnected.regions) {
      const bool upper = r.index() >= lows;
      const SectionId s(below.index() + (upper ? 1 : 0));
      const RegionId region(upper ? r.index() - lows : r.index());
      if (!names.empty()) names += ", ";
      names += "section " + std::to_string(s.index()) + " contour " +
               std::to_string(nestings_[s].outer[region].index());
    }
    Place place;
    place.slab = unconnected.slab.index();
    return {ErrorCode::unrepresentable,
            "regions to be united have no Delaunay edge between them: " + names, place};
  }

  // Prisms beyond the first and last section.
  std::optional<Error> place_ends() {
    const SectionId first(0);
    const SectionId last(section_count() - 1);
    const double z0 = sections_[first].z;
    const double z1 = sections_[last].z;
    if (section_count() == 1) {
      const double half = 0.5 * single_thickness();
      ends_ = {z0 - half, z1 + half};
    } else if (options_.ends == Ends::half) {
      ends_ = {z0 - 0.5 * (sections_[SectionId(1)].z - z0),
               z1 + 0.5 * (z1 - sections_[SectionId(section_count() - 2)].z)};
    } else {
      return std::nullopt;
    }
    if (!(ends_->below < z0) || !(ends_->above > z1)) {
      Place place;
      place.section = ends_->below < z0 ? last.index() : 0;
      return Error{ErrorCode::unrepresentable,
                   "the end is too thin for a double beside the section's z", place};
    }
    return std::nullopt;
  }

  double single_thickness() {
    if (options_.thickness) return std::ldexp(*options_.thickness, exponent_);
    Point2 low{};
    Point2 high{};
    bool first = true;
    for (const Contour& contour : stack_.sections[SectionId(0)].contours) {
      for (const Point2& p : contour.vertices) {
        low = first ? p : Point2{std::min(low.x, p.x), std::min(low.y, p.y)};
        high = first ? p : Point2{std::max(high.x, p.x), std::max(high.y, p.y)};
        first = false;
      }
    }
    if (first) return 1;  // nothing to extrude
    const double thickness = std::max(high.x - low.x, high.y - low.y) / 10;
    Place place;
    place.section = 0;
    result_.warnings.push_back(
        {"a single section has no thickness of its own: a tenth of its "
         "larger side is taken; give one to be sure",
         place});
    return thickness;
  }

  void report(const PartTally& tally, double seconds_total) {
    ReconstructReport& report = result_.report;
    report.slices = section_count();
    report.contours = stack_.contour_count();
    report.input_vertices = stack_.vertex_count();
    report.vertices = result_.model.points.size();
    report.tets = result_.model.tets.size();
    report.components = result_.model.component_count;
    report.volume = volume(result_.model);
    for (const PointOrigin origin : result_.model.origin) {
      report.split_vertices += origin == PointOrigin::contour_split ? 1 : 0;
    }
    report.rules = tally.rules;
    for (std::size_t s = 0; s < kSteps; ++s) report.seconds[s] += tally.seconds[s];
    report.smallest_lift = tally.smallest_lift;
    report.work = tally.work + report.split_vertices;
    report.rules[static_cast<std::size_t>(Rule::gabriel_refinement)] = refinements_;
    for (std::size_t s = 1; s + 1 < section_count(); ++s) {
      const auto& internal = sections_[SectionId(s)].internal;
      report.rules[static_cast<std::size_t>(Rule::gluing)] +=
          static_cast<std::uint64_t>(std::count(internal.begin(), internal.end(), std::uint8_t{1}));
    }
    report.seconds_total = seconds_total;
  }

  const SectionStack& given_;
  const ReconstructOptions& options_;
  Unit unit_;
  int exponent_ = 0;
  SectionStack stack_;  // times 2^exponent_, as all coordinates until the model is done
  IdVector<SectionId, Nesting> nestings_;
  IdVector<SectionId, ConformingSection> sections_;
  IdVector<SectionId, IdVector<ContourId, bool>> gabriel_;  // empty: none
  Correspondence correspondence_;
  std::optional<EndPlanes> ends_;
  std::uint64_t refinements_ = 0;
  WatchedWork work_;
  Reconstruction result_;
};

}  // namespace

Result<Reconstruction> reconstruct(const SectionStack& stack,
                                   const ReconstructOptions& given_options) {
  return guard_threads(given_options,
                       [&](const ReconstructOptions& options) -> Result<Reconstruction> {
                         if (Result<void> sound = fp_self_check(); !sound) return sound.error();
                         auto made = Reconstructor(stack, options, Unit::of_the_stack).run();
                         if (!made) return made.error();
                         if (*made) return std::move(**made);
                         ReconstructOptions again = options;
                         again.execution.progress = nullptr;  // all steps have been told
                         made = Reconstructor(stack, again, Unit::as_given).run();
                         if (!made) return made.error();
                         return std::move(**made);
                       });
}

const char* name_of(Rule rule) {
  switch (rule) {
    case Rule::run_at_contour_edge: return "run_at_contour_edge";
    case Rule::run_at_external_edge: return "run_at_external_edge";
    case Rule::run_at_cross_edge: return "run_at_cross_edge";
    case Rule::gap_at_cross_edge: return "gap_at_cross_edge";
    case Rule::hole_in_link: return "hole_in_link";
    case Rule::detached_sheet: return "detached_sheet";
    case Rule::merge_sheets: return "merge_sheets";
    case Rule::connect_parts: return "connect_parts";
    case Rule::triangular_hole: return "triangular_hole";
    case Rule::two_class_tet: return "two_class_tet";
    case Rule::halved_lift: return "halved_lift";
    case Rule::moved_cut: return "moved_cut";
    case Rule::prism: return "prism";
    case Rule::gluing: return "gluing";
    case Rule::gabriel_refinement: return "gabriel_refinement";
    case Rule::opened_pit: return "opened_pit";
  }
  return "unknown";
}

const char* name_of(Step step) {
  switch (step) {
    case Step::sections: return "sections";
    case Step::delaunay: return "delaunay";
    case Step::correspondence: return "correspondence";
    case Step::complex: return "complex";
    case Step::subdivision: return "subdivision";
    case Step::contact: return "contact";
    case Step::assembly: return "assembly";
  }
  return "unknown";
}

}  // namespace tetloft
