package robotran.workshop.state

import robotran.brick.kind.BrickKind
import robotran.language.ProgramLanguage

/** What else a program can be shown as, beside its text. */
enum class TranslationKind {
    /** Robolang as Java. */
    JAVA,

    /** Robolang as NQC, for an RCX. */
    NQC,

    /** NQC as the commands that LEGO's firmware runs. */
    ASSEMBLY,
    ;

    companion object {
        /** The kinds for programs in [language] on a [brick], the usual one first; empty if there are none. */
        fun of(language: ProgramLanguage, brick: BrickKind): List<TranslationKind> = when (language) {
            ProgramLanguage.ROBOLANG -> listOfNotNull(
                JAVA.takeIf { brick.java != null },
                NQC.takeIf { brick.hasLegoFirmware },
            )
            ProgramLanguage.NQC -> listOf(ASSEMBLY)
            ProgramLanguage.JAVA, ProgramLanguage.LASM -> emptyList()
        }
    }
}
