// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/files/fileaccess.h"
#include "tests/search/casefiles.h"
#include "tests/search/shortfallrecord.h"

#include <QDir>

#include <cstdio>

/// recordshortfalls FOLDER: measures every case in the folder's files and rewrites the record. Run
/// it, and read the diff, after changing a kernel or a case on purpose.
int main(int argc, char *argv[])
{
    using namespace pixelplumb;
    if (argc != 2) {
        std::fprintf(stderr, "usage: recordshortfalls FOLDER\n");
        return 2;
    }
    const QDir folder(QString::fromLocal8Bit(argv[1]));
    search::ShortfallRecord record;
    for (const QString &name : search::caseFiles) {
        const Result<QByteArray> content = readFile(folder.filePath(name));
        const Result<std::vector<HardCase>> cases
            = content ? readHardCases(*content) : content.error();
        if (!cases) {
            std::fprintf(stderr, "%s: %s\n", qPrintable(name), qPrintable(cases.error().message()));
            return 2;
        }
        for (const HardCase &hardCase : *cases)
            record[name][hardCase.id] = search::shortfallsOf(hardCase);
    }
    if (const auto error = writeFile(folder.filePath(search::recordFile), search::textOf(record))) {
        std::fprintf(stderr, "%s\n", qPrintable(error->message()));
        return 1;
    }
    return 0;
}
