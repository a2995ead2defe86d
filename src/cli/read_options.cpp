// Options of reading.
#include "cli/read_options.hpp"

#include "cli/engine_option.hpp"
#include "cli/file_formats.hpp"
#include "core/option_rules.hpp"
#include "io/numbers.hpp"

namespace tetloft::cli {

using namespace internal;

std::vector<Option> read_option_list() {
  return {
      format_option("--format", input_word("IN", Contents::stack), Contents::stack),
      {"--roi", "NAME",
       "of a file with several structures (ROIs, objects) the one of this name or number; tetloft "
       "info lists them"},
      {"--label", "NAME",
       "of a label volume, or contours with labels, the label of this value or name"},
      {"--iso", "VALUE", "of a volume the region where its values are at least this"},
      {"--contours",
       "WAY",
       "of a volume: sub-pixel (default: between the middles of voxels) or lattice (along their "
       "faces)",
       {},
       {"sub-pixel", "lattice"}},
      {"--axis",
       "AXIS",
       "of a volume the index axis across which sections are taken: i, j or k (default)",
       {},
       {"i", "j", "k"}},
      {"--property", "NAME", "of GeoJSON the property that is the height (default: it is found)"},
      {"--plane-tolerance", "D",
       "contours whose heights differ by at most this are one section (default: a hundredth of the "
       "usual gap); not of formats whose sections have one height, as .cnt"},
      {"--close-on-frame", "",
       "close open lines that end at the rectangle around all lines along it: level lines that "
       "were cut off at the edge of a map"},
  };
}

Result<ReadOptions> read_options(const Arguments& arguments) {
  ReadOptions options;
  auto format = chosen_format(arguments, "--format", Contents::stack);
  if (!format) return format.error();
  options.format = *std::move(format);
  if (arguments.has("--roi") && arguments.has("--label")) {
    return usage_error("--roi and --label both choose what is read; give one of them");
  }
  for (const char* name : {"--roi", "--label"}) {
    if (const auto given = arguments.text(name)) {
      if (given->empty()) return usage_error(std::string("option ") + name + " needs a name");
      options.structure = *given;
    }
  }
  options.property = arguments.text("--property").value_or("");
  const auto iso = arguments.number("--iso");
  if (!iso) return iso.error();
  options.iso = *iso;
  if (options.iso && arguments.has("--label")) {
    return usage_error("--iso and --label both choose what is read; give one of them");
  }
  const auto contours = arguments.choice("--contours");
  if (!contours) return contours.error();
  if (contours->has_value()) options.contours = static_cast<VolumeContours>(**contours);
  const auto axis = arguments.choice("--axis");
  if (!axis) return axis.error();
  if (axis->has_value()) options.axis = static_cast<int>(**axis);
  const auto tolerance = arguments.number("--plane-tolerance");
  if (!tolerance) return tolerance.error();
  if (tolerance->has_value() && !is_length(**tolerance)) {
    return usage_error("option --plane-tolerance: " +
                       io::in_quotes(*arguments.text("--plane-tolerance")) + " is not above 0");
  }
  options.plane_tolerance = *tolerance;
  const auto threads = threads_option(arguments);
  if (!threads) return threads.error();
  options.execution.threads = *threads;
  options.close_on_frame = arguments.has("--close-on-frame");
  return options;
}

std::string input_path(const std::string& operand) {
  return operand == "-" ? "/dev/stdin" : operand;
}

}  // namespace tetloft::cli
