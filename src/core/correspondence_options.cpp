// What the options of correspondence mean, and what its values are called.
#include <tetloft/correspondence.hpp>

namespace tetloft {

double threshold_of(const CorrespondenceOptions& options) {
  return options.tau.value_or(options.criterion == Criterion::moved ? kDefaultMoved
                                                                    : kDefaultOverlap);
}

const char* name_of(Evidence evidence) {
  switch (evidence) {
    case Evidence::overlap: return "overlap";
    case Evidence::reverse: return "reverse";
    case Evidence::motion: return "motion";
    case Evidence::chain: return "chain";
    case Evidence::lone: return "lone";
    case Evidence::label: return "label";
    case Evidence::decision: return "decision";
    case Evidence::rim: return "rim";
  }
  return "none";
}

const char* name_of(LinkFate fate) {
  switch (fate) {
    case LinkFate::made: return "made";
    case LinkFate::too_weak: return "too weak";
    case LinkFate::outruled: return "outruled";
    case LinkFate::labels_part: return "parted by labels";
    case LinkFate::decided_part: return "parted by decision";
    case LinkFate::unrealisable: return "unrealisable";
    case LinkFate::forced: return "forced";
  }
  return "none";
}

}  // namespace tetloft
