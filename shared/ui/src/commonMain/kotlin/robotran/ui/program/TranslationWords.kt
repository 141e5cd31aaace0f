package robotran.ui.program

import org.jetbrains.compose.resources.StringResource
import robotran.ui.resources.*
import robotran.workshop.state.TranslationKind

/** The name of the switch that shows a program as this. */
internal val TranslationKind.words: StringResource
    get() = when (this) {
        TranslationKind.JAVA -> Res.string.editor_translation
        TranslationKind.NQC -> Res.string.editor_nqc
        TranslationKind.ASSEMBLY -> Res.string.editor_assembly
    }

/** What screen readers call the text. */
internal val TranslationKind.label: StringResource
    get() = when (this) {
        TranslationKind.JAVA -> Res.string.editor_translation_label
        TranslationKind.NQC -> Res.string.editor_nqc_label
        TranslationKind.ASSEMBLY -> Res.string.editor_assembly_label
    }

/** What is there instead before the first errors are fixed. */
internal val TranslationKind.noneYet: StringResource
    get() = when (this) {
        TranslationKind.JAVA -> Res.string.editor_translation_none
        TranslationKind.NQC -> Res.string.editor_nqc_none
        TranslationKind.ASSEMBLY -> Res.string.editor_assembly_none
    }
