// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QTest>

/// A test program holds several classes, each in its own file:
///
///     program                          all classes
///     program columnscan oracle        these two
///     program columnscan -v2 function  arguments after the classes are QTest's
namespace pixelplumb {

using namespace Qt::StringLiterals; // u"…"_s is a QString

/// Runs one class with QTest's arguments; returns how many of its functions failed.
using TestRun = int (*)(const QStringList &arguments);

/// Registers a class with its program. Its name comes from its file: tst_columnscan.cpp is
/// columnscan.
class RegisteredTest {
public:
    RegisteredTest(const char *file, TestRun run);
};

/// Runs the classes named in the arguments. Exit code: 0 if every function passed, 1 if one failed,
/// 2 if the first name is no class of this program.
int runTests(const QStringList &arguments);

} // namespace pixelplumb

/// Used once in each test file, below its class.
#define PIXELPLUMB_TEST(Class)                                 \
    static const pixelplumb::RegisteredTest registered##Class( \
        __FILE__, [](const QStringList &arguments) {           \
            Class tests;                                       \
            return QTest::qExec(&tests, arguments);            \
        });
