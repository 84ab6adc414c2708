#include "Check.h"

#include "world/Places.h"

// Input: the text of a `world.json`. Every refusal has a reason.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    limen::fuzz::expectReason(limen::world::parseWorldFile(text, "world.json"));
    return 0;
}
