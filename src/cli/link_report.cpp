// See link_report.hpp.
#include "cli/link_report.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>

#include "cli/console.hpp"

namespace tetloft::cli {

namespace {

struct LinkCounts {
  std::array<std::size_t, kEvidences> made{};
  std::array<std::size_t, kLinkFates> not_made{};
  std::size_t all_made = 0;
  std::size_t all_not_made = 0;

  void add(const RegionLink& link) {
    if (link.fate == LinkFate::made) {
      ++made[static_cast<std::size_t>(link.evidence)];
      ++all_made;
    } else {
      ++not_made[static_cast<std::size_t>(link.fate)];
      ++all_not_made;
    }
  }
};

LinkCounts counts_of(const std::vector<RegionLink>& links) {
  LinkCounts counts;
  for (const RegionLink& link : links) counts.add(link);
  return counts;
}

std::string text_of(const LinkCounts& counts) {
  std::string made;
  for (std::size_t e = 0; e < counts.made.size(); ++e) {
    if (counts.made[e] == 0) continue;
    made += (made.empty() ? "" : ", ") + std::to_string(counts.made[e]) + " by " +
            name_of(static_cast<Evidence>(e));
  }
  std::string nearly;
  for (std::size_t f = 0; f < counts.not_made.size(); ++f) {
    if (counts.not_made[f] == 0) continue;
    nearly += (nearly.empty() ? "" : ", ") + std::to_string(counts.not_made[f]) + ' ' +
              name_of(static_cast<LinkFate>(f));
  }
  const auto part = [](std::size_t n, const char* what, const std::string& details) {
    return std::to_string(n) + ' ' + what + (details.empty() ? "" : " (" + details + ')');
  };
  return part(counts.all_made, "made", made) + "; " + part(counts.all_not_made, "nearly", nearly);
}

// Names as keys and values of JSON: one word.
std::string json_name(const char* name) {
  std::string word = name;
  std::replace(word.begin(), word.end(), ' ', '_');
  return word;
}

std::string three_digits(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.3g", value);
  return buffer;
}

// Behind the # of a line.
std::string measures(const RegionLink& link) {
  std::string text = name_of(link.evidence);
  if (link.fate != LinkFate::made) text += std::string(", ") + name_of(link.fate);
  text += ": ratio " + three_digits(link.ratio) + ", moved " + three_digits(link.moved) +
          ", distance " + three_digits(link.distance) + ", margin " + three_digits(link.margin);
  if (link.lead) text += ", lead " + three_digits(*link.lead);
  return text;
}

void append_decision(std::string& text, const RegionLink& link) {
  text += link.fate == LinkFate::made ? "join " : "part ";
  text += std::to_string(link.slab.index()) + ' ' + std::to_string(link.lower.index()) + ' ' +
          std::to_string(link.upper.index());
}

bool is_decided(const RegionLink& link) {
  return link.evidence == Evidence::decision || link.fate == LinkFate::decided_part;
}

// Those that are listed.
std::vector<RegionLink> listed(const LinkListing& listing) {
  std::vector<RegionLink> links = least_sure_first(listing.links.links);
  if (!listing.first) return links;
  std::size_t left = *listing.first;
  const auto is_left_out = [&left](const RegionLink& link) {
    if (is_decided(link)) return false;
    if (left == 0) return true;
    --left;
    return false;
  };
  // A loop, for erase_if may ask in any order.
  std::vector<RegionLink> kept;
  for (const RegionLink& link : links) {
    if (!is_left_out(link)) kept.push_back(link);
  }
  return kept;
}

std::string header(const LinkListing& listing, std::size_t lines) {
  const auto& links = listing.links.links;
  std::string text =
      "# What belongs together, least sure first. A line \"join S C D\" or \"part S C D\" says "
      "that\n"
      "# contour C of section S and contour D of section S+1 (outer ones of two regions) are, or "
      "are\n"
      "# not, linked directly. To decide otherwise write join for part or part for join, and give\n"
      "# this file, or the changed lines alone, to reconstruct, check or links as --labels FILE.\n"
      "# Behind the #: the evidence and, if not linked, why; overlap ratio of the regions, as they "
      "lie\n"
      "# and moved; their distance in gaps; by what margin it was decided; lead over the best "
      "rival.\n";
  text += "# " + counted(listing.sections, "section") + ", " +
          counted(listing.links.components, "component") + ", links: " + text_of(counts_of(links)) +
          '\n';
  if (lines < links.size()) {
    text += "# listed: " + std::to_string(lines) + " of " + std::to_string(links.size()) + '\n';
  }
  return text;
}

std::string slab_counts(const LinkListing& listing) {
  std::vector<LinkCounts> slabs(listing.sections == 0 ? 0 : listing.sections - 1);
  for (const RegionLink& link : listing.links.links) slabs[link.slab.index()].add(link);
  std::string text = "# By slab, between sections S and S+1:\n";
  for (std::size_t k = 0, end = 0; k < slabs.size(); k = end) {
    const std::string counts = text_of(slabs[k]);
    for (end = k + 1; end < slabs.size() && text_of(slabs[end]) == counts;) ++end;
    text += "# S " + std::to_string(k) + (end == k + 1 ? "" : " to " + std::to_string(end - 1)) +
            ": " + counts + '\n';
  }
  return text;
}

void write_link(JsonWriter& json, const RegionLink& link) {
  json.begin_object();
  json.member("slab", link.slab.index());
  json.member("lower", link.lower.index());
  json.member("upper", link.upper.index());
  json.member("made", link.fate == LinkFate::made);
  json.member("evidence", name_of(link.evidence));
  json.member("fate", json_name(name_of(link.fate)));
  json.member("ratio", link.ratio);
  json.member("moved", link.moved);
  json.member("distance", link.distance);
  json.member("margin", link.margin);
  if (link.lead) json.member("lead", *link.lead);
  json.end_object();
}

}  // namespace

std::string link_lines(const LinkListing& listing, bool told) {
  const std::vector<RegionLink> links = listed(listing);
  std::string text = told ? header(listing, links.size()) : "";
  for (const Label& label : listing.labels) {
    text += std::to_string(label.section.index()) + ' ' + std::to_string(label.contour.index()) +
            ' ' + std::to_string(label.label) + "  # label\n";
  }
  for (const RegionLink& link : links) {
    append_decision(text, link);
    text += "  # " + measures(link) + '\n';
  }
  if (told && listing.sections > 1) text += slab_counts(listing);
  return text;
}

void write_links(JsonWriter& json, const std::vector<RegionLink>& links) {
  json.begin_array();
  for (const RegionLink& link : links) write_link(json, link);
  json.end_array();
}

void write_link_counts(JsonWriter& json, const std::vector<RegionLink>& links) {
  const LinkCounts counts = counts_of(links);
  json.key("made");
  json.begin_object();
  for (std::size_t e = 0; e < counts.made.size(); ++e) {
    json.member(name_of(static_cast<Evidence>(e)), counts.made[e]);
  }
  json.end_object();
  json.key("not_made");
  json.begin_object();
  for (std::size_t f = 0; f < counts.not_made.size(); ++f) {
    const auto fate = static_cast<LinkFate>(f);
    if (fate != LinkFate::made) json.member(json_name(name_of(fate)), counts.not_made[f]);
  }
  json.end_object();
}

void write_link_summary(JsonWriter& json, const std::vector<RegionLink>& links) {
  constexpr std::size_t kFew = 5;
  json.key("links");
  json.begin_object();
  write_link_counts(json, links);
  std::vector<RegionLink> few = least_sure_first(links);
  few.resize(std::min(few.size(), kFew));
  json.key("least_sure");
  write_links(json, few);
  json.end_object();
}

std::string counted_links(const std::vector<RegionLink>& links) {
  return text_of(counts_of(links));
}

std::string describe_links(const std::vector<RegionLink>& links) {
  if (links.empty()) return "";
  const RegionLink least = least_sure_first(links).front();
  std::string text = "links: " + counted_links(links) + "; the least sure: ";
  append_decision(text, least);
  return text + " (" + measures(least) + ")\n";
}

}  // namespace tetloft::cli
