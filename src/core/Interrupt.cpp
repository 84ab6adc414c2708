#include "core/Interrupt.h"

#include "core/Assert.h"
#include "core/platform/InterruptSource.h"

#include <atomic>

namespace limen {
namespace {

// The only mutable globals of the program. A signal handler has no argument through which it could reach an
// object. Lock-free atomics are safe in a handler and on every thread.
struct InterruptState {
    std::atomic<int> first{0};      ///< the first signal
    std::atomic<bool> again{false}; ///< a second signal came
    std::atomic<bool> deferred{false};
    std::atomic<int> writes{0}; ///< objects of UninterruptedWrite
};
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);
constinit InterruptState interruptState;

bool mustDie() {
    return interruptState.first != 0 && interruptState.writes == 0 &&
           (!interruptState.deferred || interruptState.again);
}

extern "C" void onInterrupt(int signal) {
    int none = 0;
    if (!interruptState.first.compare_exchange_strong(none, signal))
        interruptState.again = true;
    if (mustDie())
        platform::endBySignal(interruptState.first);
}

} // namespace

Interrupt Interrupt::install() {
    platform::watchInterrupts(onInterrupt);
    Interrupt interrupt;
    interrupt.installed_ = true;
    return interrupt;
}

void Interrupt::defer() const {
    if (installed_)
        interruptState.deferred = true;
}

int Interrupt::signal() const {
    return installed_ ? interruptState.first.load() : 0;
}

void Interrupt::die() const {
    LIMEN_ASSERT(isRequested(), "a signal came");
    platform::endBySignal(signal());
}

UninterruptedWrite::UninterruptedWrite() {
    ++interruptState.writes;
}

UninterruptedWrite::~UninterruptedWrite() {
    if (--interruptState.writes == 0 && mustDie())
        platform::endBySignal(interruptState.first);
}

} // namespace limen
