// Every function of tetloft.h with each of its arguments wrong, one at a time: a status, no crash.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <set>
#include <string>

#include "c/calls/calls.hpp"
#include "c/calls/spoiled.hpp"
#include "c/sample_files.hpp"

namespace tetloft::c_test {
namespace {

bool meets(tetloft_status status, Expected expected) {
  switch (expected) {
    case Expected::ok: return status == TETLOFT_OK;
    case Expected::usage: return status == TETLOFT_USAGE;
    case Expected::bad_handle: return status == TETLOFT_BAD_HANDLE;
    case Expected::too_small: return status == TETLOFT_TOO_SMALL;
    case Expected::refused: return status == TETLOFT_USAGE || status == TETLOFT_INVALID_INPUT;
  }
  return false;
}

std::string told_now() { return std::string(" (") + tetloft_last_error() + ')'; }

// Made before all others, and so destroyed after them: what it frees is still known then.
class FreesLate {
 public:
  ~FreesLate() {
    if (handle != nullptr && free_handle(Kind::stack, handle) != TETLOFT_OK) std::_Exit(3);
  }
  void* handle = nullptr;
};
FreesLate frees_late;

TEST(WrongUse, AHandleCanBeFreedWhenTheProgramEnds) {
  frees_late.handle = new_handle(Kind::stack);
  EXPECT_NE(frees_late.handle, nullptr);
}

TEST(WrongUse, EveryFunctionIsInTheTable) {
  std::ifstream list(TETLOFT_C_SYMBOLS);
  std::set<std::string> symbols;
  for (std::string line; std::getline(list, line);) {
    if (!line.empty()) symbols.insert(line);
  }
  std::set<std::string> called;
  for (const Call& call : all_calls()) {
    EXPECT_TRUE(called.insert(call.function).second) << call.function << " twice";
  }
  EXPECT_EQ(called, symbols);
}

TEST(WrongUse, RightArgumentsAreRight) {
  const RightHandles handles;
  const SampleFolder folder;
  for (const Call& call : all_calls()) {
    SpoiledArguments arguments(handles, folder.path());
    EXPECT_EQ(call.call(arguments), TETLOFT_OK) << call.function << told_now();
  }
}

TEST(WrongUse, OfOneArgumentIsAStatus) {
  const RightHandles handles;
  const SampleFolder folder;
  std::size_t wrong = 0;
  for (const Call& call : all_calls()) {
    SpoiledArguments right(handles, folder.path());
    ASSERT_EQ(call.call(right), TETLOFT_OK) << call.function;
    for (std::size_t request = 0; request < right.requests().size(); ++request) {
      const std::vector<Expected>& variants = right.requests()[request];
      for (std::size_t variant = 1; variant < variants.size(); ++variant) {
        SpoiledArguments spoiled(handles, folder.path(), request, variant);
        const tetloft_status status = call.call(spoiled);
        EXPECT_TRUE(meets(status, variants[variant]))
            << call.function << ": request " << request << ", variant " << variant << ": "
            << tetloft_status_name(status) << told_now();
        if (status == TETLOFT_OK) continue;
        ++wrong;
        EXPECT_STRNE(tetloft_last_error(), "") << call.function;
        if (status != TETLOFT_TOO_SMALL) {
          EXPECT_TRUE(spoiled.outputs_are_clear())
              << call.function << ": request " << request << ", variant " << variant;
        }
      }
    }
  }
  EXPECT_GT(wrong, 1000U);
}

TEST(WrongUse, AHandleIsFreedOnce) {
  for (int k = 0; k < kKinds; ++k) {
    const Kind kind = static_cast<Kind>(k);
    void* const handle = new_handle(kind);
    ASSERT_NE(handle, nullptr) << k;
    EXPECT_EQ(free_handle(static_cast<Kind>((k + 1) % kKinds), handle), TETLOFT_BAD_HANDLE) << k;
    EXPECT_EQ(free_handle(kind, handle), TETLOFT_OK) << k;
    EXPECT_EQ(free_handle(kind, handle), TETLOFT_BAD_HANDLE) << k;
    EXPECT_EQ(free_handle(kind, nullptr), TETLOFT_OK) << k;
  }
}

TEST(WrongUse, NoNameIsUsedTwice) {
  std::set<void*> names;
  for (int i = 0; i < 1000; ++i) {
    void* const handle = new_handle(Kind::stop);
    EXPECT_TRUE(names.insert(handle).second);
    EXPECT_EQ(free_handle(Kind::stop, handle), TETLOFT_OK);
  }
}

TEST(WrongUse, SaysWhatIsWrong) {
  tetloft_model* model = static_cast<tetloft_model*>(new_handle(Kind::model));
  double volume = 1;
  auto* const stack = static_cast<tetloft_stack*>(new_handle(Kind::stack));
  EXPECT_EQ(tetloft_model_volume(reinterpret_cast<tetloft_model*>(stack), &volume),
            TETLOFT_BAD_HANDLE);
  EXPECT_STREQ(tetloft_last_error(), "model must be a model, but is a stack");
  tetloft_model_free(model);
  EXPECT_EQ(tetloft_model_volume(model, &volume), TETLOFT_BAD_HANDLE);
  EXPECT_STREQ(tetloft_last_error(), "model must be a model, but was freed or never made");
  EXPECT_EQ(tetloft_model_volume(nullptr, &volume), TETLOFT_BAD_HANDLE);
  EXPECT_STREQ(tetloft_last_error(), "model must be a model, but is NULL");
  EXPECT_EQ(tetloft_stack_counts(stack, nullptr, nullptr, nullptr), TETLOFT_OK);
  EXPECT_STREQ(tetloft_last_error(), "model must be a model, but is NULL") << "of the last failure";
  tetloft_stack_free(stack);
}

}  // namespace
}  // namespace tetloft::c_test
