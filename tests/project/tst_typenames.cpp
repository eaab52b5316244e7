// SPDX-License-Identifier: GPL-3.0-or-later

// No type name may be defined twice in one namespace: the linker silently mixes the two.

#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"

#include <QRegularExpression>
#include <QtTest>

#include <algorithm>

namespace tst_typenames {

using namespace pixelplumb;

namespace {

/// A source without comments and literals, whose braces and words are not code.
QString codeOf(QString text)
{
    static const QRegularExpression others(
        u"//[^\\n]*|/\\*.*?\\*/|R\"([^()\\s]*)\\(.*?\\)\\1\""
        "|\"(?:\\\\.|[^\"\\\\\\n])*+\"|'(?:\\\\.|[^'\\\\\\n])'"_s,
        QRegularExpression::DotMatchesEverythingOption);
    return text.replace(others, u" "_s);
}

/// The types that a source defines outside classes and functions.
struct DefinedTypes {
    QStringList names; ///< "pixelplumb::Triangle"; anonymous namespaces are skipped
    bool isBalanced = true; ///< every brace is closed, so the source was parsed correctly
};

DefinedTypes typesIn(const QString &text)
{
    static const QRegularExpression scopes(
        u"\\bnamespace(?:\\s+(?<space>[\\w:]+))?\\s*\\{"
        "|\\b(?:enum\\s+(?:class|struct)|enum|class|struct|union)\\s+"
        "(?:(?:alignas\\s*\\([^()]*\\)|\\[\\[[^\\]]*\\]\\])\\s*)*"
        "(?<type>\\w+)(?:\\s+final)?(?:\\s*:(?!:)[^;{()]*)?\\s*\\{|\\{|\\}"_s);
    DefinedTypes types;
    QList<std::optional<QString>> open; ///< the namespaces' names; nullopt for any other scope
    for (const QRegularExpressionMatch &match : scopes.globalMatch(codeOf(text))) {
        if (match.captured() == u"}") {
            if (open.isEmpty())
                return {{}, false};
            open.removeLast();
            continue;
        }
        if (match.captured().startsWith(u"namespace")) {
            open.append(match.captured(u"space"_s));
            continue;
        }
        const bool isOutside = std::ranges::all_of(
            open, [](const std::optional<QString> &space) { return space && !space->isEmpty(); });
        if (isOutside && match.hasCaptured(u"type"_s)) {
            QString name;
            for (const std::optional<QString> &space : std::as_const(open))
                name += *space + u"::"_s;
            types.names.append(name + match.captured(u"type"_s));
        }
        open.append(std::nullopt);
    }
    types.isBalanced = open.isEmpty();
    return types;
}

} // namespace

class TestTypeNames : public QObject {
    Q_OBJECT

private slots:
    void noTypeNameStandsTwiceInOneNamespace()
    {
        QMap<QString, QStringList> files; // by type name, the files that define it
        for (const char *folder : {"core", "widgets", "app", "tests"}) {
            for (const QString &path : filesBelow(QString::fromLatin1(folder))) {
                const DefinedTypes types = typesIn(textInTree(path));
                QVERIFY2(types.isBalanced, qPrintable(path));
                for (const QString &name : types.names)
                    files[name].append(path);
            }
        }
        QVERIFY(files.contains(u"pixelplumb::Triangle"_s));
        QVERIFY(files.size() > 500);
        QStringList twice;
        for (auto name = files.cbegin(); name != files.cend(); ++name) {
            if (name->size() > 1)
                twice.append(name.key() + u": "_s + name->join(u", "_s));
        }
        QVERIFY2(twice.isEmpty(), qPrintable(twice.join(u'\n')));
    }

    void definitionsAreRead_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QStringList>("expected");
        const auto add = [](const char *name, const char *text, const QStringList &expected) {
            QTest::newRow(name) << QString::fromLatin1(text) << expected;
        };
        add("each kind of type",
            "namespace a { struct S { int i; }; class C final : public B<int> { };"
            "enum E { One }; enum class F : std::uint8_t { Two }; union U { int i; }; }",
            {"a::S", "a::C", "a::E", "a::F", "a::U"});
        add("a template", "namespace a { template <class T> struct S { T t; }; }", {"a::S"});
        add("with attributes", "struct alignas(16) S { }; class [[nodiscard]] C { };", {"S", "C"});
        add("namespaces in each other", "namespace a::b { namespace c { struct S { }; } }",
            {"a::b::c::S"});
        add("after a namespace's end", "namespace a { } struct S { };", {"S"});
        add("a declaration", "namespace a { struct S; S make(struct T *t); }", {});
        add("a member's type", "struct S { struct Inner { }; }; struct S::Other { };", {"S"});
        add("a function's type", "void f() { struct S { }; }", {});
        add("a specialisation", "template <> struct S<int> { };", {});
        add("an anonymous namespace", "namespace a { namespace { struct S { }; } }", {});
        add("a comment", "// struct S {\n/* struct T { */", {});
        add("texts", "auto a = \"struct S {\"; auto b = R\"x(}\")x\"; auto c = '{'; int d = 1'000;",
            {});
    }
    void definitionsAreRead()
    {
        QFETCH(QString, text);
        QFETCH(QStringList, expected);
        const DefinedTypes types = typesIn(text);
        QVERIFY(types.isBalanced);
        QCOMPARE(types.names, expected);
    }
};

PIXELPLUMB_TEST(TestTypeNames)

} // namespace tst_typenames

#include "tst_typenames.moc"
