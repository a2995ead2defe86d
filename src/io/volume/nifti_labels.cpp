// Label tables: <Label Key="1" …><![CDATA[spleen]]></Label>.
#include "io/volume/nifti_labels.hpp"

#include <cstdint>
#include <string>

#include "io/numbers.hpp"
#include "io/volume/samples.hpp"
#include "io/xml.hpp"

namespace tetloft::internal::io {

namespace {

constexpr std::size_t kMostNames = std::size_t{1} << 16;

std::string text_in(XmlScanner& xml) {
  constexpr std::string_view kBegin = "<![CDATA[";
  std::string text(xml.take_text());
  while (xml.rest().substr(0, kBegin.size()) == kBegin) {
    const std::string_view quoted = xml.rest().substr(kBegin.size());
    const std::size_t end = quoted.find("]]>");
    if (end == std::string_view::npos) return {};
    text += quoted.substr(0, end);
    xml.pass_over(kBegin.size() + end + 3);
    text += xml.take_text();
  }
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") + 1 - first);
}

void add_labels_of_table(std::string_view text, std::vector<VolumeSegment>& labels) {
  const std::string unnamed;
  XmlScanner xml(text, unnamed);
  while (labels.size() < kMostNames) {
    const Result<XmlTag> tag = xml.next_tag();
    if (!tag || tag->kind == XmlTag::Kind::end_of_file) return;
    if (tag->kind != XmlTag::Kind::open || tag->name != "Label") continue;
    const std::string* const key = tag->find("Key");
    const double value = key == nullptr ? 0 : parse_number(*key).value;
    std::string name = text_in(xml);
    if (value != 0 && !name.empty()) labels.push_back({value, std::move(name), 0});
  }
}

}  // namespace

std::vector<VolumeSegment> labels_in_extensions(std::string_view extensions, bool big_endian) {
  std::vector<VolumeSegment> labels;
  constexpr std::size_t kHead = 8;
  if (extensions.size() < 4 || extensions[0] == 0) return labels;
  extensions.remove_prefix(4);
  while (extensions.size() > kHead) {
    const auto size = number_in<std::int32_t>(extensions.data(), big_endian);
    if (size <= static_cast<std::int32_t>(kHead)) break;
    const std::string_view text = extensions.substr(kHead, static_cast<std::size_t>(size) - kHead);
    if (text.find("<LabelTable>") != std::string_view::npos) add_labels_of_table(text, labels);
    if (static_cast<std::size_t>(size) >= extensions.size()) break;
    extensions.remove_prefix(static_cast<std::size_t>(size));
  }
  return labels;
}

}  // namespace tetloft::internal::io
