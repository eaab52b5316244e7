// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/programs/tablefolder.h"

#include "tests/support/sourcetree.h"

#include <QBuffer>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStandardPaths>

namespace pixelplumb {

namespace {

constexpr std::array allLevels = {TraceLevel::SetUp, TraceLevel::Column, TraceLevel::Pixel};

/// Why a text is not the JSON of a table with these columns and this many rows; empty if it is.
QString jsonFault(const QByteArray &text, const QStringList &names, qsizetype rowCount)
{
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(text, &error);
    if (error.error != QJsonParseError::NoError)
        return error.errorString() + u": "_s
            + QString::fromUtf8(text.mid(std::max(0, error.offset - 40), 80));
    const QJsonArray rows = document[u"rows"_s].toArray();
    if (rows.size() != rowCount)
        return u"%1 rows in JSON, %2 in CSV"_s.arg(rows.size()).arg(rowCount);
    for (const QJsonValue &row : rows) {
        if (row.toObject().size() != names.size())
            return u"an object has %1 of %2 columns"_s.arg(row.toObject().size()).arg(names.size());
    }
    return {};
}

struct Table {
    QByteArray csv;
    QByteArray json;
};

QString faultOfTable(const Table &table, const TracedScene &traced, TraceLevel level)
{
    const QStringList names = traceColumnNames(traced.trace->numbers(), level);
    // No cell of these tables contains a line break.
    const QString fault = jsonFault(table.json, names, table.csv.count('\n') - 1);
    if (!fault.isEmpty())
        return u"level %1: %2"_s.arg(int(level)).arg(fault);
    if (exported(traced, {level, TableFormat::Text}).isEmpty())
        return u"level %1: no text"_s.arg(int(level));
    return {};
}

Table tableOf(const TracedScene &traced, TraceLevel level)
{
    return {exported(traced, {level, TableFormat::Csv}),
            exported(traced, {level, TableFormat::Json})};
}

} // namespace

QByteArray exported(const TracedScene &traced, const TraceExportOptions &options)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    return exportTrace(traced, options, buffer) ? bytes : QByteArray();
}

QString TableFolder::faultOf(const TracedScene &traced) const
{
    for (const TraceLevel level : allLevels) {
        const QString fault = faultOfTable(tableOf(traced, level), traced, level);
        if (!fault.isEmpty())
            return fault;
    }
    return {};
}

QString TableFolder::faultOfKept(const TracedScene &traced, const QString &name)
{
    for (const TraceLevel level : allLevels) {
        const Table table = tableOf(traced, level);
        const QString fault = faultOfTable(table, traced, level);
        if (!fault.isEmpty())
            return fault;
        const QString path = m_folder.filePath(u"%1-%2"_s.arg(name).arg(int(level)));
        for (const auto &[ending, bytes] :
             {std::pair(u".csv"_s, table.csv), {u".json"_s, table.json}}) {
            QFile file(path + ending);
            if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
                return file.errorString();
            ++m_kept;
        }
    }
    return {};
}

QString TableFolder::faultByPython() const
{
    const QString python = QStandardPaths::findExecutable(u"python3"_s);
    if (python.isEmpty())
        return u"python3 is one of the tests' packages"_s;
    QProcess process;
    process.start(python, {resource(u"/../tests/support/readtables.py"_s), m_folder.path()});
    process.waitForFinished(-1);
    const QByteArray read = process.readAllStandardOutput().trimmed();
    if (process.exitCode() != 0 || read != QByteArray::number(m_kept))
        return u"%1 of %2 tables read. "_s.arg(QString::fromUtf8(read)).arg(m_kept)
            + QString::fromUtf8(process.readAllStandardError());
    return {};
}

} // namespace pixelplumb
