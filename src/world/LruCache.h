#pragma once

#include <cstddef>
#include <list>
#include <map>
#include <memory>
#include <mutex>

namespace limen::world {

/// Things that were made, by what they were made from, up to a number of bytes: what was asked for longest ago goes first. Whoever
/// has one keeps it, in here or not. Safe to use from several threads.
template <class Key, class Value>
class LruCache {
public:
    explicit LruCache(std::size_t mostBytes) : mostBytes_(mostBytes) {}

    /// Null if it is not here.
    [[nodiscard]] std::shared_ptr<const Value> find(const Key& key) {
        const std::lock_guard lock(mutex_);
        const auto found = places_.find(key);
        if (found == places_.end())
            return nullptr;
        byUse_.splice(byUse_.begin(), byUse_, found->second);
        return found->second->value;
    }

    /// Yields what is kept: of two threads that made the same, the first one's. Something larger than all that may be kept is not.
    [[nodiscard]] std::shared_ptr<const Value> keep(const Key& key, std::shared_ptr<const Value> value,
                                                    std::size_t bytes) {
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
        bytes_ -= byUse_.back().bytes;
        places_.erase(byUse_.back().key);
        byUse_.pop_back();
    }

    mutable std::mutex mutex_;
    std::size_t mostBytes_;
    std::size_t bytes_ = 0;
    std::list<Kept> byUse_; ///< the last used first
    std::map<Key, typename std::list<Kept>::iterator> places_;
};

} // namespace limen::world
