#include "model/digest.hpp"

#include <bit>
#include <string_view>
#include <type_traits>

#include "core/text.hpp"
#include "model/fields.hpp"
#include "model/tables.hpp"

namespace tetloft::internal {

namespace {

// FNV-1a over words, whose high bits come down: alone it would leave the highest where it is, and
// two signs that change cancel. A step is a bijection of the state for each word, and of the word
// for each state: two streams that differ in one word end differently.
class Digest {
 public:
  void add(std::uint64_t word) {
    state_ = (state_ ^ word) * 0x100000001B3U;
    state_ ^= state_ >> 32;
  }
  void add(double x) { add(std::bit_cast<std::uint64_t>(x + 0.0)); }
  void add(const Point3& p) {
    add(p.x);
    add(p.y);
    add(p.z);
  }
  void add(std::string_view text) {
    add(std::uint64_t{text.size()});
    for (const char c : text) add(std::uint64_t{static_cast<unsigned char>(c)});
  }
  template <class Stored, class Value>
  void add_stored(const Value& value) {
    if constexpr (std::is_floating_point_v<typename Stored::Type>) {
      add(Stored::store(value));
    } else {
      add(static_cast<std::uint64_t>(Stored::store(value)));
    }
  }
  [[nodiscard]] std::uint64_t state() const { return state_; }

 private:
  std::uint64_t state_ = 0xCBF29CE484222325U;
};

}  // namespace

std::uint64_t digest_of(const Model& model) {
  Digest digest;
  digest.add(std::uint64_t{model.points.size()});
  for (const Point3& p : model.points) digest.add(p);
  digest.add(std::uint64_t{model.tets.size()});
  for (const TetVertices& tet : model.tets) {
    for (const VertexId v : tet) digest.add(std::uint64_t{v.value()});
  }
  for_each_field([&](const auto& field) {
    using Stored = typename std::remove_cvref_t<decltype(field)>::Stored;
    const auto& values = model.*field.values;
    digest.add(std::uint64_t{values.size()});
    for (const auto& value : values) digest.template add_stored<Stored>(value);
  });
  for_each_table([&](const auto& table) {
    const auto& rows = model.*table.rows;
    digest.add(std::uint64_t{rows.size()});
    for_each_column(table, [&](const auto& column) {
      using Stored = typename std::remove_cvref_t<decltype(column)>::Stored;
      for (const auto& row : rows) digest.template add_stored<Stored>(column.get(row));
    });
  });
  for (const Point3& axis : model.frame.axes) digest.add(axis);
  digest.add(model.frame.origin);
  for (const std::string& text : {model.about.name, model.about.unit, model.about.orientation}) {
    digest.add(std::string_view(valid_utf8(text)));
  }
  return digest.state();
}

}  // namespace tetloft::internal
