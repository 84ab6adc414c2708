#include "app/Verbs.h"

#include <cstdlib>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace {

/// Parts of the world come and go as a few large arrays. At first glibc maps those from the system one by one and unmaps them, but with each
/// that goes it raises the size from which it does, and then keeps a hundred MiB that it does not need. A size that is set stays.
void giveLargeBlocksBack() {
#ifdef __GLIBC__
    ::mallopt(M_MMAP_THRESHOLD, 256 << 10);
#endif
}

} // namespace

int main(int argc, char** argv) {
    giveLargeBlocksBack();
    const limen::app::Console console;
    return static_cast<int>(limen::app::runProgram(argc, argv, console));
}
