// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace bspline_curve {

/// A map from ids (at least 0) to values, for searches that see a small part of all ids: memory in
/// proportion to the entries, kept for the next search when it is cleared. Nothing depends on the
/// order of the entries, which cannot be walked.
template <class Value>
class SparseMap {
public:
    /// The value of an id, or null. Valid until the next insertion.
    [[nodiscard]] const Value* find(int id) const {
        if (ids_.empty()) {
            return nullptr;
        }
        const std::size_t slot = slotOf(id);
        return ids_[slot] == id ? &values_[slot] : nullptr;
    }

    [[nodiscard]] bool contains(int id) const { return find(id) != nullptr; }

    /// The value of an id, `fresh` where it had none. Valid until the next insertion.
    Value& at(int id, const Value& fresh) {
        if (2 * (size_ + 1) > ids_.size()) {
            grow();
        }
        const std::size_t slot = slotOf(id);
        if (ids_[slot] != id) {
            ids_[slot] = id;
            values_[slot] = fresh;
            ++size_;
        }
        return values_[slot];
    }

    [[nodiscard]] std::size_t size() const { return size_; }

    void clear() {
        std::ranges::fill(ids_, kFree);
        size_ = 0;
    }

private:
    static constexpr int kFree = -1;

    // Where an id is, or belongs. At least half of the slots are free.
    [[nodiscard]] std::size_t slotOf(int id) const {
        const std::size_t mask = ids_.size() - 1;
        // The golden ratio of 2^64 spreads neighbouring ids (Knuth's multiplicative hashing).
        const std::uint64_t spread = static_cast<std::uint64_t>(id) * 0x9E3779B97F4A7C15ULL;
        std::size_t slot = static_cast<std::size_t>(spread >> 32U) & mask;
        while (ids_[slot] != kFree && ids_[slot] != id) {
            slot = (slot + 1) & mask;
        }
        return slot;
    }

    void grow() {
        std::vector<int> ids(std::max<std::size_t>(64, 2 * ids_.size()), kFree);
        std::vector<Value> values(ids.size());
        ids.swap(ids_);
        values.swap(values_);
        for (std::size_t i = 0; i < ids.size(); ++i) {
            if (ids[i] != kFree) {
                const std::size_t slot = slotOf(ids[i]);
                ids_[slot] = ids[i];
                values_[slot] = values[i];
            }
        }
    }

    std::vector<int> ids_;  // a power of two of slots
    std::vector<Value> values_;
    std::size_t size_ = 0;
};

}  // namespace bspline_curve
