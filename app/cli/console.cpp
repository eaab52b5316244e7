// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/console.h"

#include "core/grade/class/submissionfolder.h"
#include "core/grade/showntext.h"
#include "core/scene/files/inputrecord.h"
#include "core/scene/text/shortened.h"

#include <QCoreApplication>
#include <QJsonDocument>

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <vector>

namespace pixelplumb::cli {

namespace {

int printFault = 0; ///< errno of the first failure to print; 0: none

/// Writes nothing, not even a refusal, where the stream leads to an input that this would harm.
void writeBytes(std::FILE *stream, const QByteArray &bytes)
{
    if (isInput(fileno(stream)))
        return;
    const auto size = std::size_t(bytes.size());
    if (std::fwrite(bytes.constData(), 1, size, stream) != size && stream == stdout
        && printFault == 0)
        printFault = errno;
}

} // namespace

void refuse(const InputError &why) { throw Ended{ExitCode::Usage, why}; }

void refuse(const QString &what) { refuse(InputError{{}, what, {}}); }

void refuseIf(const std::optional<InputError> &why)
{
    if (why)
        refuse(*why);
}

std::optional<QString> refusalOfBytes(int argc, char *argv[])
{
    const auto isForeign = [](const QByteArray &bytes) { return !bytes.isValidUtf8(); };
    const QString expected = u"is not UTF-8; expected names in UTF-8"_s;
    for (int i = 1; i < argc; ++i) {
        if (isForeign(argv[i]))
            return u"argument %1, “%2”, "_s.arg(i).arg(escapedName(argv[i])) + expected;
    }
    std::error_code ignored;
    const std::string folder = std::filesystem::current_path(ignored).native();
    if (isForeign(QByteArray::fromStdString(folder)))
        return u"the current folder, “%1”, "_s.arg(escapedName(QByteArray::fromStdString(folder)))
            + expected;
    return std::nullopt;
}

ExitCode endOf(const QString &command, const std::function<ExitCode()> &work)
{
    try {
        return work();
    } catch (const Ended &end) {
        if (const QString why = end.why.message(); !why.isEmpty())
            sayLine(u"%1 %2: %3"_s.arg(QCoreApplication::applicationName(), command, why));
        return end.code;
    }
}

QByteArray shownLines(const QStringList &lines)
{
    QByteArray bytes;
    for (const QString &line : lines)
        bytes += escapedControls(line).toUtf8() + '\n';
    return bytes;
}

void printLine(const QString &line) { printLines({line}); }

void printLines(const QStringList &lines) { writeBytes(stdout, shownLines(lines)); }

void printJson(const QJsonObject &object)
{
    writeBytes(stdout, escapedJson(QJsonDocument(object).toJson()));
}

void printJson(const QJsonArray &array)
{
    writeBytes(stdout, escapedJson(QJsonDocument(array).toJson()));
}

std::optional<InputError> finishPrinting()
{
    if (std::fflush(stdout) != 0 && printFault == 0)
        printFault = errno;
    if (printFault == 0 && std::ferror(stdout) == 0)
        return std::nullopt;
    QString what = u"cannot be written"_s;
    if (printFault != 0)
        what += u": "_s + qt_error_string(printFault);
    return InputError{u"standard output"_s, what, {}};
}

void sayLine(const QString &line)
{
    // A word of a command line may have millions of characters; why it is refused follows it.
    constexpr qsizetype longestHalf = 2000;
    const bool isWhole = line.size() <= 2 * longestHalf;
    writeBytes(
        stderr,
        shownLines({isWhole ? line : shortened(line, longestHalf) + line.last(longestHalf)}));
}

namespace {

/// The number of letters to insert, delete, replace or swap with a neighbour to turn one word into
/// the other (Damerau 1964, restricted: no letter is touched twice).
int editDistance(const QString &a, const QString &b)
{
    const auto width = std::size_t(b.size()) + 1;
    std::vector<std::vector<int>> distance(std::size_t(a.size()) + 1, std::vector<int>(width));
    for (std::size_t i = 0; i < distance.size(); ++i) {
        for (std::size_t j = 0; j < width; ++j) {
            if (i == 0 || j == 0) {
                distance[i][j] = int(i + j);
                continue;
            }
            const QChar last = a[qsizetype(i) - 1];
            const QChar otherLast = b[qsizetype(j) - 1];
            distance[i][j] = std::min({distance[i - 1][j] + 1, distance[i][j - 1] + 1,
                                       distance[i - 1][j - 1] + (last == otherLast ? 0 : 1)});
            if (i > 1 && j > 1 && last == b[qsizetype(j) - 2] && otherLast == a[qsizetype(i) - 2])
                distance[i][j] = std::min(distance[i][j], distance[i - 2][j - 2] + 1);
        }
    }
    return distance.back().back();
}

/// The near candidates, nearest first.
QStringList nearestTo(const QString &word, const QStringList &candidates)
{
    constexpr qsizetype longestWord = 60;
    if (word.size() > longestWord)
        return {};
    // One letter is one edit away from every other.
    const int largest = word.size() < 3 ? 0 : std::max(1, int(word.size()) / 3);
    std::vector<std::pair<int, QString>> near;
    for (const QString &candidate : candidates) {
        const bool isBeginning = word.size() >= 3 && candidate.startsWith(word);
        const int distance = isBeginning ? 1 : editDistance(word.toLower(), candidate.toLower());
        if (distance <= largest)
            near.emplace_back(distance, candidate);
    }
    std::stable_sort(near.begin(), near.end(),
                     [](const auto &a, const auto &b) { return a.first < b.first; });
    QStringList nearest;
    for (const auto &[distance, candidate] : near)
        nearest += candidate;
    return nearest;
}

} // namespace

QString closestTo(const QString &word, const QStringList &candidates)
{
    return nearestTo(word, candidates).value(0);
}

QString suggestion(const QString &word, const QStringList &candidates)
{
    const QString closest = closestTo(word, candidates);
    return closest.isEmpty() ? QString() : u"; did you mean %1?"_s.arg(closest);
}

void refuseUnknown(const QString &place, const QString &what, const QString &word,
                   const QStringList &names)
{
    refuse({place, u"unknown %1 “%2”"_s.arg(what, word) + suggestion(word, names),
            u"one of "_s + names.join(u", "_s)});
}

void refuseUnknownAmongMany(const QString &place, const QString &what, const QString &word,
                            const QStringList &names, const QString &expected)
{
    constexpr qsizetype mostNamed = 3;
    const QStringList nearest = nearestTo(word, names).mid(0, mostNamed);
    const QString meant
        = nearest.isEmpty() ? QString() : u"; did you mean %1?"_s.arg(nearest.join(u" or "_s));
    refuse({place, u"unknown %1 “%2”"_s.arg(what, word) + meant, expected});
}

QStringList alignedRows(const std::vector<QStringList> &rows,
                        const std::function<bool(qsizetype column)> &holdsWords)
{
    QList<qsizetype> widths(rows.front().size(), 0);
    for (const QStringList &row : rows) {
        for (qsizetype column = 0; column < row.size(); ++column)
            widths[column] = std::max(widths[column], row[column].size());
    }
    QStringList lines;
    for (const QStringList &row : rows) {
        QStringList cells;
        for (qsizetype column = 0; column < row.size(); ++column)
            cells.append(holdsWords(column) ? row[column].leftJustified(widths[column])
                                            : row[column].rightJustified(widths[column]));
        QString line = cells.join(u"  "_s);
        while (line.endsWith(u' '))
            line.chop(1);
        lines.append(line);
    }
    return lines;
}

namespace {

constexpr qint64 betweenShows = 100; // ms
constexpr const char *eraseLine = "\r\033[K";

/// "recording: 512", "writing: 40 of 512".
QString stateText(const JobProgress &progress)
{
    const std::string_view name = nameOf(progress.phase);
    QString text = QLatin1String(name.data(), qsizetype(name.size()));
    text += u": %1"_s.arg(progress.done);
    if (progress.total > 0)
        text += u" of %1"_s.arg(progress.total);
    return text;
}

} // namespace

Progress::Progress()
    : m_onTerminal(isatty(STDERR_FILENO) != 0)
{
    m_sinceStart.start();
}

Progress::~Progress() { clear(); }

void Progress::clear()
{
    if (m_shown)
        std::fputs(eraseLine, stderr);
    m_shown = false;
}

bool Progress::isDue() const { return m_onTerminal && m_sinceStart.elapsed() >= m_nextShow; }

void Progress::show(const QString &state)
{
    if (!isDue())
        return;
    std::fputs((eraseLine + escapedControls(shortened(state)).toUtf8()).constData(), stderr);
    m_shown = true;
    m_nextShow = m_sinceStart.elapsed() + betweenShows;
}

ProgressListener Progress::listener()
{
    return [this](const JobProgress &progress) {
        if (isDue())
            show(stateText(progress));
        return true;
    };
}

namespace {

volatile std::sig_atomic_t asked = 0;

extern "C" void noteInterruption(int signal)
{
    constexpr char note[] = "\nending with what there is so far; Ctrl-C again ends at once\n";
    asked = 1;
    std::signal(signal, SIG_DFL);
    const int before = errno;
    if (write(STDERR_FILENO, note, sizeof note - 1) < 0)
        errno = before; // nobody is there to read it
}

} // namespace

Interruption::Interruption()
{
    asked = 0;
    std::signal(SIGINT, noteInterruption);
}

Interruption::~Interruption() { std::signal(SIGINT, SIG_DFL); }

bool Interruption::isAsked() { return asked != 0; }

} // namespace pixelplumb::cli
