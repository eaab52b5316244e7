// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/jobprogress.h"
#include "core/scene/files/fileaccess.h"

#include <QElapsedTimer>
#include <QJsonArray>
#include <QJsonObject>
#include <QString>
#include <QStringList>

#include <functional>
#include <optional>
#include <vector>

namespace pixelplumb::cli {

using namespace Qt::StringLiterals;

/// How the program ended, for shells and graders.
enum class ExitCode {
    Done = 0, ///< done, or no difference
    FallsShort = 1, ///< differs or falls short
    Usage = 2, ///< a wrong command line or unreadable input
    SizesDiffer = 3,
    Internal = 70,
};

/// Thrown to end a command: what is wrong, if anything, is reported with the command's name.
struct Ended {
    ExitCode code = ExitCode::Usage;
    InputError why = {};
};
[[noreturn]] void refuse(const InputError &why);
[[noreturn]] void refuse(const QString &what);
void refuseIf(const std::optional<InputError> &why);
/// The value, or refuses.
template <class Value>
Value required(Result<Value> result)
{
    if (!result)
        refuse(result.error());
    return std::move(*result);
}
/// The same of what a file says; the refusal names the file.
template <class Value>
Value requiredIn(const QString &path, Result<Value> result)
{
    if (!result)
        refuse(errorIn(path, result.error()));
    return std::move(*result);
}

/// What is wrong with a program's arguments, or with the folder that it was started in, if one is
/// not UTF-8: Qt would look for another name than the one that was meant.
std::optional<QString> refusalOfBytes(int argc, char *argv[]);

/// Does a command's work, reports what ends it, and returns the exit code.
ExitCode endOf(const QString &command, const std::function<ExitCode()> &work);

/// The lines as they are printed: UTF-8 whatever the locale, unprintable characters as their codes.
QByteArray shownLines(const QStringList &lines);
/// A result: a line on stdout.
void printLine(const QString &line);
void printLines(const QStringList &lines);
void printJson(const QJsonObject &object);
void printJson(const QJsonArray &array);
/// Flushes what is still buffered. An error where that, or anything before, could not be written: a
/// full disk shows only now.
std::optional<InputError> finishPrinting();
/// A message: a line on stderr, shortened where it is very long.
void sayLine(const QString &line);

/// The candidate that `word` most likely stands for: a few letters left out, added, changed or
/// swapped with a neighbour. Empty when none is near.
QString closestTo(const QString &word, const QStringList &candidates);

/// "; did you mean render?", or nothing.
QString suggestion(const QString &word, const QStringList &candidates);

/// Refuses a word that is none of the names; `what` it should have named: "arithmetic".
[[noreturn]] void refuseUnknown(const QString &place, const QString &what, const QString &word,
                                const QStringList &names);

/// Like refuseUnknown(), but with so many names that only the nearest are listed; `expected` says
/// what else there is.
[[noreturn]] void refuseUnknownAmongMany(const QString &place, const QString &what,
                                         const QString &word, const QStringList &names,
                                         const QString &expected);

/// Formats a table as lines with aligned columns, two blanks apart: words to the left, numbers to
/// the right. All rows have equally many cells. No line ends in blanks.
QStringList alignedRows(const std::vector<QStringList> &rows,
                        const std::function<bool(qsizetype column)> &holdsWords);

/// Shows on stderr how far a long job is: only on a terminal, only after a second; erased once the
/// job is done.
class Progress {
public:
    Progress();
    ~Progress();
    Q_DISABLE_COPY_MOVE(Progress)

    void show(const QString &state);
    /// Erases what is shown: to be called before anything is printed.
    void clear();
    /// Shows what it is told; it must not outlive this object.
    ProgressListener listener();

private:
    bool isDue() const;

    bool m_onTerminal = false;
    bool m_shown = false;
    QElapsedTimer m_sinceStart;
    qint64 m_nextShow = 1000; ///< ms since the start
};

/// Runs a job with a progress listener and returns its result; what was shown is erased at the end.
template <class Job>
auto withProgress(const Job &job)
{
    Progress progress;
    return job(progress.listener());
}

/// While an instance is alive, the first Ctrl-C asks the command to end with what it has so far; a
/// second one ends the program.
class Interruption {
public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption &) = delete;
    Interruption &operator=(const Interruption &) = delete;

    static bool isAsked();
};

} // namespace pixelplumb::cli
