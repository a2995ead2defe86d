#include "between/competition.hpp"

#include <algorithm>

#include "spatial/box_tree.hpp"

namespace tetloft::internal::between {

namespace {

using motion::LatticeWindow;

// How much farther outside the others are than the owner is inside. On a lattice edge between two
// owners the crossings part at ratios that differ by its square.
constexpr double kOutside = 1.15;
constexpr double kDeepestBeside = -0.5;
constexpr double kShallowestBeside = -0.1;

Box2 box_of_samples(const LatticeWindow& w) {
  Box2 box;
  if (w.size() == 0) return box;
  box.add(Point2{static_cast<double>(w.i0), static_cast<double>(w.j0)});
  box.add(Point2{static_cast<double>(w.i1 - 1), static_cast<double>(w.j1 - 1)});
  return box;
}

// Calls visit(place in the first window, place in the second one, i, j) for the common samples.
template <class Visit>
void visit_common(const LatticeWindow& first, const LatticeWindow& second,
                  const LatticeWindow& common, const Visit& visit) {
  for (std::int64_t j = common.j0; j < common.j1; ++j) {
    std::size_t p = first.place(common.i0, j);
    std::size_t q = second.place(common.i0, j);
    for (std::int64_t i = common.i0; i < common.i1; ++i, ++p, ++q) visit(p, q, i, j);
  }
}

double softened(double value) { return std::clamp(value, kDeepestBeside, kShallowestBeside); }

// Calls visit(owner's value, other's value) at each sample of one of the two classes that has one
// of the other beside it, once for each of those.
template <class Visit>
void visit_borders(const MeetingWindows& meeting, ClassShapes& shapes, std::size_t layer,
                   const Visit& visit) {
  const LatticeWindow& first = shapes[meeting.first].window;
  const LatticeWindow& second = shapes[meeting.second].window;
  std::vector<double>& a = shapes[meeting.first].value[layer];
  std::vector<double>& b = shapes[meeting.second].value[layer];
  const auto beside = [&](std::size_t p, std::size_t q, std::size_t on_p, std::size_t on_q) {
    if (a[p] < 0 && b[on_q] < 0) {
      visit(a[p], b[q]);
      visit(b[on_q], a[on_p]);
    } else if (b[q] < 0 && a[on_p] < 0) {
      visit(b[q], a[p]);
      visit(a[on_p], b[on_q]);
    }
  };
  visit_common(first, second, meeting.common,
               [&](std::size_t p, std::size_t q, std::int64_t i, std::int64_t j) {
                 if (i + 1 < meeting.common.i1) beside(p, q, p + 1, q + 1);
                 if (j + 1 < meeting.common.j1) beside(p, q, p + first.nx(), q + second.nx());
               });
}

// All others first: what an owner pushed out stays as near to it as it was.
void soften_borders(const std::vector<MeetingWindows>& meetings, ClassShapes& shapes,
                    std::size_t layer) {
  for (const MeetingWindows& meeting : meetings) {
    visit_borders(meeting, shapes, layer, [](const double& owner, double& other) {
      if (other <= kOutside * -owner) other = kOutside * -softened(owner);
    });
  }
  for (const MeetingWindows& meeting : meetings) {
    visit_borders(meeting, shapes, layer,
                  [](double& owner, const double&) { owner = softened(owner); });
  }
}

void compete_in_layer(const MeetingWindows& meeting, ClassShapes& shapes, std::size_t layer) {
  std::vector<double>& a = shapes[meeting.first].value[layer];
  std::vector<double>& b = shapes[meeting.second].value[layer];
  visit_common(shapes[meeting.first].window, shapes[meeting.second].window, meeting.common,
               [&](std::size_t p, std::size_t q, std::int64_t, std::int64_t) {
                 if (a[p] < 0 && a[p] <= b[q]) {
                   b[q] = std::max(b[q], kOutside * -a[p]);
                 } else if (b[q] < 0) {
                   a[p] = std::max(a[p], kOutside * -b[q]);
                 }
               });
}

std::size_t layers_of(const ClassShapes& shapes) {
  return shapes.empty() ? 0 : shapes[ClassId(0)].value.size();
}

}  // namespace

std::vector<MeetingWindows> meeting_windows(const ClassShapes& shapes) {
  std::vector<Box2> boxes;
  for (const ClassShape& shape : shapes) boxes.push_back(box_of_samples(shape.window));
  const BoxTree2 tree(boxes);
  std::vector<MeetingWindows> meetings;
  for (const ClassId a : shapes.ids()) {
    tree.query(boxes[a.index()], [&](std::size_t other) {
      const ClassId b(other);
      if (!(a < b)) return;
      const LatticeWindow& v = shapes[a].window;
      const LatticeWindow& w = shapes[b].window;
      meetings.push_back({a,
                          b,
                          {std::max(v.i0, w.i0), std::max(v.j0, w.j0), std::min(v.i1, w.i1),
                           std::min(v.j1, w.j1)}});
    });
  }
  std::sort(meetings.begin(), meetings.end(), [](const auto& x, const auto& y) {
    return x.first != y.first ? x.first < y.first : x.second < y.second;
  });
  return meetings;
}

// Pair by pair, and in any order: nobody is pushed farther out than by the lowest value, which
// nobody pushes.
void compete(ClassShapes& shapes, const std::vector<MeetingWindows>& meetings) {
  for (std::size_t layer = 1; layer + 1 < layers_of(shapes); ++layer) {
    for (const MeetingWindows& meeting : meetings) compete_in_layer(meeting, shapes, layer);
  }
}

void part_contours(ClassShapes& shapes, const std::vector<MeetingWindows>& meetings) {
  for (std::size_t layer = 1; layer + 1 < layers_of(shapes); ++layer) {
    soften_borders(meetings, shapes, layer);
  }
  compete(shapes, meetings);
}

ForeignSamples::ForeignSamples(const ClassShapes& shapes,
                               const std::vector<MeetingWindows>& meetings, ClassId c)
    : shapes_(shapes), meetings_(meetings), class_(c), foreign_(layers_of(shapes)) {}

const std::vector<std::uint8_t>& ForeignSamples::in(std::size_t layer) {
  std::vector<std::uint8_t>& foreign = foreign_[layer];
  if (!foreign.empty()) return foreign;
  foreign.assign(shapes_[class_].window.size(), 0);
  for (const MeetingWindows& meeting : meetings_) {
    if (meeting.first != class_ && meeting.second != class_) continue;
    const ClassShape& other = shapes_[meeting.first == class_ ? meeting.second : meeting.first];
    const std::vector<double>& value = other.value[layer];
    visit_common(shapes_[class_].window, other.window, meeting.common,
                 [&](std::size_t p, std::size_t q, std::int64_t, std::int64_t) {
                   if (value[q] < 0) foreign[p] = 1;
                 });
  }
  return foreign;
}

}  // namespace tetloft::internal::between
