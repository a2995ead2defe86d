// JSON read back: a strict parser of its own, so that the tests do not share the product's
// idea of JSON.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetloft::test {

struct JsonValue {
  enum class Kind { null, boolean, number, string, array, object };
  Kind kind = Kind::null;
  bool boolean = false;
  double number = 0;
  std::string string;
  std::vector<JsonValue> array;
  std::map<std::string, JsonValue> object;

  [[nodiscard]] bool has(const std::string& key) const { return object.count(key) != 0; }
  /// The member, or a null value that makes comparisons fail.
  [[nodiscard]] const JsonValue& at(const std::string& key) const;
};

/// The one value that `text` holds, white space around it; empty if it is not exactly that
/// (RFC 8259; members must not repeat).
[[nodiscard]] std::optional<JsonValue> parse_json(std::string_view text);

}  // namespace tetloft::test
