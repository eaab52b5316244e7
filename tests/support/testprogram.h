// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QTest>

/// A program of tests holds several classes, each in a file of its own:
///
///     program                          all classes
///     program columnscan oracle        these two
///     program columnscan -v2 function  arguments after the classes are QTest's
namespace pixelplumb {

/// Runs one class with QTest's arguments; returns how many of its functions failed.
using TestRun = int (*)(const QStringList &arguments);

/// Puts a class among those of its program. Its name is its file's: tst_columnscan.cpp is
/// columnscan.
class RegisteredTest {
public:
    RegisteredTest(const char *file, TestRun run);
};

/// Runs the classes that the arguments name. The exit code: 0 when every function passed, 1 when
/// one failed, 2 when the first name is no class of this program.
int runTests(const QStringList &arguments);

} // namespace pixelplumb

/// Stands once in each file of tests, below its class.
#define PIXELPLUMB_TEST(Class)                                 \
    static const pixelplumb::RegisteredTest registered##Class( \
        __FILE__, [](const QStringList &arguments) {           \
            Class tests;                                       \
            return QTest::qExec(&tests, arguments);            \
        });
