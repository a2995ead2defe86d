#include "io/data_cursor.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/guard.hpp"
#include "io/cursor.hpp"
#include "io/numbers.hpp"
#include "io/volume/samples.hpp"

namespace tetloft::internal::io {

namespace {

const std::string kEndsEarly = "the file ends early";

}  // namespace

std::string_view DataCursor::word() {
  while (at_ < bytes_.size() && is_white(bytes_[at_])) ++at_;
  const std::size_t from = at_;
  while (at_ < bytes_.size() && !is_white(bytes_[at_])) ++at_;
  return bytes_.substr(from, at_ - from);
}

std::string_view DataCursor::line() {
  const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
  std::string_view line = bytes_.substr(at_, end - at_);
  at_ = std::min(end + 1, bytes_.size());
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

template <class T>
T DataCursor::stored() {
  return number_in<T>(bytes(sizeof(T)).data(), form_ == DataForm::big_endian);
}

double DataCursor::number(ScalarType type) {
  double value = 0;
  if (form_ == DataForm::text) {
    const std::string_view token = word();
    const ParsedNumber parsed = parse_number(token);
    if (!parsed.ok())
      fail(token.empty() ? std::string(kEndsEarly) : complaint(token, parsed.status));
    value = type == ScalarType::float32 ? static_cast<float>(parsed.value) : parsed.value;
  } else {
    value = visit_scalar(type,
                         [&](auto zero) { return static_cast<double>(stored<decltype(zero)>()); });
  }
  if (!std::isfinite(value)) fail("a number is not finite");
  return value;
}

std::int64_t DataCursor::integer(ScalarType type) {
  if (form_ == DataForm::text) return text_integer();
  return visit_scalar(
      type, [&](auto zero) { return static_cast<std::int64_t>(stored<decltype(zero)>()); });
}

std::int64_t DataCursor::text_integer() {
  const std::string_view token = word();
  const auto value = parse_integer(token);
  if (!value) fail(token.empty() ? std::string(kEndsEarly) : in_quotes(token) + " is no integer");
  return *value;
}

std::size_t DataCursor::text_count(std::string_view what) {
  const std::int64_t count = text_integer();
  if (count < 0) fail(std::to_string(count) + " is no number of " + std::string(what));
  return static_cast<std::size_t>(count);
}

void DataCursor::require(std::uint64_t count, ScalarType type) const {
  // Of text a digit and a space each, but for the last.
  const std::uint64_t most =
      form_ == DataForm::text ? (std::uint64_t{left()} + 1) / 2 : left() / size_of(type);
  if (count <= most) return;
  fail("the file announces " + std::to_string(count) + " numbers, and ends before");
}

void DataCursor::skip(std::uint64_t count, ScalarType type) {
  require(count, type);
  if (form_ != DataForm::text) return skip_bytes(static_cast<std::size_t>(count) * size_of(type));
  for (; count != 0; --count) {
    if (word().empty()) fail(kEndsEarly);
  }
}

void DataCursor::skip_bytes(std::size_t count) { static_cast<void>(bytes(count)); }

std::string_view DataCursor::bytes(std::size_t count) {
  if (count > left()) fail(kEndsEarly);
  at_ += count;
  return bytes_.substr(at_ - count, count);
}

void DataCursor::fail(std::string message) const {
  Error error{ErrorCode::invalid_input, std::move(message), {}};
  error.where.file = name_;
  if (!has_bytes_) {
    const std::string_view before = bytes_.substr(0, at_);
    error.where.line = 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
  }
  throw Failed(std::move(error));
}

}  // namespace tetloft::internal::io
