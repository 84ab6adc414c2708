#pragma once

#include <string>
#include <vector>

namespace limen::gpu {

/// Collects the driver's messages of the current context (KHR_debug, synchronous) from construction to
/// destruction. Not movable: the driver keeps its address. The context must outlive it.
class DebugOutput {
public:
    DebugOutput();
    ~DebugOutput();
    DebugOutput(const DebugOutput&) = delete;
    DebugOutput& operator=(const DebugOutput&) = delete;

    /// Errors and messages of high severity, in order, one line each.
    [[nodiscard]] const std::vector<std::string>& faults() const { return faults_; }
    void clear() { faults_.clear(); }

    /// Callback of the driver.
    void receive(unsigned type, unsigned severity, std::string message);

private:
    std::vector<std::string> faults_;
};

} // namespace limen::gpu
