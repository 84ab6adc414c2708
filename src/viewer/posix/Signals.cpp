#include "viewer/Signals.h"

#include <csignal>
#include <pthread.h>
#include <sys/signalfd.h>
#include <unistd.h>

namespace limen::viewer {

struct Signals::State {
    sigset_t before{};
    int descriptor = -1;
};

Signals::Signals() : state_(std::make_unique<State>()) {
    sigset_t wanted;
    sigemptyset(&wanted);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        sigaddset(&wanted, signal);
    pthread_sigmask(SIG_BLOCK, &wanted, &state_->before);
    state_->descriptor = signalfd(-1, &wanted, SFD_NONBLOCK | SFD_CLOEXEC);
}

/// Signals that were read are gone. A second one that still waits ends the program here.
Signals::~Signals() {
    if (state_->descriptor >= 0)
        close(state_->descriptor);
    pthread_sigmask(SIG_SETMASK, &state_->before, nullptr);
}

std::optional<int> Signals::arrived() {
    signalfd_siginfo info{};
    if (!arrived_ && state_->descriptor >= 0 && read(state_->descriptor, &info, sizeof info) == sizeof info)
        arrived_ = static_cast<int>(info.ssi_signo);
    return arrived_;
}

std::string_view nameOfSignal(int signal) {
    return signal == SIGINT ? "SIGINT" : signal == SIGTERM ? "SIGTERM" : "SIGHUP";
}

} // namespace limen::viewer
