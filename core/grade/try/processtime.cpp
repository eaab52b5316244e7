// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/try/processtime.h"

#include <QDir>
#include <QFile>

#include <unistd.h>

#include <vector>

namespace pixelplumb {

using namespace Qt::StringLiterals;

namespace {

QString folderOf(pid_t process) { return u"/proc/%1"_s.arg(process); }

/// Its own time and that of the children it waited for, in ticks.
std::int64_t ticksOf(pid_t process)
{
    // After the name, which may contain anything, come the state and, in proc(5)'s counting, fields
    // 14 … 17.
    const QByteArray stat = procText(folderOf(process) + u"/stat"_s);
    const QList<QByteArray> fields = stat.mid(stat.lastIndexOf(')') + 2).split(' ');
    constexpr qsizetype firstTime = 14 - 3;
    std::int64_t ticks = 0;
    for (qsizetype i = firstTime; i < firstTime + 4 && i < fields.size(); ++i)
        ticks += fields[i].toLongLong();
    return ticks;
}

void appendChildren(pid_t process, std::vector<pid_t> &processes)
{
    const QString tasks = folderOf(process) + u"/task"_s;
    for (const QString &task : QDir(tasks).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        const QByteArray children = procText(tasks + u'/' + task + u"/children"_s);
        for (const QByteArray &child : children.simplified().split(' ')) {
            if (const pid_t number = child.toInt(); number > 0)
                processes.push_back(number);
        }
    }
}

} // namespace

std::chrono::milliseconds computedBy(pid_t ancestor)
{
    std::vector<pid_t> processes = {ancestor};
    std::int64_t ticks = 0;
    while (!processes.empty()) {
        const pid_t process = processes.back();
        processes.pop_back();
        ticks += ticksOf(process);
        appendChildren(process, processes);
    }
    return std::chrono::milliseconds(1000 * ticks / sysconf(_SC_CLK_TCK));
}

QByteArray procText(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace pixelplumb
