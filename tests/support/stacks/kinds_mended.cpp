// Stacks that came broken, mended.
#include "support/stacks/broken.hpp"
#include "support/stacks/kinds.hpp"

namespace tetloft::testing {

SectionStack draft_mended_overlaps(Prng& prng) {
  return mended(draft_broken(BrokenKind::overlaps, prng));
}
SectionStack draft_mended_copies(Prng& prng) {
  return mended(draft_broken(BrokenKind::copies, prng));
}
SectionStack draft_mended_keyholes(Prng& prng) {
  return mended(draft_broken(BrokenKind::keyholes, prng));
}
SectionStack draft_arranged_planes(Prng& prng) {
  return mended(draft_broken(BrokenKind::planes, prng));
}

}  // namespace tetloft::testing
