// See shares.hpp.
#include "delaunay3/shares.hpp"

#include <utility>

#include "core/parallel.hpp"
#include "delaunay3/stretches.hpp"

namespace tetloft::internal::delaunay3_detail {

namespace {

constexpr std::size_t kVerticesOfStretch = std::size_t{1} << 14;
constexpr std::size_t kMostVertexStretches = 256;

}  // namespace

Shares::Shares(GrowingTets& tets, std::size_t end, std::span<const VertexId> vertices,
               const Partition& partition, unsigned threads)
    : shared_(vertices.size()) {
  const Stretches all = Stretches::of(end, kVerticesOfStretch, kMostVertexStretches);
  parallel_for(all.count, threads, [&](std::size_t k) {
    for (std::size_t i = all.begin(k); i < all.end(k); ++i) {
      GrowingTets::Vertex& vertex = tets.vertex(VertexId(static_cast<std::uint32_t>(i)));
      vertex.part = static_cast<Part>(partition.part_of(vertex.point));
    }
  });
  const std::size_t parts = partition.parts();
  const Stretches some = Stretches::of(vertices.size(), kVerticesOfStretch, kMostVertexStretches);
  // [stretch * parts + part]: the number of vertices, then where the next goes.
  std::vector<std::size_t> place(some.count * parts);
  parallel_for(some.count, threads, [&](std::size_t k) {
    for (std::size_t i = some.begin(k); i < some.end(k); ++i) {
      ++place[k * parts + tets.vertex(vertices[i]).part];
    }
  });
  std::size_t sum = 0;
  for (std::size_t part = 0; part < parts; ++part) {
    begin_.push_back(sum);
    for (std::size_t k = 0; k < some.count; ++k) sum += std::exchange(place[k * parts + part], sum);
  }
  begin_.push_back(sum);
  parallel_for(some.count, threads, [&](std::size_t k) {
    for (std::size_t i = some.begin(k); i < some.end(k); ++i) {
      shared_[place[k * parts + tets.vertex(vertices[i]).part]++] = vertices[i];
    }
  });
}

}  // namespace tetloft::internal::delaunay3_detail
