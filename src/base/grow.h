// SPDX-License-Identifier: MIT
#pragma once

#include "base/huge_pages.h"

#include <vector>

namespace tessera
{

/// Makes room for one more element. Grows by half, where the standard library doubles, so that big
/// arrays leave less of their memory unused.
template<class T>
void makeRoom(std::vector<T>& array)
{
    if (array.size() == array.capacity()) {
        reserveOnHugePages(array, array.size() + array.size() / 2 + 8);
    }
}

} // namespace tessera
