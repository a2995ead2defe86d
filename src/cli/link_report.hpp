// How links between regions, and between voids, are told: in lines that --labels takes back, in
// JSON, in a sentence.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <tetloft/tetloft.hpp>

#include "cli/json.hpp"

namespace tetloft::cli {

/// What the listing of a stack's links is made of.
struct LinkListing {
  std::size_t sections = 0;
  std::vector<Label> labels;       ///< the user's
  std::vector<Label> hole_labels;  ///< his, too
  StackLinks links;
  /// How many links of regions are listed, and how many of voids, of the least sure, beside those
  /// that the user decided; none: all.
  std::optional<std::size_t> first;
};

/// A file of labels, its header and counts in comments, these only where `told`: the user's
/// labels, then "join" or "part" of each link, least sure first; then the same of voids, "open" or
/// "close". Read back as --labels it decides what was decided before.
[[nodiscard]] std::string link_lines(const LinkListing& listing, bool told);

/// Members "made" (by evidence) and "not_made" (by fate): how many; "links": an array of objects;
/// "least_sure": positions in it. And "voids": "cavities" and the same of these.
void write_links(JsonWriter& json, const LinkListing& listing);
/// Members "links" and "void_links": the counts, and the few least sure of those made, and those
/// nearly.
void write_link_summary(JsonWriter& json, const Model& model);

/// Counts, and the least sure link, in a line of text for regions and one for voids; nothing where
/// there are no links.
[[nodiscard]] std::string describe_links(const std::vector<RegionLink>& links,
                                         const std::vector<VoidLink>& voids);

}  // namespace tetloft::cli
