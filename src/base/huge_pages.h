// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace tessera
{

/// Asks the system to back so many bytes from begin on by large pages, where it can: arrays of
/// tens of megabytes that are walked in no order cost fewer page faults and address translations.
/// Only a hint: the contents stay as they are, and nothing happens where it is not supported.
void preferHugePages(const void* begin, std::size_t bytes);

/// reserve(), the new memory preferably on large pages.
template<class T>
void reserveOnHugePages(std::vector<T>& array, std::size_t count)
{
    array.reserve(count);
    preferHugePages(array.data(), array.capacity() * sizeof(T));
}

} // namespace tessera
