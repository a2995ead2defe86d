// Stacks that need mending: the options for their planes and contours, and what was done by them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <tetloft/tetloft.hpp>

#include "cli/arguments.hpp"
#include "cli/console.hpp"
#include "cli/json.hpp"

namespace tetloft::cli {

/// --planes, --repair, --repair-distance, --fill, --keyholes.
[[nodiscard]] std::vector<Option> mending_options();

struct Mending {
  std::optional<PlaneOptions> planes;
  std::optional<RepairOptions> repair;

  [[nodiscard]] bool any() const { return planes || repair; }
};

/// These as given; --fill and --keyholes imply --repair.
[[nodiscard]] Result<Mending> mending_of(const Arguments& arguments);

struct PlanesReport {
  std::size_t sections_before = 0;
  std::size_t sections_after = 0;
};

struct RepairReport {
  FillRule fill = FillRule::odd;
  std::size_t changes = 0;  ///< each told as a warning
  double moved = 0;         ///< how far the boundary moved at most
  double area_before = 0;
  double area_after = 0;
  std::size_t copies = 0;
  std::size_t channels = 0;
  std::vector<LostBody> lost;
};

struct MendedStack {
  SectionStack stack;
  std::optional<PlanesReport> planes;
  std::optional<RepairReport> repair;
};

/// Warns of what the reader warned of, with the option that may help; but not of gaps between
/// planes that are to be arranged.
void warn_of_reader(const std::vector<Warning>& warnings, const Mending& mending, Console& console);

/// What was read from `path`, unchecked, mended; valid, unless nothing is left. Changes are told as
/// warnings.
[[nodiscard]] Result<MendedStack> mend_read(const ReadStack& read, const std::string& path,
                                            const Mending& mending, Console& console);

/// An error of a reader, with the option that may help.
[[nodiscard]] Error with_remedy(Error error);

/// Members "planes" and "repair", where that was done.
void write_mending(JsonWriter& json, const std::optional<PlanesReport>& planes,
                   const std::optional<RepairReport>& repair);
/// The same as lines of text.
[[nodiscard]] std::string describe_mending(const std::optional<PlanesReport>& planes,
                                           const std::optional<RepairReport>& repair);

}  // namespace tetloft::cli
