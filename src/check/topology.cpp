#include "check/topology.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "core/sort_distinct.hpp"
#include "core/union_find.hpp"

namespace tetloft::internal::checking {

namespace {

// None of a tet that lies in a plane.
std::optional<std::int64_t> slab_of(const ModelView& view, const TetVertices& tet) {
  Level low = view.level[tet[0].index()];
  Level high = low;
  for (const VertexId v : tet) {
    low = std::min(low, view.level[v.index()]);
    high = std::max(high, view.level[v.index()]);
  }
  if (low == high && on_plane(low)) return std::nullopt;
  return low < 0 ? -1 : low / 2;
}

// Some tets of a model, that hang together by faces where they do so at all.
class PartCount {
 public:
  void add(const TetVertices& tet) {
    ++tets_;
    for (std::size_t i = 0; i < 4; ++i) {
      vertices_.push_back(tet[i].value());
      for (std::size_t j = i + 1; j < 4; ++j) {
        const std::uint64_t low = std::min(tet[i].value(), tet[j].value());
        const std::uint64_t high = std::max(tet[i].value(), tet[j].value());
        edges_.push_back(low << 32U | high);
      }
    }
  }
  // A face of one of them and another.
  void add_inner_half_face() { ++inner_half_faces_; }

  [[nodiscard]] long chi() {
    sort_distinct(vertices_);
    sort_distinct(edges_);
    return static_cast<long>(vertices_.size()) - static_cast<long>(edges_.size()) + 4 * tets_ -
           inner_half_faces_ / 2 - tets_;
  }

 private:
  std::vector<std::uint32_t> vertices_;
  std::vector<std::uint64_t> edges_;
  long tets_ = 0;
  long inner_half_faces_ = 0;
};

}  // namespace

SlabParts slab_parts(const ModelView& view) {
  std::vector<std::optional<std::int64_t>> slab;
  for (const TetVertices& tet : view.tets) slab.push_back(slab_of(view, tet));
  const auto across = [&](std::size_t half_face) -> std::optional<std::size_t> {
    const HalfFaceId opposite = view.opposite[half_face];
    if (!opposite.valid() || slab[opposite.index() / 4] != slab[half_face / 4]) return std::nullopt;
    return opposite.index() / 4;
  };
  UnionFind together(view.tets.size());
  std::vector<std::size_t> tets;
  for (std::size_t t = 0; t < view.tets.size(); ++t) {
    if (!slab[t].has_value()) continue;
    tets.push_back(t);
    for (std::size_t i = 0; i < 4; ++i) {
      if (const auto other = across(4 * t + i)) together.unite(t, *other);
    }
  }
  const auto key = [&](std::size_t t) { return std::pair(*slab[t], together.find(t)); };
  std::stable_sort(tets.begin(), tets.end(),
                   [&](std::size_t a, std::size_t b) { return key(a) < key(b); });

  SlabParts result;
  result.part_of.assign(view.tets.size(), SlabParts::kNone);
  for (auto part = tets.begin(); part != tets.end();) {
    const auto number = static_cast<std::uint32_t>(result.parts.size());
    SlabPart& made = result.parts.emplace_back();
    made.slab = *slab[*part];
    made.first = view.id[*part];
    PartCount count;
    const std::size_t root = together.find(*part);
    for (; part != tets.end() && together.find(*part) == root; ++part) {
      count.add(view.tets[*part]);
      for (std::size_t i = 0; i < 4; ++i) {
        if (across(4 * *part + i).has_value()) count.add_inner_half_face();
      }
      result.part_of[*part] = number;
    }
    made.chi = count.chi();
  }
  return result;
}

void add_regions(const ModelView& view, const OnContours& on,
                 std::span<const std::uint32_t> part_of, std::span<const std::size_t> region_at,
                 std::vector<SlabPart>& parts) {
  for (const auto& [part, region] : on.bounds_met(view.tets, part_of, region_at)) {
    parts[part].regions.push_back(region);
  }
}

std::vector<std::size_t> bounded_by(const SectionStack& stack, const Regions& regions) {
  std::vector<std::size_t> result;
  for (std::size_t s = 0; s < stack.sections.size(); ++s) {
    const std::size_t contours = stack.sections[SectionId(s)].contours.size();
    for (std::size_t c = 0; c < contours; ++c) result.push_back(regions.of(s, c));
  }
  return result;
}

ModelVoids model_voids(std::span<const BoundarySurface> surfaces, const Regions& voids) {
  // Voids first, then surfaces.
  UnionFind joined(voids.size() + surfaces.size());
  for (std::size_t s = 0; s < voids.section_count(); ++s) joined.unite(0, voids.first[s]);
  ModelVoids result;
  for (std::size_t k = 0; k < surfaces.size(); ++k) {
    for (const std::size_t v : surfaces[k].bounds) joined.unite(v, voids.size() + k);
    if (surfaces[k].bounds.empty()) result.bubbles.push_back(surfaces[k].first);
  }
  for (std::size_t v = 0; v < voids.size(); ++v) result.set.push_back(joined.find(v));
  for (std::size_t i = 1; i < joined.size(); ++i) {
    if (joined.find(i) == i) ++result.cavities;
  }
  return result;
}

}  // namespace tetloft::internal::checking
