// SPDX-License-Identifier: GPL-3.0-or-later

// The folders of core have an order, the folders of widgets another, the rooms of a large folder
// one of their own, and no include points upward: to read a file, one needs to have read only what
// is below it.

#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"

#include <QRegularExpression>
#include <QtTest>

#include <algorithm>
#include <map>

namespace tst_folderorder {

using namespace pixelplumb;

namespace {

/// Folders of equal rank do not know each other.
using FolderOrder = QList<QStringList>;

/// A library: its folders by rank, lowest first, the libraries that it may include, and the rooms
/// of its large folders, lowest first; "" stands for the files that are in no room.
struct Library {
    QString name;
    FolderOrder order;
    QStringList below;
    std::map<QString, QStringList> rooms;
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
          {"shade"},
          {"plan"},
          {"fast", "oracle", "trace"},
          {"methods"},
          {"scene"},
          {"runs"},
          {"layers"},
          {"check", "export", "measure"},
          {"compare", "grade"},
          {"lab"}},
         {},
         {{"grade",
           {"", "pictures", "rounding", "scan", "bugs", "try", "diagnose", "hunt", "class"}},
          {"lab", {"counting", "contenders", "judging", "families", "study"}},
          {"methods",
           {"words", "", "shading", "lines", "walks", "tests", "curves", "polygons", "table"}},
          {"runs", {"", "explain"}},
          {"scan",
           {"", "walks", "mistakes", "tests", "interpolation", "lines", "curves", "polygons"}},
          {"scene", {"text", "files", "", "fields"}},
          {"shade", {"", "strokes"}}}},
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
         {"core"},
         {{"studies", {"", "compare", "cases", "accuracy", "cost", "grade"}}}},
    };
    return all;
}

/// The names in quotes of a source's include directives.
QStringList includesOf(const QString &text)
{
    static const QRegularExpression directive(u"^[ \\t]*#[ \\t]*include[ \\t]+\"([^\"]+)\""_s,
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

/// The room of a file's path, "core/scan/edgeline.h" or "core/methods/lines/lines.h"; "" if none.
QString roomOf(const QString &path)
{
    return path.count(u'/') < 3 ? QString() : path.section(u'/', 2, -2);
}

/// Why a file in a room of the folder may not include one in another room; empty if it may.
QString complaintAboutRoom(const QStringList &rooms, const QString &room, const QString &other)
{
    for (const QString &named : {room, other}) {
        if (!rooms.contains(named))
            return u"the room \"%1\" has no place in the order"_s.arg(named);
    }
    return rooms.indexOf(other) <= rooms.indexOf(room)
        ? QString()
        : u"the room \"%1\" does not stand below \"%2\""_s.arg(other, room);
}

/// Why the source at a path may not include the file; empty if it may.
QString complaintAbout(const Library &library, const QString &path, const QString &included)
{
    const QString folder = path.section(u'/', 1, 1);
    const QString otherLibrary = included.section(u'/', 0, 0);
    if (library.below.contains(otherLibrary) || included.endsWith(u".moc"_s))
        return {};
    if (otherLibrary != library.name)
        return u"not a path of %1 or of a library below it"_s.arg(library.name);
    const QString other = included.section(u'/', 1, 1);
    const qsizetype rank = rankOf(library.order, folder);
    const qsizetype otherRank = rankOf(library.order, other);
    if (rank < 0 || otherRank < 0)
        return u"%1 has no place in the order"_s.arg(rank < 0 ? folder : other);
    if (other != folder)
        return otherRank < rank ? QString() : u"%1 does not stand below %2"_s.arg(other, folder);
    const auto rooms = library.rooms.find(folder);
    return complaintAboutRoom(rooms == library.rooms.end() ? QStringList(QString()) : rooms->second,
                              roomOf(path), roomOf(included));
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
            seen.insert(path.section(u'/', 1, 1));
            seen.insert(path.section(u'/', 1, 1) + u'/' + roomOf(path));
            for (const QString &included : includesOf(textInTree(path))) {
                const QString complaint = complaintAbout(checked, path, included);
                if (!complaint.isEmpty())
                    complaints.append(path + u' ' + included + u": "_s + complaint);
            }
        }
        QVERIFY2(complaints.isEmpty(), qPrintable(complaints.join(u'\n')));
        // An order that names a missing folder would check nothing.
        for (const QStringList &folders : checked.order) {
            for (const QString &folder : folders)
                QVERIFY2(seen.contains(folder), qPrintable(folder));
        }
        for (const auto &[folder, rooms] : checked.rooms) {
            for (const QString &room : rooms)
                QVERIFY2(seen.contains(folder + u'/' + room), qPrintable(folder + u'/' + room));
        }
    }

    void whatLooksUpIsFound_data()
    {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("directive");
        QTest::addColumn<bool>("allowed");
        const QString scan = u"core/scan/tests/edgetest.h"_s;
        const QString rows = u"core/methods/lines/linenumbers.cpp"_s;
        const auto add
            = [](const char *name, const QString &path, const char *directive, bool allowed) {
                  QTest::newRow(name) << path << QString(directive) << allowed;
              };
        add("down", scan, "#include \"core/number/integer.h\"\n", true);
        add("its own folder", scan, "#include \"core/scan/interval.h\"\n", true);
        add("the standard library", scan, "#include <vector>\n", true);
        add("up", scan, "#include \"core/trace/scantrace.h\"\n", false);
        add("up, after blanks", scan, "\n  #  include \"core/runs/tracedscene.h\"\n", false);
        add("the same rank", "core/frame/frameview.h", "#include \"core/polygons/contours.h\"\n",
            false);
        add("the library above", "core/compare/deviation.h", "#include \"widgets/look/signs.h\"\n",
            false);
        add("a folder without place", scan, "#include \"core/elsewhere/thing.h\"\n", false);
        add("no full path", scan, "#include \"edgeline.h\"\n", false);
        add("its own room", rows, "#include \"core/methods/lines/linestate.h\"\n", true);
        add("a room below", rows, "#include \"core/methods/words/rejectiontext.h\"\n", true);
        add("a room above", rows, "#include \"core/methods/polygons/text.h\"\n", false);
        add("a room without place", rows, "#include \"core/methods/elsewhere/text.h\"\n", false);
    }
    void whatLooksUpIsFound()
    {
        QFETCH(QString, path);
        QFETCH(QString, directive);
        QFETCH(bool, allowed);
        const bool isClean
            = std::ranges::all_of(includesOf(directive), [&path](const QString &included) {
                  return complaintAbout(libraries().front(), path, included).isEmpty();
              });
        QCOMPARE(isClean, allowed);
    }
};

PIXELPLUMB_TEST(TestFolderOrder)

} // namespace tst_folderorder

#include "tst_folderorder.moc"
