#pragma once

#include "core/Assert.h"

#include <cstddef>
#include <list>
#include <map>
#include <memory>
#include <mutex>

namespace limen::world {

/// Values by key, up to a number of bytes. The least recently used entry is dropped first. A dropped value
/// lives on as long as a caller holds it. Thread-safe.
template <class Key, class Value>
class LruCache {
public:
    explicit LruCache(std::size_t mostBytes) : mostBytes_(mostBytes) {}

    /// Null if the key is not kept.
    [[nodiscard]] std::shared_ptr<const Value> find(const Key& key) {
        const std::lock_guard lock(mutex_);
        const auto found = places_.find(key);
        if (found == places_.end())
            return nullptr;
        byUse_.splice(byUse_.begin(), byUse_, found->second);
        return found->second->value;
    }

    /// Yields the value that is kept for the key: if two threads made one, that of the first. A value larger
    /// than the capacity is not kept and is returned as it is.
    [[nodiscard]] std::shared_ptr<const Value> keep(const Key& key, std::shared_ptr<const Value> value,
                                                    std::size_t bytes) {
        LIMEN_ASSERT(value != nullptr, "null means that a key is not kept");
        const std::lock_guard lock(mutex_);
        if (const auto found = places_.find(key); found != places_.end())
            return found->second->value;
        if (bytes > mostBytes_)
            return value;
        byUse_.push_front({key, value, bytes});
        places_.emplace(key, byUse_.begin());
        bytes_ += bytes;
        while (bytes_ > mostBytes_)
            dropLast();
        return value;
    }

    [[nodiscard]] std::size_t size() const {
        const std::lock_guard lock(mutex_);
        return places_.size();
    }
    [[nodiscard]] std::size_t bytes() const {
        const std::lock_guard lock(mutex_);
        return bytes_;
    }

private:
    struct Kept {
        Key key;
        std::shared_ptr<const Value> value;
        std::size_t bytes = 0;
    };

    void dropLast() {
        LIMEN_ASSERT(!byUse_.empty() && bytes_ >= byUse_.back().bytes, "bytes_ is the sum over all entries");
        bytes_ -= byUse_.back().bytes;
        places_.erase(byUse_.back().key);
        byUse_.pop_back();
    }

    mutable std::mutex mutex_;
    std::size_t mostBytes_;
    std::size_t bytes_ = 0;
    std::list<Kept> byUse_; ///< most recently used first
    std::map<Key, typename std::list<Kept>::iterator> places_;
};

} // namespace limen::world
