// How links between regions are told: in lines that --labels takes back, in JSON, in a sentence.
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
  std::vector<Label> labels;  ///< the user's
  StackLinks links;
  /// How many links are listed, of the least sure, beside those that the user decided; none: all.
  std::optional<std::size_t> first;
};

/// A file of labels, its header and counts in comments, these only where `told`: the user's
/// labels, then "join" or "part" of each link, least sure first. Read back as --labels it decides
/// what was decided before.
[[nodiscard]] std::string link_lines(const LinkListing& listing, bool told);

/// The value of all links: an array of objects, in their order.
void write_links(JsonWriter& json, const std::vector<RegionLink>& links);
/// Members "made" (by evidence) and "not_made" (by fate): how many.
void write_link_counts(JsonWriter& json, const std::vector<RegionLink>& links);
/// A member "links": the counts, and the few least sure of those made, and those nearly.
void write_link_summary(JsonWriter& json, const std::vector<RegionLink>& links);

/// Counts, and the least sure link, in two lines of text; nothing where there are no links.
[[nodiscard]] std::string describe_links(const std::vector<RegionLink>& links);
/// The counts alone: "12 made (10 by overlap, 2 by chain); 3 nearly (3 too weak)".
[[nodiscard]] std::string counted_links(const std::vector<RegionLink>& links);

}  // namespace tetloft::cli
