#include "reconstruct/decide_between.hpp"

#include <utility>

#include "between/sections_between.hpp"
#include "reconstruct/stack_errors.hpp"

namespace tetloft::internal {

namespace {

// A window and the sections beyond it, as a stack of its own.
class WindowAndBeyond {
 public:
  WindowAndBeyond(const PreparedStack& window, const Plan& plan)
      : first_(window.beyond_below ? 1 : 0) {
    if (window.beyond_below) {
      add(window.beyond_below->section, window.beyond_below->nesting);
      add(window.beyond_below->links);
    }
    for (const SectionId s : window.nestings.ids()) {
      add(window.stack.sections[s], window.nestings[s]);
    }
    for (const std::vector<Link>& links : plan.correspondence.links) add(links);
    if (window.beyond_above) {
      add(window.beyond_above->section, window.beyond_above->nesting);
      add(window.beyond_above->links);
    }
  }

  [[nodiscard]] LinkedStack linked() const { return {stack_, nestings_, links_}; }
  // A slab of the window.
  [[nodiscard]] SlabId here(SlabId slab) const { return SlabId(slab.index() + first_); }

 private:
  void add(const Section& section, const Nesting& nesting) {
    stack_.sections.push_back(section);
    nestings_.push_back(nesting);
  }
  void add(std::vector<Link> links) {
    const SlabId slab(links_.size());
    for (Link& link : links) link.slab = slab;
    links_.push_back(std::move(links));
  }

  std::size_t first_;
  SectionStack stack_;
  IdVector<SectionId, Nesting> nestings_;
  IdVector<SlabId, std::vector<Link>> links_;
};

}  // namespace

std::optional<Error> decide_between(const PreparedStack& prepared,
                                    const ReconstructOptions& options,
                                    const std::vector<SlabId>& slabs, const WatchedWork& work,
                                    Plan& plan) {
  plan.between.resize(prepared.slab_count());
  if (options.between == 0) return std::nullopt;
  const auto in_each = [&](const LinkedStack& linked, const auto& there) {
    return first_error(
        slabs, options.execution.threads, work, [&](SlabId slab) -> std::optional<Error> {
          plan.between[slab] = sections_between(linked, there(slab), options.between);
          return std::nullopt;
        });
  };
  if (!prepared.beyond_below && !prepared.beyond_above) {
    return in_each({prepared.stack, prepared.nestings, plan.correspondence.links},
                   [](SlabId slab) { return slab; });
  }
  const WindowAndBeyond all(prepared, plan);
  return in_each(all.linked(), [&](SlabId slab) { return all.here(slab); });
}

}  // namespace tetloft::internal
