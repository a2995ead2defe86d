#include "between/simplify.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <tetloft/valid_stack.hpp>

#include "between/chords.hpp"
#include "sections/segments.hpp"
#include "spatial/box_tree.hpp"

namespace tetloft::internal::between {

namespace {

// Rounds of dividing chords that touch; what touches then gets all its vertices back. A round
// divides by two or so.
constexpr int kDivisions = 24;

// The nesting of a valid section; of another one the faulty contour, or how many there are.
std::optional<Nesting> nest_valid(const Section& section, std::size_t& faulty) {
  SectionStack stack;
  stack.sections.push_back(section);
  Result<IdVector<SectionId, Nesting>> nested = nest_if_valid(stack);
  if (nested) return std::move((*nested)[SectionId(0)]);
  faulty = nested.error().where.contour.value_or(section.contours.size());
  return std::nullopt;
}

class Simplifier {
 public:
  Simplifier(const Section& section, double tolerance, double longest) : section_(section) {
    for (const Contour& contour : section.contours) {
      chords_.push_back(ContourChords(contour, tolerance, longest));
    }
  }

  [[nodiscard]] Section simplified() const {
    Section result{section_.z, {}};
    for (const ContourChords& chords : chords_) result.contours.push_back(chords.contour());
    return result;
  }

  // Divides chords that touch until none do.
  void part() {
    for (int round = 0;; ++round) {
      const std::vector<Touch> touches = find_touches();
      if (touches.empty()) return;
      bool changed = false;
      for (const Touch& touch : touches) {
        ContourChords& chords = chords_[touch.contour];
        changed |= round < kDivisions ? chords.divide(touch.chord) : chords.restore();
      }
      if (!changed) return;
      for (ContourChords& chords : chords_) chords.settle();
    }
  }
  bool restore(ContourId c) { return chords_[c].restore(); }
  bool restore_all() {
    bool changed = false;
    for (ContourChords& chords : chords_) changed |= chords.restore();
    return changed;
  }

 private:
  struct Touch {
    ContourId contour;
    std::size_t chord;
  };
  struct Edge {
    Point2 a, b;
    Touch at;
    std::size_t next;  // edge of the contour
  };

  // The chords that touch others than their neighbours.
  [[nodiscard]] std::vector<Touch> find_touches() const {
    std::vector<Edge> edges;
    std::vector<Box2> boxes;
    for (const ContourId c : chords_.ids()) {
      const std::vector<Point2> vertices = chords_[c].contour().vertices;
      const std::size_t first = edges.size();
      for (std::size_t v = 0; v < vertices.size(); ++v) {
        const std::size_t w = v + 1 == vertices.size() ? 0 : v + 1;
        edges.push_back({vertices[v], vertices[w], {c, v}, first + w});
        boxes.push_back(box_of(vertices[v], vertices[w]));
      }
    }
    const BoxTree2 tree(boxes);
    std::vector<std::uint8_t> touches(edges.size(), 0);
    for (std::size_t e = 0; e < edges.size(); ++e) {
      tree.query(boxes[e], [&](std::size_t f) {
        if (f <= e || edges[e].next == f || edges[f].next == e) return;
        if (!sections::touch(edges[e].a, edges[e].b, edges[f].a, edges[f].b)) return;
        touches[e] = touches[f] = 1;
      });
    }
    std::vector<Touch> result;
    for (std::size_t e = 0; e < edges.size(); ++e) {
      if (touches[e] != 0) result.push_back(edges[e].at);
    }
    return result;
  }

  const Section& section_;
  IdVector<ContourId, ContourChords> chords_;
};

// Contours that lie in another one than they should.
std::vector<ContourId> misplaced(const Nesting& nesting, const Nesting& wanted) {
  std::vector<ContourId> result;
  for (const ContourId c : wanted.parent.ids()) {
    if (nesting.parent[c] == wanted.parent[c]) continue;
    result.push_back(c);
    if (nesting.parent[c].valid()) result.push_back(nesting.parent[c]);
    if (wanted.parent[c].valid()) result.push_back(wanted.parent[c]);
  }
  return result;
}

}  // namespace

std::optional<SimplifiedSection> simplify(const Section& section, double tolerance,
                                          double longest) {
  if (section.contours.empty()) return SimplifiedSection{section, {}};
  std::size_t faulty = 0;
  const std::optional<Nesting> wanted = nest_valid(section, faulty);
  if (!wanted) return std::nullopt;
  Simplifier simplifier(section, tolerance, longest);
  for (;;) {
    simplifier.part();
    Section result = simplifier.simplified();
    // Every round gives a contour all of its vertices back, or ends.
    bool changed = false;
    if (std::optional<Nesting> nesting = nest_valid(result, faulty)) {
      const std::vector<ContourId> wrong = misplaced(*nesting, *wanted);
      if (wrong.empty()) return SimplifiedSection{std::move(result), *std::move(nesting)};
      for (const ContourId c : wrong) changed |= simplifier.restore(c);
    } else {
      changed = faulty < section.contours.size() && simplifier.restore(ContourId(faulty));
    }
    if (!changed && !simplifier.restore_all()) return std::nullopt;
  }
}

}  // namespace tetloft::internal::between
