// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <type_traits>
#include <utility>
#include <vector>

namespace tessera
{

/// Calls f(piece, begin, end) for all consecutive pieces of 0 .. count, on up to execution.threads()
/// threads; the last piece may be smaller. What the pieces are does not depend on the number of
/// threads, so results that are put together in the order of the pieces do not either. An exception
/// of f ends the loop and is thrown again. Preconditions: piece > 0; calls of f do not disturb each
/// other; f does not call this with the same execution.
template<class F>
void forEachPiece(const Execution& execution, std::size_t count, std::size_t piece, F&& f)
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
    const std::size_t threads = std::min(pieces, static_cast<std::size_t>(execution.threads()));
    if (threads > 1) {
        execution.workers().run(threads - 1, work);
    }
    else {
        work();
    }
    if (failure) {
        std::rethrow_exception(failure);
    }
}

/// What f(begin, end, part) puts into part for all consecutive pieces, in their order. As
/// forEachPiece().
template<class T, class F>
std::vector<T> collectPieces(const Execution& execution, std::size_t count, std::size_t piece, F&& f)
{
    std::vector<std::vector<T>> parts((count + piece - 1) / piece);
    forEachPiece(execution, count, piece,
                 [&](std::size_t i, std::size_t begin, std::size_t end) {
                     // Of its own: threads that write side by side slow each other down.
                     std::vector<T> part;
                     f(begin, end, part);
                     parts[i] = std::move(part);
                 });
    std::size_t total = 0;
    for (const std::vector<T>& part : parts) {
        total += part.size();
    }
    std::vector<T> all;
    all.reserve(total);
    for (const std::vector<T>& part : parts) {
        all.insert(all.end(), part.begin(), part.end());
    }
    return all;
}

/// Calls the functions, which must not disturb each other, at the same time. Preconditions as for
/// forEachPiece().
template<class... F>
void runTogether(const Execution& execution, F&&... functions)
{
    forEachPiece(execution, sizeof...(functions), 1, [&](std::size_t wanted, std::size_t, std::size_t) {
        std::size_t i = 0;
        ((i++ == wanted ? static_cast<void>(functions()) : void()), ...);
    });
}

/// Reserves, and lets several threads touch the new memory: the system hands out pages when they are
/// first written to, which costs more than the filling.
template<class T>
void reserveTouched(const Execution& execution, std::vector<T>& values, std::size_t count)
{
    static_assert(std::is_trivially_destructible_v<T>);
    constexpr std::size_t kPage = 4096;
    if (count <= values.capacity()) {
        return;
    }
    values.reserve(count);
    if (execution.threads() < 2) {
        return;
    }
    // Nothing lives in these bytes yet; the vector writes over them.
    auto* const bytes = reinterpret_cast<std::byte*>(values.data() + values.size());
    const std::size_t size = (values.capacity() - values.size()) * sizeof(T);
    forEachPiece(execution, size / kPage, 256,
                 [&](std::size_t, std::size_t begin, std::size_t end) {
                     for (std::size_t i = begin; i < end; ++i) {
                         static_cast<volatile std::byte&>(bytes[i * kPage]) = std::byte {0};
                     }
                 });
}

} // namespace tessera
