// A face is an open set: the cells of it, glued at the openings between them. Cells are open discs,
// so its Euler characteristic is that of the graph: cells less openings.
#include "support/overlay_oracle.hpp"

#include <algorithm>
#include <map>

namespace tetloft::oracle {

namespace {

bool is_lower(const Point2Q& a, const Point2Q& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

template <class Item>
void make_set(std::vector<Item>& items) {
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

template <class Edge>
Rational height(const Edge& e, const Rational& x) {
  return e.low.y + (x - e.low.x) * (e.high.y - e.low.y) / (e.high.x - e.low.x);
}

// The x of the point that two edges share, if they share one and are not parallel.
template <class Edge>
std::optional<Rational> crossing(const Edge& e, const Edge& f) {
  const Rational ux = e.high.x - e.low.x;
  const Rational uy = e.high.y - e.low.y;
  const Rational vx = f.high.x - f.low.x;
  const Rational vy = f.high.y - f.low.y;
  const Rational det = ux * vy - uy * vx;
  if (det.sign() == 0) return std::nullopt;
  const Rational t = ((f.low.x - e.low.x) * vy - (f.low.y - e.low.y) * vx) / det;
  const Rational u = ((f.low.x - e.low.x) * uy - (f.low.y - e.low.y) * ux) / det;
  if (t < Rational(0) || Rational(1) < t || u < Rational(0) || Rational(1) < u) {
    return std::nullopt;
  }
  return e.low.x + t * ux;
}

}  // namespace

CellOverlay::CellOverlay(const Section& lower, const Nesting& lower_nesting, const Section& upper,
                         const Nesting& upper_nesting)
    : sections_{&lower, &upper} {
  collect(lower, 0);
  collect(upper, 1);
  cut();
  for (std::size_t slab = 0; slab <= xs_.size(); ++slab) fill(slab);
  for (std::size_t slab = 0; slab < xs_.size(); ++slab) join(slab);
  describe({&lower_nesting, &upper_nesting});
}

void CellOverlay::collect(const Section& section, std::size_t s) {
  for (const ContourId c : section.contours.ids()) {
    const std::vector<Point2>& vertices = section.contours[c].vertices;
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      Edge edge{exactly(vertices[v]), exactly(vertices[(v + 1) % vertices.size()]), s, c.index()};
      if (is_lower(edge.high, edge.low)) std::swap(edge.low, edge.high);
      (edge.low.x == edge.high.x ? vertical_ : edges_).push_back(edge);
    }
  }
}

void CellOverlay::cut() {
  for (const std::vector<Edge>* edges : {&edges_, &vertical_}) {
    for (const Edge& e : *edges) {
      xs_.push_back(e.low.x);
      xs_.push_back(e.high.x);
    }
  }
  for (const Edge& e : edges_) {
    for (const Edge& f : edges_) {
      if (e.section != 0 || f.section != 1) continue;
      if (const auto x = crossing(e, f)) xs_.push_back(*x);
    }
  }
  make_set(xs_);
}

void CellOverlay::fill(std::size_t slab) {
  std::vector<Cell> cells(1);
  if (slab > 0 && slab < xs_.size()) {
    const Rational middle = (xs_[slab - 1] + xs_[slab]) / Rational(2);
    std::map<Rational, std::vector<const Edge*>> lines;
    for (const Edge& e : edges_) {
      if (e.low.x < middle && middle < e.high.x) lines[height(e, middle)].push_back(&e);
    }
    for (const auto& line : lines) {
      cells.back().top = line.second;
      cells.emplace_back();
      cells.back().bottom = line.second;
    }
  }
  first_cell_.push_back(parent_.size());
  for (std::size_t k = 0; k < cells.size(); ++k) parent_.push_back(parent_.size());
  slabs_.push_back(std::move(cells));
}

std::size_t CellOverlay::root(std::size_t cell) const {
  while (parent_[cell] != cell) cell = parent_[cell];
  return cell;
}

// Glues the slab and the next one where the line between them is off all contours.
void CellOverlay::join(std::size_t slab) {
  const Rational& x = xs_[slab];
  std::vector<Rational> ys;
  for (const Edge& e : edges_) {
    if (e.low.x <= x && x <= e.high.x) ys.push_back(height(e, x));
  }
  for (const Edge& e : vertical_) {
    if (e.low.x == x) ys.insert(ys.end(), {e.low.y, e.high.y});
  }
  make_set(ys);
  // Stretch k is below ys[k], the last one above all.
  for (std::size_t k = 0; k <= ys.size(); ++k) {
    const Rational y = ys.empty()       ? Rational(0)
                       : k == 0         ? ys[0] - Rational(1)
                       : k == ys.size() ? ys[k - 1] + Rational(1)
                                        : (ys[k - 1] + ys[k]) / Rational(2);
    std::array<std::size_t, 2> sides{};
    for (std::size_t side = 0; side < 2; ++side) {
      const std::vector<Cell>& cells = slabs_[slab + side];
      std::size_t at = 0;
      while (!cells[at].top.empty() && height(*cells[at].top[0], x) < y) ++at;
      sides[side] = first_cell_[slab + side] + at;
    }
    bool closed = false;
    for (const Edge& e : vertical_) {
      if (e.low.x != x || !(e.low.y < y && y < e.high.y)) continue;
      closed = true;
      for (const std::size_t cell : sides) touches_.push_back({cell, &e});
    }
    if (closed) continue;
    openings_.push_back(sides[0]);
    parent_[root(sides[0])] = root(sides[1]);
  }
}

CellOverlay::Side CellOverlay::side_of(std::size_t slab, const Cell& cell, std::size_t s,
                                       const Nesting& nesting) const {
  // The deepest contour with an odd number of edges below the cell.
  std::vector<bool> odd(sections_[s]->contours.size(), false);
  for (const Cell& other : slabs_[slab]) {
    for (const Edge* e : other.bottom) {
      if (e->section == s) odd[e->contour] = !odd[e->contour];
    }
    if (&other == &cell) break;
  }
  std::optional<ContourId> deepest;
  for (std::size_t c = 0; c < odd.size(); ++c) {
    if (odd[c] && (!deepest || nesting.depth[*deepest] < nesting.depth[ContourId(c)])) {
      deepest = ContourId(c);
    }
  }
  if (!deepest) return {false, 0};
  if (nesting.depth[*deepest] % 2 == 0) return {true, nesting.region[*deepest].value()};
  const auto lowest = [&](ContourId c) {
    Point2Q low = exactly(sections_[s]->contours[c].vertices[0]);
    for (const Point2& p : sections_[s]->contours[c].vertices) {
      if (is_lower(exactly(p), low)) low = exactly(p);
    }
    return low;
  };
  std::uint32_t id = 1;
  for (const ContourId c : nesting.depth.ids()) {
    if (nesting.depth[c] % 2 == 1 && is_lower(lowest(c), lowest(*deepest))) ++id;
  }
  return {false, id};
}

void CellOverlay::describe(const std::array<const Nesting*, 2>& nestings) {
  std::map<std::size_t, std::size_t> face_of;  // by root
  const auto border = [&](std::size_t face, const Edge& e) {
    const RegionId region = nestings[e.section]->region[ContourId(e.contour)];
    faces_[face].border.push_back({e.section, region.value()});
  };
  for (std::size_t slab = 0; slab < slabs_.size(); ++slab) {
    for (std::size_t k = 0; k < slabs_[slab].size(); ++k) {
      Cell& cell = slabs_[slab][k];
      const auto entry = face_of.emplace(root(first_cell_[slab] + k), faces_.size());
      cell.face = entry.first->second;
      if (entry.second) {
        Face face;
        for (std::size_t s = 0; s < 2; ++s) face.side[s] = side_of(slab, cell, s, *nestings[s]);
        faces_.push_back(face);
      }
      ++faces_[cell.face].chi;
      for (const Edge* e : cell.bottom) border(cell.face, *e);
      for (const Edge* e : cell.top) border(cell.face, *e);
    }
  }
  for (const std::size_t cell : openings_) --faces_[face_of.at(root(cell))].chi;
  for (const Touch& touch : touches_) border(face_of.at(root(touch.cell)), *touch.edge);
  for (Face& face : faces_) make_set(face.border);
}

std::optional<std::size_t> CellOverlay::locate(const Point2& p) const {
  const Point2Q q = exactly(p);
  for (const Edge& e : edges_) {
    if (e.low.x <= q.x && q.x <= e.high.x && height(e, q.x) == q.y) return std::nullopt;
  }
  for (const Edge& e : vertical_) {
    if (e.low.x == q.x && e.low.y <= q.y && q.y <= e.high.y) return std::nullopt;
  }
  // Off all contours: between two slabs either one tells.
  std::size_t slab = 0;
  while (slab < xs_.size() && xs_[slab] < q.x) ++slab;
  const std::vector<Cell>& cells = slabs_[slab];
  std::size_t at = 0;
  while (!cells[at].top.empty() && height(*cells[at].top[0], q.x) < q.y) ++at;
  return cells[at].face;
}

}  // namespace tetloft::oracle
