// SPDX-License-Identifier: GPL-3.0-or-later

// The folders of core have an order, the folders of widgets another, and no include points upward:
// to read a file, one needs to have read only what is below it.

#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"

#include <QRegularExpression>
#include <QtTest>

#include <algorithm>

namespace tst_folderorder {

using namespace pixelplumb;

namespace {

/// Folders of equal rank do not know each other.
using FolderOrder = QList<QStringList>;

/// A library: its folders by rank, lowest first, and the libraries that it may include.
struct Library {
    QString name;
    FolderOrder order;
    QStringList below;
};

const QList<Library> &libraries()
{
    static const QList<Library> all = {
        {"core",
         {{"number"},
          {"geometry"},
          {"frame", "polygons"},
          {"space"},
          {"scan"},
          {"effects"},
          {"fast", "oracle", "trace"},
          {"methods"},
          {"scene"},
          {"runs"},
          {"layers"},
          {"check", "export", "measure"},
          {"compare", "grade"},
          {"lab"}},
         {}},
        {"widgets",
         {{"look"},
          {"model"},
          {"dialogs", "inspect", "space"},
          {"canvas"},
          {"files"},
          {"studies"},
          {"lab"},
          {"stepping"},
          {"window"}},
         {"core"}},
    };
    return all;
}

/// The names in quotes of a source's include directives.
QStringList includesOf(const QString &text)
{
    static const QRegularExpression directive(
        QStringLiteral("^[ \\t]*#[ \\t]*include[ \\t]+\"([^\"]+)\""),
        QRegularExpression::MultilineOption);
    QStringList names;
    for (const QRegularExpressionMatch &match : directive.globalMatch(text))
        names.append(match.captured(1));
    return names;
}

qsizetype rankOf(const FolderOrder &order, const QString &folder)
{
    const auto rank = std::ranges::find_if(
        order, [&folder](const QStringList &folders) { return folders.contains(folder); });
    return rank == order.end() ? -1 : rank - order.begin();
}

/// Why a source in this folder may not include the file; empty if it may.
QString complaintAbout(const Library &library, const QString &folder, const QString &included)
{
    const QString otherLibrary = included.section(u'/', 0, 0);
    if (library.below.contains(otherLibrary) || included.endsWith(QStringLiteral(".moc")))
        return {};
    if (otherLibrary != library.name)
        return QStringLiteral("not a path of %1 or of a library below it").arg(library.name);
    const QString other = included.section(u'/', 1, 1);
    const qsizetype rank = rankOf(library.order, folder);
    const qsizetype otherRank = rankOf(library.order, other);
    if (rank < 0 || otherRank < 0)
        return QStringLiteral("%1 has no place in the order").arg(rank < 0 ? folder : other);
    if (other != folder && otherRank >= rank)
        return QStringLiteral("%1 does not stand below %2").arg(other, folder);
    return {};
}

} // namespace

class TestFolderOrder : public QObject {
    Q_OBJECT

private slots:
    void noIncludeLooksUp_data()
    {
        QTest::addColumn<qsizetype>("library");
        for (qsizetype i = 0; i < libraries().size(); ++i)
            QTest::newRow(qPrintable(libraries()[i].name)) << i;
    }
    void noIncludeLooksUp()
    {
        QFETCH(qsizetype, library);
        const Library &checked = libraries()[library];
        QStringList complaints;
        QSet<QString> seen;
        for (const QString &path : filesBelow(checked.name)) {
            const QString folder = path.section(u'/', 1, 1);
            seen.insert(folder);
            for (const QString &included : includesOf(textInTree(path))) {
                const QString complaint = complaintAbout(checked, folder, included);
                if (!complaint.isEmpty())
                    complaints.append(path + u' ' + included + QStringLiteral(": ") + complaint);
            }
        }
        QVERIFY2(complaints.isEmpty(), qPrintable(complaints.join(u'\n')));
        // An order that names a missing folder would check nothing.
        for (const QStringList &folders : checked.order) {
            for (const QString &folder : folders)
                QVERIFY2(seen.contains(folder), qPrintable(folder));
        }
    }

    void whatLooksUpIsFound_data()
    {
        QTest::addColumn<QString>("folder");
        QTest::addColumn<QString>("directive");
        QTest::addColumn<bool>("allowed");
        const auto add
            = [](const char *name, const char *folder, const char *directive, bool allowed) {
                  QTest::newRow(name) << QString(folder) << QString(directive) << allowed;
              };
        add("down", "scan", "#include \"core/number/integer.h\"\n", true);
        add("its own folder", "scan", "#include \"core/scan/edgeline.h\"\n", true);
        add("the standard library", "scan", "#include <vector>\n", true);
        add("up", "scan", "#include \"core/trace/scantrace.h\"\n", false);
        add("up, after blanks", "scan", "\n  #  include \"core/runs/tracedscene.h\"\n", false);
        add("the same rank", "frame", "#include \"core/polygons/contours.h\"\n", false);
        add("the library above", "compare", "#include \"widgets/look/signs.h\"\n", false);
        add("a folder without place", "scan", "#include \"core/elsewhere/thing.h\"\n", false);
        add("no full path", "scan", "#include \"edgeline.h\"\n", false);
    }
    void whatLooksUpIsFound()
    {
        QFETCH(QString, folder);
        QFETCH(QString, directive);
        QFETCH(bool, allowed);
        const bool isClean
            = std::ranges::all_of(includesOf(directive), [&folder](const QString &included) {
                  return complaintAbout(libraries().front(), folder, included).isEmpty();
              });
        QCOMPARE(isClean, allowed);
    }
};

PIXELPLUMB_TEST(TestFolderOrder)

} // namespace tst_folderorder

#include "tst_folderorder.moc"
