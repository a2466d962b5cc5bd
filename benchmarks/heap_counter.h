// SPDX-License-Identifier: MIT
#pragma once

// Replaces operator new and delete of the one executable that includes it, to measure the heap.
// They are not inlined: the compiler would take free() for the wrong partner of new.

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <malloc.h>
#include <new>

/// Bytes on the heap.
class HeapCounter
{
public:
    /// Starts a measurement of the peak and returns what is on the heap now.
    static std::size_t restart()
    {
        peak_ = now_;
        return now_;
    }
    static std::size_t peak() { return peak_; }

    static void add(void* p)
    {
        now_ += malloc_usable_size(p);
        peak_ = std::max(peak_, now_);
    }
    static void release(void* p)
    {
        now_ -= p != nullptr ? malloc_usable_size(p) : 0;
        std::free(p);
    }

private:
    static inline std::size_t now_ = 0;
    static inline std::size_t peak_ = 0;
};

[[gnu::noinline]] void* operator new(std::size_t size)
{
    void* p = std::malloc(size);
    if (p == nullptr) {
        throw std::bad_alloc();
    }
    HeapCounter::add(p);
    return p;
}

[[gnu::noinline]] void operator delete(void* p) noexcept
{
    HeapCounter::release(p);
}

[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept
{
    HeapCounter::release(p);
}

[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment)
{
    const auto unit = static_cast<std::size_t>(alignment);
    void* p = std::aligned_alloc(unit, (size + unit - 1) / unit * unit);
    if (p == nullptr) {
        throw std::bad_alloc();
    }
    HeapCounter::add(p);
    return p;
}

[[gnu::noinline]] void operator delete(void* p, std::align_val_t) noexcept
{
    HeapCounter::release(p);
}

[[gnu::noinline]] void operator delete(void* p, std::size_t, std::align_val_t) noexcept
{
    HeapCounter::release(p);
}
