// The reader alone, whatever the bytes.

#include "tests/fuzz/promised.h"
#include "tests/support/promises.h"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const arris::recipe::Recipe recipe = arris::test::recipeFor(text);
  arris::test::endWhereBroken(
      arris::test::brokenPromise(arris::pattern::readDxf(text, arris::pattern::importOptions(recipe))));
  return 0;
}
