// The C interface: bytes as a sequence of calls with handles that are good, freed, of another type,
// NULL or made up, with sizes, versions and numbers that may be anything. Every call ends with a
// status that there is, and where it fails leaves nothing but NULL and 0.
#include <array>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "c/calls/calls.hpp"
#include "fuzz/target.hpp"

namespace tetloft::fuzz {
namespace {

using c_test::Arguments;
using c_test::Expected;
using c_test::Kind;

// Handles of each kind that are good, and some that were.
class Pool {
 public:
  Pool() = default;
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;
  ~Pool() {
    for (int k = 0; k < c_test::kKinds; ++k) {
      for (void* const handle : good_[static_cast<std::size_t>(k)]) {
        c_test::free_handle(static_cast<Kind>(k), handle);
      }
    }
  }

  void* good(Kind kind, std::size_t which) {
    std::vector<void*>& good = good_[static_cast<std::size_t>(kind)];
    if (good.empty()) good.push_back(c_test::new_handle(kind));
    return good[which % good.size()];
  }
  void* freed(std::size_t which) const {
    return freed_.empty() ? nullptr : freed_[which % freed_.size()];
  }
  void keep(Kind kind, void* handle) {
    good_[static_cast<std::size_t>(kind)].push_back(handle);
    if (good_[static_cast<std::size_t>(kind)].size() > kMostOfAKind) free_first(kind);
  }
  void free_first(Kind kind) {
    std::vector<void*>& good = good_[static_cast<std::size_t>(kind)];
    if (good.empty()) return;
    require(c_test::free_handle(kind, good.front()) == TETLOFT_OK, "a good handle is not freed");
    freed_.push_back(good.front());
    good.erase(good.begin());
  }

 private:
  static constexpr std::size_t kMostOfAKind = 4;
  std::array<std::vector<void*>, c_test::kKinds> good_;
  std::vector<void*> freed_;
};

class FuzzedArguments : public Arguments {
 public:
  // Nothing can be read or written in such a folder.
  FuzzedArguments(Bytes& bytes, Pool& pool)
      : Arguments("/dev/null/nowhere"), bytes_(bytes), pool_(pool) {}

  std::int64_t integer(std::int64_t usual) override {
    if (bytes_.byte() < 160) return usual;
    constexpr std::int64_t kWide = std::int64_t{1} << 33;  // no size of memory that there is
    constexpr std::array<std::int64_t, 16> kValues{0,
                                                   1,
                                                   2,
                                                   3,
                                                   4,
                                                   5,
                                                   7,
                                                   40,
                                                   65,
                                                   300,
                                                   -1,
                                                   -2,
                                                   std::numeric_limits<std::int32_t>::min(),
                                                   kWide,
                                                   std::numeric_limits<std::int64_t>::min(),
                                                   std::numeric_limits<std::int64_t>::max()};
    return kValues[bytes_.byte() % kValues.size()];
  }

  double real(double usual) override { return bytes_.byte() < 160 ? usual : number(); }

  std::vector<double> reals(std::vector<double> usual) override {
    if (bytes_.byte() < 64) return usual;
    usual.resize(bytes_.byte() % 8 == 0 ? bytes_.byte() % 40 : usual.size());
    for (double& value : usual) value = number();
    return usual;
  }

  std::vector<std::uint32_t> ids(std::vector<std::uint32_t> usual) override {
    if (bytes_.byte() < 64) return usual;
    usual.resize(bytes_.byte() % 8 == 0 ? bytes_.byte() % 24 : usual.size());
    for (std::uint32_t& id : usual) {
      const std::uint8_t byte = bytes_.byte();
      id = byte == 255 ? TETLOFT_NO_ID : byte % 6;
    }
    return usual;
  }

  // After the call.
  void keep_handles() {
    for (HandleOutput& output : handle_outputs()) {
      require(output.handle != nullptr, "a call succeeds without its handle");
      pool_.keep(output.kind, output.handle);
      output.handle = nullptr;
    }
  }

 protected:
  std::size_t choose(std::initializer_list<Expected> expected) override {
    const std::uint8_t byte = bytes_.byte();
    return byte < 208 ? 0 : byte % expected.size();
  }
  void* right_handle(Kind kind) override { return pool_.good(kind, bytes_.byte()); }
  void* wrong_handle(Kind kind, std::size_t which) override {
    if (which == 0) return pool_.freed(bytes_.byte());
    const std::uint8_t byte = bytes_.byte();
    if (which == 1) {  // never of its own kind: a call that frees it would succeed unnoticed
      const int others = 1 + byte % (c_test::kKinds - 1);
      return pool_.good(static_cast<Kind>((static_cast<int>(kind) + others) % c_test::kKinds),
                        byte);
    }
    if (which == 2) return reinterpret_cast<void*>(std::uintptr_t{byte});
    if (which == 3) return &pool_;
    const auto good = reinterpret_cast<std::uintptr_t>(pool_.good(kind, byte));
    return reinterpret_cast<void*>(which == 4 ? ~good : good + 1 + byte);
  }

 private:
  // Mostly of a small lattice.
  double number() {
    const std::uint8_t byte = bytes_.byte();
    constexpr std::array<double, 8> kSpecial{std::numeric_limits<double>::quiet_NaN(),
                                             std::numeric_limits<double>::infinity(),
                                             -std::numeric_limits<double>::infinity(),
                                             1e300,
                                             -1e300,
                                             1e-300,
                                             0.1,
                                             -0.0};
    return byte >= 240 ? kSpecial[byte % kSpecial.size()] : (byte % 16) / 2.0 - 2;
  }

  Bytes& bytes_;
  Pool& pool_;
};

bool is_known(tetloft_status status) {
  return std::string(tetloft_status_name(status)) != "unknown";
}

void run_call(const c_test::Call& call, Bytes& bytes, Pool& pool) {
  FuzzedArguments arguments(bytes, pool);
  const tetloft_status status = call.call(arguments);
  require(is_known(status), "a status that there is not");
  require(status != TETLOFT_INTERNAL, tetloft_last_error());
  if (status == TETLOFT_OK) {
    arguments.keep_handles();
    return;
  }
  require(*tetloft_last_error() != '\0', "a failure without a text");
  require(status == TETLOFT_TOO_SMALL || arguments.outputs_are_clear(),
          "a call that fails leaves something");
}

}  // namespace
}  // namespace tetloft::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tetloft;
  using namespace tetloft::fuzz;
  if (size > 1024) return 0;
  static const std::vector<c_test::Call> calls = c_test::all_calls();
  Bytes bytes(data, size);
  Pool pool;
  while (!bytes.empty()) {
    const std::size_t what = bytes.below(calls.size() + 8);
    if (what < calls.size()) {
      run_call(calls[what], bytes, pool);
    } else {
      pool.free_first(static_cast<Kind>(bytes.byte() % c_test::kKinds));
    }
  }
  return 0;
}
