// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measure/cachewalk.h"

#include <algorithm>

#if defined(__linux__)
#include <unistd.h>
#endif

namespace pixelplumb {

namespace {

/// The lines of one set that the cache holds, the one used last in front.
using SetLines = std::vector<std::uint64_t>;

class EmptyCache {
public:
    explicit EmptyCache(const DataCache &cache)
        : m_cache(cache)
        , m_held(std::size_t(cache.sets))
        , m_seen(std::size_t(cache.sets))
    {
    }

    void touch(std::uint64_t line)
    {
        if (m_result.changes > 0 && line == m_last)
            return;
        m_last = line;
        ++m_result.changes;
        const auto set = std::size_t(line % std::uint64_t(m_cache.sets));
        SetLines &held = m_held[set];
        const auto place = std::ranges::find(held, line);
        if (place != held.end()) {
            std::rotate(held.begin(), place, place + 1);
            return;
        }
        ++m_result.misses;
        if (held.size() == std::size_t(m_cache.ways))
            held.pop_back();
        held.insert(held.begin(), line);
        m_seen[set].push_back(line);
    }

    CacheWalk result()
    {
        for (SetLines &seen : m_seen) {
            std::ranges::sort(seen);
            // Not std::ranges::unique: clang 14 does not take the library's subrange.
            seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
            m_result.linesOfSet.push_back(int(seen.size()));
            m_result.lines += std::int64_t(seen.size());
        }
        return m_result;
    }

private:
    DataCache m_cache;
    std::vector<SetLines> m_held;
    std::vector<SetLines> m_seen; ///< every line that came, as often as it came
    std::uint64_t m_last = 0;
    CacheWalk m_result;
};

} // namespace

DataCache firstLevelDataCache()
{
    DataCache cache;
#if defined(__linux__) && defined(_SC_LEVEL1_DCACHE_SIZE)
    const long line = sysconf(_SC_LEVEL1_DCACHE_LINESIZE);
    const long ways = sysconf(_SC_LEVEL1_DCACHE_ASSOC);
    const long size = sysconf(_SC_LEVEL1_DCACHE_SIZE);
    if (line > 0 && ways > 0 && size > 0 && size % (line * ways) == 0)
        cache = {int(line), int(size / (line * ways)), int(ways)};
#endif
    return cache;
}

int CacheWalk::usedSets() const
{
    return int(linesOfSet.size() - std::size_t(std::ranges::count(linesOfSet, 0)));
}

CacheWalk walk(const PixelPlaces &places, const PixelBlock &block, WalkOrder order,
               const DataCache &cache)
{
    EmptyCache empty(cache);
    const auto touch = [&](std::int64_t column, std::int64_t row) {
        empty.touch(places.address(block.firstColumn + column, block.firstRow + row)
                    / std::uint64_t(cache.lineBytes));
    };
    if (order == WalkOrder::UpColumns) {
        for (std::int64_t column = 0; column < block.columns; ++column) {
            for (std::int64_t row = 0; row < block.rows; ++row)
                touch(column, row);
        }
    } else {
        for (std::int64_t row = 0; row < block.rows; ++row) {
            for (std::int64_t column = 0; column < block.columns; ++column)
                touch(column, row);
        }
    }
    return empty.result();
}

} // namespace pixelplumb
