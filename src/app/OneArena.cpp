#include "app/OneArena.h"

#include <cstdlib> // defines __GLIBC__, where it is that library
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace limen::app {

void shareOneArena() {
#ifdef __GLIBC__
    (void)mallopt(M_ARENA_MAX, 1);
#endif
}

} // namespace limen::app
