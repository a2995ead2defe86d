#include "sections/section_repair.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <set>
#include <tuple>

#include <tetloft/nesting.hpp>

#include "core/guard.hpp"
#include "sections/boundary_trace.hpp"
#include "sections/keyholes.hpp"
#include "sections/scaling.hpp"
#include "sections/segments.hpp"

namespace tetloft::internal::sections {

namespace {

double area_of(const Section& section) {
  const Nesting nesting = nest(section);
  double area = 0;
  for (const ContourId c : section.contours.ids()) {
    const double part = std::abs(twice_area(section.contours[c])) / 2;
    area += nesting.depth[c] % 2 == 0 ? part : -part;
  }
  return area;
}

bool is_valid(const Section& section) {
  if (section.contours.empty()) return true;
  SectionStack alone;
  alone.sections.push_back(section);
  alone.sections[SectionId(0)].z = 0;
  return accepted(validate(alone, {.threads = 1}));
}

}  // namespace

SectionRepair::SectionRepair(const Section& section, std::size_t number, const Options& options,
                             int exponent)
    : section_(scaled_in_plane(section, exponent)),
      number_(number),
      options_(options),
      exponent_(exponent),
      dirty_(section.contours.size(), false),
      left_out_(section.contours.size(), false),
      arrangement_(std::ldexp(options.distance, exponent) / 32,
                   std::ldexp(options.distance, exponent), options.fill) {
  options_.distance = std::ldexp(options.distance, exponent);
  if (options.keyholes) options_.keyholes = std::ldexp(*options.keyholes, exponent);
}

Result<Section> SectionRepair::run() {
  find_contacts();
  leave_out_copies();
  add_edges();
  switch (arrangement_.settle()) {
    case Arrangement::Outcome::endless:
      return refusal("splitting its edges where they meet does not end");
    case Arrangement::Outcome::moved_too_far:
      return refusal("a crossing would move by more than the distance allowed");
    case Arrangement::Outcome::settled: break;
  }
  moved_ = arrangement_.moved();
  const RegionSides sides(arrangement_, section_, dirty_, options_.fill);
  tell_events();
  tell_overlaps(sides);
  find_area_before(sides);
  find_lost(sides);
  Result<Section> repaired = retrace(sides);
  if (!repaired) return repaired;
  if (options_.keyholes) return without_channels(*std::move(repaired));
  area_after_ = area_of(*repaired);
  return repaired;
}

void SectionRepair::report(Repaired& result) const {
  result.moved = std::max(result.moved, std::ldexp(moved_, -exponent_));
  result.changes.insert(result.changes.end(), changes_.begin(), changes_.end());
  result.area_before += std::ldexp(area_before_, -2 * exponent_);
  result.area_after += std::ldexp(area_after_, -2 * exponent_);
  result.lost.insert(result.lost.end(), lost_.begin(), lost_.end());
  result.copies += copies_.size();
  result.channels += channels_;
}

Error SectionRepair::refusal(const std::string& why) const {
  Error error{ErrorCode::invalid_input, "cannot be repaired: " + why, {}};
  error.where.section = number_;
  for (std::size_t c = 0; c < dirty_.size() && !error.where.contour; ++c) {
    if (dirty_[c]) error.where.contour = c;
  }
  return error;
}

void SectionRepair::tell(const std::string& message, ContourId contour, std::optional<Point2> p) {
  Warning change{message, {}};
  change.where.section = number_;
  change.where.contour = contour.index();
  if (p) {
    const Point2 at = internal::scaled(*p, -exponent_);
    change.where.point = Point3{at.x, at.y, section_.z};
  }
  changes_.push_back(std::move(change));
}

std::string SectionRepair::length_text(double scaled_length) const {
  char text[40];
  std::snprintf(text, sizeof text, "%.3g", std::ldexp(scaled_length, -exponent_));
  return text;
}

// Which contours touch or cross, themselves or each other.
void SectionRepair::find_contacts() {
  struct Edge {
    ContourId contour;
    std::size_t place;
  };
  std::vector<Edge> edges;
  for (const ContourId c : section_.contours.ids()) {
    const auto& v = section_.contours[c].vertices;
    for (std::size_t k = 0; k < v.size(); ++k) edges.push_back({c, k});
    if (v.size() >= 3) continue;
    dirty_[c.index()] = true;
    tell("contour without area removed", c, std::nullopt);
  }
  const auto edge = [&](std::size_t i) {
    const auto& v = section_.contours[edges[i].contour].vertices;
    return std::array<Point2, 2>{v[edges[i].place], v[(edges[i].place + 1) % v.size()]};
  };
  std::set<std::pair<ContourId, ContourId>> contacts;
  for_each_near_pair(edges.size(), edge, [&](std::size_t i, std::size_t j) {
    const std::pair<ContourId, ContourId> pair = std::minmax(edges[i].contour, edges[j].contour);
    const std::array<Point2, 2> e = edge(i);
    const std::array<Point2, 2> f = edge(j);
    const auto& [a, b] = e;
    const auto& [c, d] = f;
    const std::size_t n = section_.contours[edges[i].contour].vertices.size();
    const bool same = pair.first == pair.second;
    const bool consecutive = same && (edges[i].place + 1 == edges[j].place ||
                                      (edges[i].place == 0 && edges[j].place + 1 == n));
    const bool meet = in_segment(c, d, a) || in_segment(c, d, b) || in_segment(a, b, c) ||
                      in_segment(a, b, d) || sections::cross(a, b, c, d);
    const bool share = a == c || a == d || b == c || b == d;
    if (!meet && (!share || (consecutive && !(a == c && b == d) && !(a == d && b == c)))) return;
    contacts.insert(pair);
  });
  contacts_.assign(contacts.begin(), contacts.end());
}

// What is left in contact with nothing then stays as it is.
void SectionRepair::leave_out_copies() {
  std::vector<std::pair<ContourId, ContourId>> between_two;
  for (const auto& pair : contacts_) {
    if (pair.first != pair.second) between_two.push_back(pair);
  }
  copies_ = find_copies(section_, between_two);
  for (const Copy& copy : copies_) {
    left_out_[copy.contour.index()] = true;
    tell("a copy of contour " + std::to_string(copy.kept.index()) +
             (copy.apart == 0 ? "" : ", but for " + length_text(copy.apart) + ",") + " left out",
         copy.contour, std::nullopt);
  }
  for (const auto& [c, d] : contacts_) {
    if (left_out_[c.index()] || left_out_[d.index()]) continue;
    dirty_[c.index()] = dirty_[d.index()] = true;
  }
}

void SectionRepair::add_edges() {
  for (const ContourId c : section_.contours.ids()) {
    if (!dirty_[c.index()] || left_out_[c.index()]) continue;
    const auto& v = section_.contours[c].vertices;
    for (std::size_t k = 0; k < v.size(); ++k) {
      arrangement_.add_edge(v[k], v[(k + 1) % v.size()], c);
    }
  }
  for (const Copy& copy : copies_) dirty_[copy.contour.index()] = true;  // nowhere to be found
}

void SectionRepair::tell_events() {
  std::set<std::tuple<ArrangementEvent::Kind, double, double>> told;
  for (const ArrangementEvent& event : arrangement_.events()) {
    if (!told.insert({event.kind, event.at.x, event.at.y}).second &&
        event.kind != ArrangementEvent::Kind::cancelled) {
      continue;
    }
    const char* message = "";
    switch (event.kind) {
      case ArrangementEvent::Kind::merged: message = "vertex put on another next to it"; break;
      case ArrangementEvent::Kind::crossing: message = "crossing resolved"; break;
      case ArrangementEvent::Kind::cancelled:
        message = "pieces of edges that lie on each other removed";
        break;
      case ArrangementEvent::Kind::shared:
        message = "pieces of edges that lie on each other made one";
        break;
    }
    tell(message, event.contour, event.at);
  }
}

void SectionRepair::tell_overlaps(const RegionSides& sides) {
  if (options_.fill == FillRule::winding) return;
  for (const auto& [c, d] : sides.overlapping()) {
    const std::string both = "overlaps contour " + std::to_string(d.index());
    tell(options_.fill == FillRule::unite
             ? both + " and is united with it"
             : both + ", and what lies in both is left out (by the fill rule \"union\" it is kept)",
         c, std::nullopt);
  }
}

void SectionRepair::find_area_before(const RegionSides& sides) {
  if (sides.pieces().empty()) {
    area_before_ = 0;
  } else {
    const Point2 o = arrangement_.at(sides.pieces().front().a);
    for (const SidedPiece& piece : sides.pieces()) {
      if (piece.left == piece.right) continue;
      const Point2& a = arrangement_.at(piece.a);
      const Point2& b = arrangement_.at(piece.b);
      const double half = ((a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x)) / 2;
      area_before_ += piece.left ? half : -half;
    }
  }
  for (const ContourId c : section_.contours.ids()) {
    const ContourSides& around = sides.of_contour(c);
    if (dirty_[c.index()] || around.inside == around.outside) continue;
    const double part = std::abs(twice_area(section_.contours[c])) / 2;
    area_before_ += around.inside ? part : -part;
  }
}

// Contours with nothing of the region beside them.
void SectionRepair::find_lost(const RegionSides& sides) {
  std::vector<bool> has_region(section_.contours.size(), false);
  for (const SidedPiece& piece : sides.pieces()) {
    if (!piece.left && !piece.right) continue;
    for (std::size_t i = piece.first; i < piece.last; ++i) {
      has_region[arrangement_.pieces()[i].contour.index()] = true;
    }
  }
  for (const ContourId c : section_.contours.ids()) {
    if (!dirty_[c.index()] || left_out_[c.index()] || has_region[c.index()]) continue;
    const Contour& contour = section_.contours[c];
    if (contour.vertices.size() < 3 || area_sign(contour) == Sign::zero) continue;
    const double area = std::ldexp(std::abs(twice_area(contour)) / 2, -2 * exponent_);
    char text[60];
    std::snprintf(text, sizeof text, "%.6g", area);
    tell(std::string("NOTHING IS LEFT of this contour, which bounds an area of ") + text +
             ": it cancels, or is too thin",
         c, contour.vertices.front());
    lost_.push_back({SectionId(number_), c, area});
  }
}

// Those without contact where they were, where they bound the region; traced ones at the place of
// the contour that they begin with.
Section SectionRepair::with_traced(const RegionSides& sides,
                                   const std::vector<std::pair<ContourId, Contour>>& traced) {
  std::vector<std::pair<ContourId, Contour>> contours;
  for (const ContourId c : section_.contours.ids()) {
    const ContourSides& around = sides.of_contour(c);
    if (dirty_[c.index()] || around.inside == around.outside) continue;
    contours.emplace_back(c, section_.contours[c]);
  }
  contours.insert(contours.end(), traced.begin(), traced.end());
  std::stable_sort(contours.begin(), contours.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  Section result;
  result.z = section_.z;
  origin_.clear();
  for (auto& [origin, contour] : contours) {
    origin_.push_back(origin);
    result.contours.push_back(std::move(contour));
  }
  return result;
}

Result<Section> SectionRepair::retrace(const RegionSides& sides) {
  for (const ContourId c : section_.contours.ids()) {
    const ContourSides& around = sides.of_contour(c);
    if (dirty_[c.index()] || around.inside != around.outside) continue;
    tell("removed: the region has both sides of it", c, std::nullopt);
  }
  if (std::find(dirty_.begin(), dirty_.end(), true) == dirty_.end()) {
    return with_traced(sides, {});
  }
  const BoundaryTrace trace(arrangement_, sides);
  const std::vector<BoundaryTrace::Touching> touching = trace.touching();
  // Corners cut off too far may reach what is near; each try cuts off less.
  double cut = options_.distance - moved_;
  constexpr int kTries = 6;
  for (int k = 0; k < kTries; ++k, cut /= 16) {
    Section repaired = with_traced(sides, trace.contours(cut));
    if (!is_valid(repaired)) continue;
    if (!touching.empty()) moved_ += cut;
    for (const BoundaryTrace::Touching& at : touching) {
      tell("contact parted by cutting corners off, " + length_text(cut) + " deep at most",
           at.contour, at.at);
    }
    return repaired;
  }
  return refusal("its contours cannot be parted within the distance allowed");
}

Section SectionRepair::without_channels(Section section) {
  if (!is_valid(section)) return section;  // what else is wrong with it is told by validate()
  ClosedChannels closed = close_channels(section, *options_.keyholes);
  for (const Channel& channel : closed.channels) {
    ++channels_;
    tell("channel closed, " + length_text(channel.width) + " wide and " +
             length_text(channel.length) + " long",
         origin_[channel.contour], channel.at);
  }
  area_after_ = area_of(closed.section);
  return std::move(closed.section);
}

}  // namespace tetloft::internal::sections
