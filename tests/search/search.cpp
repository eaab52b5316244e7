// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/search/search.h"

namespace pixelplumb::search {

namespace {

constexpr Score worthless = {-1, -1}; ///< the score of a figure without sense

struct Scored {
    Genes genes;
    Score score = worthless;
};

Scored scored(const Recipe &recipe, Genes genes)
{
    const std::optional<HardCase> hardCase = expressed(recipe, genes);
    return {std::move(genes), hardCase ? scoreOf(recipe, *hardCase) : worthless};
}

/// FNV-1a of the recipe's name, so a new recipe does not change the cases of the others.
std::uint64_t seedOf(const Recipe &recipe)
{
    std::uint64_t seed = 0xcbf29ce484222325U;
    for (const char *letter = recipe.id; *letter != '\0'; ++letter)
        seed = (seed ^ std::uint64_t(*letter)) * 0x100000001b3U;
    return seed;
}

Scored climb(const Recipe &recipe, RandomNumbers &random)
{
    Scored best;
    for (int round = 0; round < recipe.rounds; ++round) {
        Scored next = scored(recipe, randomGenes(recipe, random));
        if (next.score > best.score)
            best = std::move(next);
    }
    for (int round = 0; best.score > worthless && round < recipe.rounds; ++round) {
        Scored next = scored(recipe, mutated(recipe, best.genes, random));
        if (next.score >= best.score) // equal scores too, to get off plateaus
            best = std::move(next);
    }
    return best;
}

/// Simpler candidates, the boldest simplification first.
std::vector<Genes> simplerThan(const Genes &genes)
{
    std::vector<Genes> simpler;
    const auto add = [&](Lattice &coordinate, Lattice value, Genes &copy) {
        const Lattice before = coordinate;
        if (value == before)
            return;
        coordinate = value;
        simpler.push_back(copy);
        coordinate = before;
    };
    Genes copy = genes;
    for (LatticePoint &point : copy.points) {
        for (Lattice *coordinate : {&point.x, &point.y}) {
            const Lattice value = *coordinate;
            add(*coordinate, 0, copy);
            add(*coordinate, value / 2, copy);
            for (Lattice round = 1 << 16; round > 1; round /= 4) // fewer digits
                add(*coordinate, value - value % round, copy);
            add(*coordinate, value - 1, copy);
        }
    }
    for (Colour &colour : copy.colours) {
        for (std::uint8_t &channel : colour.channels) {
            const std::uint8_t before = channel;
            for (const std::uint8_t value : {std::uint8_t(0), std::uint8_t(255)}) {
                if (before == 0 || before == value)
                    continue;
                channel = value;
                simpler.push_back(copy);
            }
            channel = before;
        }
    }
    return simpler;
}

Scored shrunk(const Recipe &recipe, Scored best)
{
    const std::int64_t enough = recipe.shrink == Shrink::ToAnyFailure
        ? 1
        : std::max<std::int64_t>(1, best.score.sought / 2);
    // Every accepted step makes a coordinate or a colour simpler, so this ends; the limit cuts off
    // long walks by ones.
    for (int steps = 0; steps < 60; ++steps) {
        bool progress = false;
        for (Genes &genes : simplerThan(best.genes)) {
            Scored next = scored(recipe, std::move(genes));
            if (next.score.sought >= enough) {
                best = std::move(next);
                progress = true;
                break;
            }
        }
        if (!progress)
            break;
    }
    return best;
}

} // namespace

std::optional<Find> search(const Recipe &recipe)
{
    RandomNumbers random(seedOf(recipe));
    Scored best = climb(recipe, random);
    if (best.score.sought <= 0)
        return std::nullopt;
    best = shrunk(recipe, std::move(best));
    Find find;
    find.recipe = &recipe;
    find.genes = best.genes;
    find.score = best.score;
    find.hardCase = *expressed(recipe, best.genes);
    deriveFacts(find.hardCase);
    return find;
}

} // namespace pixelplumb::search
