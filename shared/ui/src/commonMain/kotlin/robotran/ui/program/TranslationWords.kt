package robotran.ui.program

import robotran.ui.texts.EditorTexts
import robotran.ui.texts.Label
import robotran.ui.texts.NqcTexts
import robotran.workshop.state.TranslationKind

/** The name of the switch that shows a program as this. */
internal val TranslationKind.words: Label
    get() = when (this) {
        TranslationKind.JAVA -> EditorTexts::translation
        TranslationKind.NQC -> NqcTexts::editorNqc
        TranslationKind.ASSEMBLY -> NqcTexts::editorAssembly
    }

/** What screen readers call the text. */
internal val TranslationKind.label: Label
    get() = when (this) {
        TranslationKind.JAVA -> EditorTexts::translationLabel
        TranslationKind.NQC -> NqcTexts::editorNqcLabel
        TranslationKind.ASSEMBLY -> NqcTexts::editorAssemblyLabel
    }

/** What is there instead before the first errors are fixed. */
internal val TranslationKind.noneYet: Label
    get() = when (this) {
        TranslationKind.JAVA -> EditorTexts::translationNone
        TranslationKind.NQC -> NqcTexts::editorNqcNone
        TranslationKind.ASSEMBLY -> NqcTexts::editorAssemblyNone
    }
