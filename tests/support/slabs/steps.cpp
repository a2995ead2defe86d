#include "support/slabs/steps.hpp"

#include <utility>

namespace tetloft::testing {

Completed complete(const SlabCase& c, bool lone_too) {
  Completed result;
  result.active = c.active(lone_too);
  result.seed = seed(*c.slab, *c.classes, result.active, result.rules);
  Completion completion(*c.slab, *c.classes, result.active, result.seed, result.rules);
  result.apart = completion.run();
  result.complex = completion.complex();
  return result;
}

Subdivided subdivide_case(const SlabCase& c) {
  Completed completed = complete(c, true);
  Subdivided result;
  result.rules = completed.rules;
  result.complex = std::move(completed.complex);
  result.subdivision = subdivide(*c.slab, *c.classes, result.complex, result.rules);
  return result;
}

}  // namespace tetloft::testing
