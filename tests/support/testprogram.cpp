// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/testprogram.h"

#include <QFileInfo>

#include <cstdio>
#include <map>

namespace pixelplumb {

namespace {

/// The tests by name. A function, because classes register while other statics are still being
/// initialised.
std::map<QString, TestRun> &registeredTests()
{
    static std::map<QString, TestRun> tests;
    return tests;
}

} // namespace

RegisteredTest::RegisteredTest(const char *file, TestRun run)
{
    const QString source = QFileInfo(QString::fromUtf8(file)).baseName();
    registeredTests().emplace(source.sliced(u"tst_"_s.size()), run);
}

int runTests(const QStringList &arguments)
{
    const std::map<QString, TestRun> &all = registeredTests();
    std::map<QString, TestRun> chosen;
    qsizetype next = 1;
    for (; next < arguments.size(); ++next) {
        const auto named = all.find(arguments[next]);
        if (named == all.end())
            break;
        chosen.insert(*named);
    }
    const bool isNamed = next < arguments.size() && !arguments[next].startsWith(u'-');
    if (chosen.empty() && isNamed) {
        std::fprintf(stderr, "%s is no class of these tests, which are:\n",
                     qPrintable(arguments[next]));
        for (const auto &[name, run] : all)
            std::fprintf(stderr, "    %s\n", qPrintable(name));
        return 2;
    }

    const QStringList forEach = arguments.mid(0, 1) + arguments.mid(next);
    int failures = 0;
    for (const auto &[name, run] : chosen.empty() ? all : chosen)
        failures += run(forEach);
    return failures == 0 ? 0 : 1;
}

} // namespace pixelplumb
