// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/caselist.h"

#include "core/scene/files/fileaccess.h"

#include <QTest>

#include <algorithm>

namespace pixelplumb {

std::vector<HardCase> casesOf(const QString &path)
{
    const Result<QByteArray> text = readFile(path);
    const Result<std::vector<HardCase>> cases = text ? readHardCases(*text) : text.error();
    if (!cases) {
        QTest::qFail(qPrintable(cases.error().message()), __FILE__, __LINE__);
        return {};
    }
    return *cases;
}

void addRows(const std::vector<HardCase> &cases)
{
    QTest::addColumn<const HardCase *>("hardCase");
    for (const HardCase &hardCase : cases)
        QTest::newRow(qPrintable(hardCase.id)) << &hardCase;
}

const HardCase &caseNamed(const std::vector<HardCase> &cases, const QString &id)
{
    return *std::ranges::find(cases, id, &HardCase::id);
}

QByteArray fileOfCase(const QByteArray &members)
{
    return "{\"version\": 1, \"cases\": [{" + members + "}]}";
}

} // namespace pixelplumb
