// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/console.h"
#include "core/methods/method.h"
#include "core/scan/choicenames.h"
#include "core/scene/files/filepath.h"
#include "version.h"
#include "widgets/files/scenefiles.h"
#include "widgets/look/corewords.h"
#include "widgets/look/numberformat.h"
#include "widgets/look/paletteswitch.h"
#include "widgets/model/scenedocument.h"
#include "widgets/window/mainwindow.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QFileInfo>
#include <QIcon>
#include <QLocale>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <string_view>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

using namespace pixelplumb;

namespace {

template <class Choices>
QString listed(const Choices &choices)
{
    return namesOf(choices).join(QStringLiteral(", "));
}

struct Options {
    QCommandLineOption palette{
        QStringLiteral("palette"),
        QCoreApplication::translate("main", "Colours: light, dark or system."),
        QStringLiteral("name")};
    QCommandLineOption position{
        QStringLiteral("position"),
        QCoreApplication::translate("main", "Start with the first <steps> steps done."),
        QStringLiteral("steps")};
    QCommandLineOption column{
        QStringLiteral("column"),
        QCoreApplication::translate("main", "Start as column <x> is entered."),
        QStringLiteral("x")};
    QCommandLineOption method{QStringLiteral("method"),
                              QCoreApplication::translate("main", "Draw by this method."),
                              QStringLiteral("name")};
    QCommandLineOption arithmetic{
        QStringLiteral("arithmetic"),
        QCoreApplication::translate("main", "Instead of the scene's, one of: %1.")
            .arg(listed(allArithmetics)),
        QStringLiteral("name")};
    QCommandLineOption fillRule{
        QStringLiteral("fill-rule"),
        QCoreApplication::translate("main", "Instead of the scene's, one of: %1.")
            .arg(listed(allFillRules)),
        QStringLiteral("name")};

    QList<QCommandLineOption> all() const
    {
        return {palette, position, column, method, arithmetic, fillRule};
    }
};

/// Ends the program because an argument cannot be valid.
[[noreturn]] void refuse(const QString &what)
{
    cli::sayLine(QStringLiteral("pixelplumb: ") + what);
    std::exit(int(cli::ExitCode::Usage));
}
[[noreturn]] void refuse(const QString &option, const QString &value, const QString &expected)
{
    refuse(QStringLiteral("--%1 %2: expected %3").arg(option, value, expected));
}

qlonglong numberOf(const QCommandLineParser &parser, const QCommandLineOption &option)
{
    bool isNumber = false;
    const qlonglong number = parser.value(option).toLongLong(&isNumber);
    if (!isNumber)
        refuse(option.names().constFirst(), parser.value(option), QStringLiteral("an integer"));
    return number;
}

std::size_t stepsOf(const QCommandLineParser &parser, const Options &options)
{
    const qlonglong steps = numberOf(parser, options.position);
    if (steps < 0)
        refuse(QStringLiteral("position"), parser.value(options.position),
               QStringLiteral("0 or more"));
    return std::size_t(steps);
}

/// Replaces the scene's settings by those of the command line; this does not count as a change to
/// save.
void overrideSettings(MainWindow &window, const QCommandLineParser &parser, const Options &options)
{
    Scene scene = window.parts().document->scene();
    if (parser.isSet(options.method)) {
        const QString name = parser.value(options.method);
        if (!methodNamed(name)) {
            QStringList ids;
            for (const Method &method : methods())
                ids += method.id;
            refuse(QStringLiteral("method"), name,
                   QStringLiteral("a method that pixelplumb-cli methods lists")
                       + cli::suggestion(name, ids));
        }
        scene.method = parser.value(options.method).toStdString();
    }
    if (parser.isSet(options.arithmetic)) {
        const auto arithmetic = arithmeticNamed(parser.value(options.arithmetic).toStdString());
        if (!arithmetic)
            refuse(QStringLiteral("arithmetic"), parser.value(options.arithmetic),
                   QStringLiteral("one of ") + listed(allArithmetics));
        scene.settings.arithmetic = *arithmetic;
    }
    if (parser.isSet(options.fillRule)) {
        const auto rule = fillRuleNamed(parser.value(options.fillRule).toStdString());
        if (!rule)
            refuse(QStringLiteral("fill-rule"), parser.value(options.fillRule),
                   QStringLiteral("one of ") + listed(allFillRules));
        scene.settings.fillRule = *rule;
    }
    if (scene != window.parts().document->scene())
        window.parts().document->reset(scene);
}

void setOpeningPlace(MainWindow &window, const QCommandLineParser &parser, const Options &options,
                     const OpeningPlace &otherwise)
{
    if (parser.isSet(options.position))
        window.setOpeningPlace(stepsOf(parser, options));
    else if (parser.isSet(options.column))
        window.setOpeningPlace(OpeningColumn{numberOf(parser, options.column)});
    else
        window.setOpeningPlace(otherwise);
}

/// Opens what was named. Until then, and beside a class's grades, the first scene is shown: a large
/// file takes long, and may be faulty.
void open(MainWindow &window, const QCommandLineParser &parser, const Options &options)
{
    const auto take = [&window, &parser, &options](const OpeningPlace &place) {
        overrideSettings(window, parser, options);
        setOpeningPlace(window, parser, options, place);
    };
    window.openDefaultScene();
    take(OpeningMoment::HalfDrawn);
    QStringList paths = parser.positionalArguments();
    std::ranges::transform(paths, paths.begin(), filePath);
    if (paths.isEmpty())
        return;
    if (paths.size() > 1 || paths.constFirst().isEmpty())
        refuse(QStringLiteral("“%1”: expected one scene, or one folder of results")
                   .arg(paths.constLast()));
    if (QFileInfo(paths.constFirst()).isDir())
        return window.openResults(paths.constFirst());
    if (!window.openScene(paths.constFirst()))
        return;
    const SceneFiles *files = window.parts().files;
    if (files->isLoading())
        QObject::connect(
            files, &SceneFiles::loaded, &window, [take] { take(OpeningMoment::Finished); },
            Qt::SingleShotConnection);
    else
        take(OpeningMoment::Finished);
}

void nameApplication()
{
    QCoreApplication::setOrganizationName(QStringLiteral("Pixelplumb"));
    QCoreApplication::setApplicationName(QStringLiteral("pixelplumb"));
    QCoreApplication::setApplicationVersion(QStringLiteral(PIXELPLUMB_VERSION));
}

void describe(QCommandLineParser &parser, const Options &options)
{
    parser.setApplicationDescription(
        QCoreApplication::translate("main", "See and step through triangle scan conversion."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument(
        QStringLiteral("scene"),
        QCoreApplication::translate("main",
                                    "A scene file to open, or a folder of results of "
                                    "pixelplumb-cli grade, to look through in Grading."),
        QStringLiteral("[scene | results]"));
    parser.addOptions(options.all());
}

/// Whether only help or the version is wanted: both work without a display, where a QApplication
/// would end the program.
bool asksForWordsAlone(int argc, char *argv[])
{
    constexpr std::array<std::string_view, 6> words
        = {"--help", "-h", "-?", "--help-all", "--version", "-v"};
    return std::any_of(argv + 1, argv + argc, [&](const char *argument) {
        return std::ranges::find(words, std::string_view(argument)) != words.end();
    });
}

} // namespace

int main(int argc, char *argv[])
{
#if defined(__GLIBC__)
    // The blocks of a recorded run (64 KiB each) return to the system as soon as the run is
    // dropped, instead of piling up in the workers' heaps.
    mallopt(M_MMAP_THRESHOLD, 1 << 16);
#endif
    if (const auto refusal = cli::refusalOfBytes(argc, argv))
        refuse(*refusal);
    const bool isWindowless = asksForWordsAlone(argc, argv);
    const std::unique_ptr<QCoreApplication> application(
        isWindowless ? new QCoreApplication(argc, argv) : new QApplication(argc, argv));
    nameApplication();
    const Translation translation(QLocale::system().uiLanguages());
    keepDecimalPoint();
    const Options options;
    QCommandLineParser parser;
    describe(parser, options);
    if (!parser.parse(QCoreApplication::arguments()))
        refuse(parser.errorText());
    for (const QCommandLineOption &option : options.all()) {
        if (parser.values(option).size() > 1)
            refuse(QStringLiteral("--%1 stands twice; expected it once")
                       .arg(option.names().constFirst()));
    }
    parser.process(*application); // prints help and the version, and ends the program
    QApplication::setDesktopFileName(QStringLiteral("org.pixelplumb.Pixelplumb"));
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/icons/pixelplumb.svg")));
    const auto palette = paletteNamed(parser.value(options.palette));
    if (parser.isSet(options.palette) && !palette)
        refuse(QStringLiteral("palette"), parser.value(options.palette),
               QStringLiteral("light, dark or system"));

    MainWindow window;
    if (palette)
        window.palettes()->setForThisRun(*palette);
    open(window, parser, options);
    window.show();
    window.greet();
    window.offerRecovery();
    return QApplication::exec();
}
