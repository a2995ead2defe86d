#include "between/bridges.hpp"

#include <algorithm>
#include <limits>

#include "between/cheapest_paths.hpp"
#include "core/sort_distinct.hpp"

namespace tetloft::internal::between {

namespace {

constexpr double kBesidePath = 0.5;

// The samples of all layers, one layer after the other.
class Layered {
 public:
  Layered(const LayerGraph& solids, ForeignSamples& foreign, ClassShape& shape)
      : solids_(solids),
        foreign_(foreign),
        shape_(shape),
        nx_(shape.window.nx()),
        ny_(shape.window.ny()),
        samples_(shape.window.size()) {}

  // There may be more than places have numbers for.
  [[nodiscard]] bool has_places() const {
    return samples_ < std::numeric_limits<std::uint32_t>::max() / (layers() + 1);
  }

  // The samples of each connected set, without those on the border of the window.
  [[nodiscard]] std::vector<std::vector<std::uint32_t>> sets() const {
    const NodeNumbers numbers = connected(solids_);
    std::vector<std::size_t> all;
    for (const auto& layer : numbers) all.insert(all.end(), layer.begin(), layer.end());
    sort_distinct(all);
    std::vector<std::vector<std::uint32_t>> sets(all.size());
    for (std::size_t k = 0; k < layers(); ++k) {
      for (const auto& [first, end, node] : solids_.layers[k].runs) {
        const auto set = std::lower_bound(all.begin(), all.end(), numbers[k][node]);
        std::vector<std::uint32_t>& of_set = sets[static_cast<std::size_t>(set - all.begin())];
        for (std::size_t at = first; at < end; ++at) {
          if (!is_on_border(at)) of_set.push_back(static_cast<std::uint32_t>(k * samples_ + at));
        }
      }
    }
    return sets;
  }

  [[nodiscard]] double cost(std::uint32_t place) const {
    const std::size_t layer = place / samples_;
    const std::size_t at = place % samples_;
    if (is_given(layer) || !is_free(layer, at)) return kNever;
    const double out = std::max(shape_.value[layer][at], 0.0);
    return kStepCost + out * out;
  }

  [[nodiscard]] std::vector<SamplePath> paths() const {
    SampleSteps steps = straight_steps(shape_.window);
    steps.push_back(static_cast<std::int64_t>(samples_));
    steps.push_back(-static_cast<std::int64_t>(samples_));
    PathSearch search(layers() * samples_, steps, [&](std::uint32_t from, std::uint32_t to) {
      return !is_given(from / samples_) || to / samples_ != from / samples_;
    });
    return search.join(sets(), [&](std::uint32_t place) { return cost(place); });
  }

  // Makes the path inside; its ends are.
  void build(const SamplePath& path, std::vector<LayerTie>& ties) {
    for (std::size_t k = 0; k < path.size(); ++k) {
      const std::size_t layer = path[k] / samples_;
      const std::size_t at = path[k] % samples_;
      if (k > 0 && path[k - 1] / samples_ != layer) {
        ties.push_back({std::min(layer, path[k - 1] / samples_), static_cast<std::uint32_t>(at)});
      }
      if (k == 0 || k + 1 == path.size()) continue;
      std::vector<double>& value = shape_.value[layer];
      value[at] = std::min(value[at], kPathValue);
      for (const std::size_t beside : {at - 1, at + 1, at - nx_, at + nx_}) {
        if (is_free(layer, beside)) value[beside] = std::min(value[beside], kBesidePath);
      }
    }
  }

 private:
  [[nodiscard]] std::size_t layers() const { return solids_.layers.size(); }

  // Or beyond.
  [[nodiscard]] bool is_given(std::size_t layer) const {
    return layer == 0 || layer + 1 >= layers();
  }
  [[nodiscard]] bool is_on_border(std::size_t at) const {
    const std::size_t i = at % nx_;
    const std::size_t j = at / nx_;
    return i == 0 || j == 0 || i + 1 == nx_ || j + 1 == ny_;
  }
  [[nodiscard]] bool is_free(std::size_t layer, std::size_t at) const {
    return !is_on_border(at) && foreign_.in(layer)[at] == 0;
  }

  const LayerGraph& solids_;
  ForeignSamples& foreign_;
  ClassShape& shape_;
  std::size_t nx_, ny_, samples_;
};

}  // namespace

std::vector<LayerTie> bridge_parts(const LayerGraph& solids, ForeignSamples& foreign,
                                   ClassShape& shape) {
  std::vector<LayerTie> ties;
  Layered layered(solids, foreign, shape);
  if (!layered.has_places()) return ties;
  for (const SamplePath& path : layered.paths()) layered.build(path, ties);
  return ties;
}

}  // namespace tetloft::internal::between
