// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/search/casewriter.h"

#include <QFile>
#include <QSaveFile>

#include <cstdio>

/// findhardcases CASES.json: searches with all recipes and writes the finds. Takes minutes; the
/// same recipes give the same file.
int main(int argc, char *argv[])
{
    using namespace pixelplumb::search;
    if (argc != 2) {
        std::fprintf(stderr, "usage: findhardcases CASES.json\n");
        return 2;
    }
    std::vector<Find> finds;
    for (const Recipe &recipe : recipes()) {
        std::optional<Find> find = search(recipe);
        std::fprintf(stderr, "%-36s %lld\n", recipe.id,
                     find ? static_cast<long long>(find->score.sought) : 0LL);
        if (find)
            finds.push_back(std::move(*find));
    }
    QSaveFile file(QFile::decodeName(argv[1]));
    if (!file.open(QIODevice::WriteOnly) || file.write(casesText(finds)) < 0 || !file.commit()) {
        std::fprintf(stderr, "%s: %s\n", argv[1], qPrintable(file.errorString()));
        return 1;
    }
    std::fprintf(stderr, "%zu of %zu recipes found a case\n", finds.size(), recipes().size());
    return finds.size() == recipes().size() ? 0 : 1;
}
