// The check of a solid in pieces says what check() says of the joined one: of right solids and of
// damaged ones, wherever they were cut.
#include <tetloft/pieces.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "core/prng.hpp"
#include "pieces/piece_file.hpp"
#include "support/slabs/cases.hpp"
#include "unit/pieces/pieces_support.hpp"

namespace tetloft::testing {
namespace {

using internal::Prng;
using internal::pieces::WholePiece;
using Cuts = std::vector<std::size_t>;
using Pieces = std::vector<WholePiece>;

void expect_same(const CheckReport& pieces, const CheckReport& whole, const std::string& what) {
  ASSERT_EQ(pieces.guarantees.size(), whole.guarantees.size());
  for (std::size_t g = 0; g < whole.guarantees.size(); ++g) {
    const GuaranteeVerdict& one = pieces.guarantees[g];
    const GuaranteeVerdict& other = whole.guarantees[g];
    EXPECT_EQ(one.number, other.number);
    EXPECT_EQ(one.name, other.name);
    EXPECT_EQ(one.pass, other.pass) << what << ", guarantee " << other.number;
    EXPECT_EQ(one.not_asked, other.not_asked) << what;
    ASSERT_EQ(one.failures.size(), other.failures.size()) << what << ", " << other.number;
    for (std::size_t f = 0; f < other.failures.size(); ++f) {
      EXPECT_EQ(one.failures[f].what, other.failures[f].what) << what;
      EXPECT_EQ(one.failures[f].count, other.failures[f].count)
          << what << ", " << other.failures[f].what;
      EXPECT_EQ(one.failures[f].places.size(), other.failures[f].places.size()) << what;
    }
  }
  EXPECT_EQ(pieces.components, whole.components) << what;
  EXPECT_EQ(pieces.genus, whole.genus) << what;
  EXPECT_NEAR(pieces.volume, whole.volume, 1e-12 * std::abs(whole.volume)) << what;
  EXPECT_EQ(pieces.overshoot, whole.overshoot) << what;
  EXPECT_EQ(pieces.smallest_dihedral_degrees, whole.smallest_dihedral_degrees) << what;
  EXPECT_EQ(pieces.largest_split_ulps, whole.largest_split_ulps) << what;
  EXPECT_EQ(pieces.inner_vertices, whole.inner_vertices) << what;
  EXPECT_EQ(pieces.dropped_links, whole.dropped_links) << what;
  EXPECT_EQ(pieces.cavities, whole.cavities) << what;
  EXPECT_EQ(pieces.expected_cavities, whole.expected_cavities) << what;
  EXPECT_EQ(pieces.least_genus, whole.least_genus) << what;
  EXPECT_EQ(pieces.most_genus, whole.most_genus) << what;
  EXPECT_EQ(pieces.deviations, whole.deviations) << what;
  EXPECT_EQ(pieces.forced_voids, whole.forced_voids) << what;
  EXPECT_EQ(pieces.unrealisable_voids, whole.unrealisable_voids) << what;
}

// A stack cut into pieces that are there to be damaged.
class CutStack {
 public:
  CutStack(const SectionStack& stack, const ReconstructOptions& options, const Cuts& cuts)
      : stack_(stack) {
    checking_.correspondence = options.correspondence;
    EXPECT_TRUE(write_plan(folder_ / "plan", stack, options).ok());
    std::vector<std::string> made;
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
      made.push_back(folder_ / ("cut" + std::to_string(k) + ".vtu"));
      EXPECT_TRUE(write_piece(made.back(), folder_ / "plan", cuts[k], cuts[k + 1]).ok());
    }
    JoinOptions joining;
    joining.plan = folder_ / "plan";
    const auto index = write_index(folder_ / "cut.pvtu", made, joining);
    EXPECT_TRUE(index.ok());
    for (const std::string& path : index->pieces) {
      pieces_.push_back(*internal::pieces::read_whole_piece(path));
      paths_.push_back(folder_ / ("piece" + std::to_string(paths_.size()) + ".vtu"));
    }
  }

  [[nodiscard]] const Pieces& pieces() const { return pieces_; }
  [[nodiscard]] const std::vector<std::string>& paths() const { return paths_; }
  [[nodiscard]] CheckOptions& options() { return checking_; }

  // Of these in their place. Returns whether the solid is right; nothing where it is none.
  std::optional<CheckReport> compare(const Pieces& pieces, const std::string& what) {
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      WholePiece piece = pieces[k];
      auto files = internal::pieces::stage_whole_piece(paths_[k], piece, Encoding::binary, nullptr);
      if (!files.ok()) return std::nullopt;  // no file can say so
      EXPECT_TRUE(internal::io::commit_all(files->files).ok());
    }
    const auto joined = join_pieces(paths_);
    const auto report = check_pieces(paths_, stack_, checking_);
    EXPECT_EQ(joined.ok(), report.ok())
        << what << (report.ok() ? to_string(joined.error()) : to_string(report.error()));
    if (!joined.ok() || !report.ok()) {
      if (!joined.ok() && !report.ok()) {
        EXPECT_EQ(to_string(joined.error()), to_string(report.error())) << what;
      }
      return std::nullopt;
    }
    const auto whole = check(joined->model, stack_, checking_);
    EXPECT_TRUE(whole.ok()) << what;
    expect_same(*report, *whole, what);
    return *whole;
  }

 private:
  Folder folder_;
  SectionStack stack_;
  CheckOptions checking_;
  Pieces pieces_;
  std::vector<std::string> paths_;
};

std::vector<Cuts> cuts_of(std::size_t slabs) {
  std::vector<Cuts> all{{0, slabs}};
  if (slabs > 1) all.push_back({0, 1, slabs});
  if (slabs > 2) all.push_back({0, slabs / 2, slabs - 1, slabs});
  Cuts each;
  for (std::size_t s = 0; s <= slabs; ++s) each.push_back(s);
  if (slabs > 3) all.push_back(each);
  return all;
}

void expect_right(const SectionStack& stack, const ReconstructOptions& options,
                  const std::string& name) {
  for (const Cuts& cuts : cuts_of(stack.sections.size() - 1)) {
    CutStack cut(stack, options, cuts);
    const auto report = cut.compare(cut.pieces(), name);
    ASSERT_TRUE(report) << name;
    EXPECT_TRUE(report->pass()) << name;
  }
}

TEST(CheckPieces, OfRightSolidsIsThatOfTheWhole) {
  for (const char* const name : {"torus.cnt", "bifurcation.cnt", "cases/nested_hole.cnt"}) {
    expect_right(sample(name), {}, name);
  }
  expect_right(sample("torus.cnt"), with_ends_between_and_label(), "labelled");
  const auto [stack, options] = stack_of_mends("x-xxx--x");
  expect_right(stack, options, "mends");
  SectionStack far = sample("torus.cnt");
  far.frame.origin = {1, 2, 3};
  expect_right(far, {}, "far");
  expect_right(stack_of_boxes({{box(0, 0, 4, 2)}}), {}, "one section");
}

// Vertices that two pieces share are the last of one and the first of the next.
bool is_seam_vertex(const Pieces& pieces, std::size_t k, VertexId v) {
  const SectionId s = pieces[k].model.section[v];
  const auto& slabs = pieces[k].record.slabs;
  return s.valid() &&
         ((k > 0 && s.index() == slabs.first) || (k + 1 < pieces.size() && s.index() == slabs.end));
}

// Moves a vertex wherever it is.
void move_vertex(Pieces& pieces, const Point3& from, const Point3& to) {
  for (WholePiece& piece : pieces) {
    for (Point3& p : piece.model.points) {
      if (p == from) p = to;
    }
  }
}

struct Damager {
  Pieces pieces;
  Prng prng;
  std::size_t k = 0;  // the piece to be damaged
  Model& model() { return pieces[k].model; }
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(prng.below(n)); }
  TetId some_tet() { return TetId(below(model().tets.size())); }
  VertexId some_vertex() { return VertexId(below(model().points.size())); }
  // Of a tet at the upper seam.
  TetId seam_tet() {
    for (std::size_t tries = 0; tries < 200; ++tries) {
      const TetId t = some_tet();
      for (const VertexId v : model().tets[t]) {
        if (is_seam_vertex(pieces, k, v)) return t;
      }
    }
    return some_tet();
  }
  VertexId seam_vertex() {
    for (const VertexId v : model().tets[seam_tet()]) {
      if (is_seam_vertex(pieces, k, v)) return v;
    }
    return some_vertex();
  }
};

void remove_tet(Model& model, TetId t) {
  const auto at = static_cast<std::ptrdiff_t>(t.index());
  model.tets.raw().erase(model.tets.begin() + at);
  model.component.raw().erase(model.component.begin() + at);
  model.slab.raw().erase(model.slab.begin() + at);
  model.kind.raw().erase(model.kind.begin() + at);
}

void double_tet(Model& model, TetId t) {
  const auto at = static_cast<std::ptrdiff_t>(t.index());
  const auto twice = [&](auto& of) { of.raw().insert(of.begin() + at, of[t]); };
  twice(model.tets);
  twice(model.component);
  twice(model.slab);
  twice(model.kind);
}

// A small one in the middle of it, which touches nothing.
void put_tet_inside(Model& model, TetId t) {
  const TetVertices outer = model.tets[t];
  Point3 middle{0, 0, 0};
  for (const VertexId v : outer) {
    const Point3& p = model.points[v];
    middle = {middle.x + p.x / 4, middle.y + p.y / 4, middle.z + p.z / 4};
  }
  TetVertices inner{};
  for (std::size_t i = 0; i < 4; ++i) {
    const Point3& p = model.points[outer[i]];
    inner[i] =
        model.points.push_back({middle.x + (p.x - middle.x) / 8, middle.y + (p.y - middle.y) / 8,
                                middle.z + (p.z - middle.z) / 8});
    model.section.push_back(SectionId());
    model.contour.push_back(ContourId());
    model.origin.push_back(PointOrigin::lifted);
  }
  double_tet(model, t);
  model.tets[t] = inner;
}

TEST(CheckPieces, TellsOfAllStepsAndEndsWhenItIsStopped) {
  Folder folder;
  const SectionStack stack = sample("torus.cnt");
  const std::vector<std::string> pieces{folder / "0.vtu", folder / "1.vtu"};
  ASSERT_TRUE(write_plan(folder / "plan", stack, {}).ok());
  ASSERT_TRUE(write_piece(pieces[0], folder / "plan", 0, 7).ok());
  ASSERT_TRUE(write_piece(pieces[1], folder / "plan", 7, 19).ok());
  std::size_t told = 0;
  std::size_t steps = 0;
  CheckOptions options;
  options.execution.progress = [&](std::size_t done, std::size_t all) {
    EXPECT_EQ(done, ++told);
    steps = all;
  };
  ASSERT_TRUE(check_pieces(pieces, stack, options).ok());
  EXPECT_EQ(told, steps);
  EXPECT_EQ(steps, 2 * pieces.size() + 3);  // each is read twice
  for (std::size_t last = 1; last < steps; ++last) {
    std::stop_source source;
    told = 0;
    options.execution.stop = source.get_token();
    options.execution.progress = [&](std::size_t done, std::size_t) {
      told = done;
      if (done == last) source.request_stop();
    };
    const auto stopped = check_pieces(pieces, stack, options);
    ASSERT_FALSE(stopped.ok());
    EXPECT_EQ(stopped.error().code, ErrorCode::cancelled);
    EXPECT_EQ(told, last);
  }
}

struct Damage {
  const char* name;
  void (*make)(Damager&);
};

const std::vector<Damage> kDamages{
    {"a vertex moved a little",
     [](Damager& d) {
       const Point3 p = d.model().points[d.some_vertex()];
       move_vertex(d.pieces, p, {p.x + 0.25, p.y, p.z});
     }},
    {"a vertex moved far away",
     [](Damager& d) {
       const Point3 p = d.model().points[d.some_vertex()];
       move_vertex(d.pieces, p, {p.x, p.y + 100, p.z});
     }},
    {"a vertex moved up and down",
     [](Damager& d) {
       const Point3 p = d.model().points[d.some_vertex()];
       move_vertex(d.pieces, p, {p.x, p.y, p.z + (static_cast<double>(d.below(7)) - 3) / 2});
     }},
    {"a seam's vertex moved out of its plane",
     [](Damager& d) {
       const Point3 p = d.model().points[d.seam_vertex()];
       move_vertex(d.pieces, p, {p.x, p.y, std::nextafter(p.z, p.z + 1)});
     }},
    {"a seam's vertex moved in its plane",
     [](Damager& d) {
       const Point3 p = d.model().points[d.seam_vertex()];
       move_vertex(d.pieces, p, {p.x + 0.5, p.y - 0.75, p.z});
     }},
    {"a vertex put upon another",
     [](Damager& d) {
       const Point3 p = d.model().points[d.some_vertex()];
       move_vertex(d.pieces, p, d.model().points[d.some_vertex()]);
     }},
    {"a seam moved in one piece only",
     [](Damager& d) { d.model().points[d.seam_vertex()].x += 1; }},
    {"a tet removed", [](Damager& d) { remove_tet(d.model(), d.some_tet()); }},
    {"a tet at a seam removed", [](Damager& d) { remove_tet(d.model(), d.seam_tet()); }},
    {"the tets of a seam's vertex removed",
     [](Damager& d) {
       const VertexId v = d.seam_vertex();
       for (std::size_t t = d.model().tets.size(); t-- > 0;) {
         const TetVertices& tet = d.model().tets[TetId(t)];
         if (std::find(tet.begin(), tet.end(), v) != tet.end()) remove_tet(d.model(), TetId(t));
       }
     }},
    {"a slab removed",
     [](Damager& d) {
       const SlabId slab = d.model().slab[d.some_tet()];
       for (std::size_t t = d.model().tets.size(); t-- > 0;) {
         if (d.model().slab[TetId(t)] == slab) remove_tet(d.model(), TetId(t));
       }
     }},
    {"a tet flipped",
     [](Damager& d) {
       TetVertices& tet = d.model().tets[d.some_tet()];
       std::swap(tet[0], tet[1]);
     }},
    {"a tet at a seam flipped",
     [](Damager& d) {
       TetVertices& tet = d.model().tets[d.seam_tet()];
       std::swap(tet[2], tet[3]);
     }},
    {"a tet doubled", [](Damager& d) { double_tet(d.model(), d.some_tet()); }},
    {"a tet at a seam doubled", [](Damager& d) { double_tet(d.model(), d.seam_tet()); }},
    {"a tet inside another", [](Damager& d) { put_tet_inside(d.model(), d.some_tet()); }},
    {"a tet with another vertex",
     [](Damager& d) { d.model().tets[d.some_tet()][d.below(4)] = d.some_vertex(); }},
    {"a tet at a seam with another vertex",
     [](Damager& d) { d.model().tets[d.seam_tet()][d.below(4)] = d.seam_vertex(); }},
    {"two vertices made one",
     [](Damager& d) {
       const VertexId from = d.some_vertex();
       const VertexId to = d.some_vertex();
       for (TetVertices& tet : d.model().tets) std::replace(tet.begin(), tet.end(), from, to);
     }},
    {"a component's number changed",
     [](Damager& d) {
       auto& of = d.model().component[d.some_tet()];
       of = ComponentId(d.below(d.model().component_count));
     }},
    {"a slab's number changed",
     [](Damager& d) { d.model().slab[d.some_tet()] = SlabId(d.below(20)); }},
    {"a link and a motion forgotten",
     [](Damager& d) {
       if (!d.model().links.empty()) d.model().links.pop_back();
       if (!d.model().motions.empty()) d.model().motions.pop_back();
     }},
    {"a deviation that is none",
     [](Damager& d) {
       d.model().deviations.push_back({d.model().slab[TetId(0)], false, ContourId(0), 1, 1, 0});
     }},
    {"a coordinate that is none",
     [](Damager& d) { d.model().points[d.some_vertex()].y = std::nan(""); }},
    {"the solids of pieces exchanged",
     [](Damager& d) {
       std::swap(d.pieces.front().model, d.pieces[d.pieces.size() - 1 - d.k / 2].model);
     }},
    {"a section's number changed",
     [](Damager& d) {
       const VertexId v = d.some_vertex();
       if (d.model().section[v].valid()) d.model().section[v] = SectionId();
     }},
};

void damage(const SectionStack& stack, const ReconstructOptions& options, const Cuts& cuts,
            std::uint64_t seed, std::map<std::string, std::size_t>& failed) {
  CutStack cut(stack, options, cuts);
  for (const Damage& one : kDamages) {
    Damager damager{cut.pieces(), Prng(seed)};
    damager.k = damager.below(damager.pieces.size());
    one.make(damager);
    const auto report =
        cut.compare(damager.pieces, std::string(one.name) + ", seed " + std::to_string(seed));
    if (report && !report->pass()) ++failed[one.name];
    if (::testing::Test::HasFailure()) return;
  }
}

TEST(CheckPieces, OfDamagedSolidsIsThatOfTheWhole) {
  std::map<std::string, std::size_t> failed;
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    damage(sample("torus.cnt"), {}, {0, 7, 8, 9, 19}, seed, failed);
    damage(sample("torus.cnt"), with_ends_between_and_label(), {0, 1, 12, 19}, seed, failed);
    damage(stack_of_boxes({{box(0, 0, 4, 2)}, {box(0, 0, 4, 2)}, {box(0, 0, 4, 2)}}), {}, {0, 1, 2},
           seed, failed);
  }
  EXPECT_GT(failed.size(), 12U);
}

}  // namespace
}  // namespace tetloft::testing
