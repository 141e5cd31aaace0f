package robotran.ui.programlanguages

import robotran.brick.kind.BrickKind
import robotran.brick.kind.JavaPlatform
import robotran.language.ProgramLanguage
import robotran.language.ShownLanguage
import robotran.ui.texts.CommonTexts
import robotran.ui.texts.NqcTexts
import robotran.ui.texts.NxtTexts
import robotran.uikit.*

/**
 * What the screens say about one programming language.
 *
 * @property newProgram in the menu that adds programs.
 * @property hint in an empty program.
 * @property newFile adds a file to a program; null if that has only one.
 * @property removeFile removes it.
 * @property helpName what the help on its words is called on a brick, if that is not the language's own name.
 */
class LanguageTexts(
    val newProgram: Label,
    val hint: Label,
    val newFile: Label? = null,
    val removeFile: Label = NqcTexts::editorRemoveFile,
    val helpName: Map<BrickKind, Label> = emptyMap(),
)

/**
 * About programs that are shown in another language.
 *
 * @property switch the name of the switch that shows them.
 * @property label what screen readers call the text.
 * @property noneYet what is there instead before the first errors are fixed.
 */
class TranslationTexts(val switch: Label, val label: Label, val noneYet: Label)

val ProgramLanguage.texts: LanguageTexts get() = TEXTS.getValue(this)

/** What is said about programs that are shown in this language. */
val ShownLanguage.translationTexts: TranslationTexts get() = SHOWN.getValue(this)

private val TEXTS = mapOf(
    ProgramLanguage.ROBOLANG to LanguageTexts(CommonTexts::programNewRobolang, CommonTexts::programHint),
    ProgramLanguage.JAVA to LanguageTexts(
        CommonTexts::programNewJava,
        CommonTexts::programHintJava,
        CommonTexts::programNewClass,
        CommonTexts::removeClass,
        helpName = mapOf(
            BrickKind.with(JavaPlatform.LEJOS) to CommonTexts::helpJava,
            BrickKind.with(JavaPlatform.NXJ) to NxtTexts::learningHelpNxj,
        ),
    ),
    ProgramLanguage.NQC to LanguageTexts(
        NqcTexts::programNewNqc,
        NqcTexts::programHintNqc,
        NqcTexts::programNewFile,
    ),
    ProgramLanguage.LASM to LanguageTexts(NqcTexts::programNewLasm, NqcTexts::programHintLasm),
)

private val SHOWN = mapOf(
    ShownLanguage.JAVA to
        TranslationTexts(CommonTexts::translation, CommonTexts::translationLabel, CommonTexts::translationNone),
    ShownLanguage.NQC to TranslationTexts(NqcTexts::editorNqc, NqcTexts::editorNqcLabel, NqcTexts::editorNqcNone),
    ShownLanguage.LASM to
        TranslationTexts(NqcTexts::editorAssembly, NqcTexts::editorAssemblyLabel, NqcTexts::editorAssemblyNone),
    ShownLanguage.PYTHON to
        TranslationTexts(CommonTexts::python, CommonTexts::pythonLabel, CommonTexts::pythonNone),
)
