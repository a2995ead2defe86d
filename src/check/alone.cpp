#include "check/alone.hpp"

#include "check/embedded.hpp"
#include "check/findings.hpp"
#include "check/manifold.hpp"

namespace tetloft::internal::checking {

std::vector<GuaranteeVerdict> check_alone(const ModelView& view, const SurfaceComponents& surface,
                                          const CheckOptions& options) {
  const auto unasked = [](int number, const char* name) {
    return Findings(number, name, 0).not_asked("no stack was given", false);
  };
  return {check_manifold(view, options).verdict(), unasked(2, "re-sampling"),
          check_embedded(view, surface, options).verdict(), unasked(4, "components"),
          unasked(5, "cavities and tunnels")};
}

}  // namespace tetloft::internal::checking
