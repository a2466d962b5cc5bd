// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <type_traits>
#include <vector>

namespace tessera
{

/// Calls f(piece, begin, end) for all consecutive pieces of 0 .. count, on up to threads threads;
/// the last piece may be smaller. What the pieces are does not depend on the number of threads, so
/// results that are put together in the order of the pieces do not either. An exception of f ends
/// the loop and is thrown again. Preconditions: piece > 0; calls of f do not disturb each other.
template<class F>
void forEachPiece(int threads, std::size_t count, std::size_t piece, F&& f)
{
    const std::size_t pieces = (count + piece - 1) / piece;
    std::atomic<std::size_t> next {0};
    std::exception_ptr failure;
    std::mutex failureMutex;
    const auto work = [&] {
        try {
            for (std::size_t i = next++; i < pieces; i = next++) {
                f(i, i * piece, std::min(count, (i + 1) * piece));
            }
        }
        catch (...) {
            const std::lock_guard lock(failureMutex);
            failure = std::current_exception();
            next = pieces;
        }
    };
    std::vector<std::thread> others;
    try {
        for (std::size_t i = 1; i < std::min(pieces, static_cast<std::size_t>(threads)); ++i) {
            others.emplace_back(work);
        }
    }
    catch (const std::system_error&) {
        // The system gives no more threads: those that there are do the work.
    }
    work();
    for (std::thread& other : others) {
        other.join();
    }
    if (failure) {
        std::rethrow_exception(failure);
    }
}

/// Reserves, and lets several threads touch the new memory: the system hands out pages when they are
/// first written to, which costs more than the filling.
template<class T>
void reserveTouched(int threads, std::vector<T>& values, std::size_t count)
{
    static_assert(std::is_trivially_destructible_v<T>);
    constexpr std::size_t kPage = 4096;
    if (count <= values.capacity()) {
        return;
    }
    values.reserve(count);
    if (threads < 2) {
        return;
    }
    // Nothing lives in these bytes yet; the vector writes over them.
    auto* const bytes = reinterpret_cast<std::byte*>(values.data() + values.size());
    const std::size_t size = (values.capacity() - values.size()) * sizeof(T);
    forEachPiece(threads, size / kPage, 256, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            static_cast<volatile std::byte&>(bytes[i * kPage]) = std::byte {0};
        }
    });
}

} // namespace tessera
