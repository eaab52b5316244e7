// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/methodmenu.h"

#include "core/methods/method.h"
#include "core/scan/choicenames.h"
#include "widgets/canvas/canvas.h"
#include "widgets/look/corewords.h"
#include "widgets/look/menuaction.h"
#include "widgets/model/runnotes.h"
#include "widgets/model/scenedocument.h"

#include <QtWidgets>

namespace pixelplumb {

namespace {

/// Greys an action that the method refuses, with its objection.
void setObjection(QAction *action, const QString &objection)
{
    action->setEnabled(objection.isEmpty());
    action->setToolTip(objection.isEmpty()
                           ? action->text()
                           : MethodMenu::tr("The method %1").arg(withTitles(objection)));
}

} // namespace

MethodMenu::MethodMenu(const WindowParts &parts, QWidget *window)
    : QMenu(tr("&Method"), window)
    , m_document(parts.document)
{
    setObjectName(u"methodMenu"_s);
    setToolTipsVisible(true);
    addMethods(parts.canvas);
    addSeparator();
    addVariants();
}

void MethodMenu::addVariants()
{
    QMenu *menu = addMenu(tr("Misprints and &typical mistakes"));
    menu->setObjectName(u"variantMenu"_s);
    menu->setToolTipsVisible(true);
    for (const Variant variant : allVariants) {
        const QString title = nameText(wordsOf(variant, SpanAxis::Free).title);
        QAction *action = addMenuAction(menu, "", title, {}, [this, variant] {
            ScanSettings settings = m_document->scene().settings;
            settings.variants = settings.variants.contains(variant)
                ? settings.variants.without(variant)
                : settings.variants.with(variant);
            m_document->setSettings(settings);
        });
        action->setObjectName(u"variant-"_s + nameText(nameOf(variant)));
        action->setCheckable(true);
        keepUpdated(m_document, &SceneDocument::sceneChanged, action, [this, action, variant] {
            const Scene &scene = m_document->scene();
            const Method *method = methodNamed(QString::fromStdString(scene.method));
            ScanSettings settings = scene.settings;
            action->setChecked(settings.variants.contains(variant));
            settings.variants = VariantSet().with(variant);
            setObjection(action, method ? method->objection(settings) : QString());
            if (!method || !action->isEnabled())
                return;
            const VariantWords &words = wordsOf(variant, method->spanAxis);
            action->setToolTip(tr("%1, in place of %2. %3\n%4")
                                   .arg(nameText(words.printed), nameText(words.right),
                                        nameText(words.fault), nameText(words.source)));
        });
    }
}

void MethodMenu::addMethods(Canvas *canvas)
{
    auto *group = new QActionGroup(this);
    int digit = 0;
    QMap<MethodFamily, QMenu *> families; // a single menu would be higher than a screen
    for (const Method &method : methods()) {
        QMenu *&family = families[method.family];
        if (!family) {
            family = addMenu(coreWord(titleOf(method.family)));
            family->setToolTipsVisible(true);
        }
        const std::string id = method.id.toStdString();
        const QKeySequence key = ++digit <= 9 ? QKeySequence(Qt::Key_0 + digit) : QKeySequence();
        QAction *action = addSwitch(
            family, "", methodTitle(method), key, [this, id] { m_document->setMethod(id); },
            m_document, &SceneDocument::sceneChanged,
            [this, id] { return m_document->scene().method == id; });
        action->setObjectName(u"method-"_s + method.id);
        group->addAction(action);
        confineKeyTo(canvas, action);
        action->setToolTip(methodSummary(method));
    }
}

} // namespace pixelplumb
