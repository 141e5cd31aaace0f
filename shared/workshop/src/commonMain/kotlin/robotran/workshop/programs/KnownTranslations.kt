package robotran.workshop.programs

import robotran.language.Language
import robotran.workshop.state.ProgramTranslation
import robotran.workshop.state.TranslationKind

/**
 * What a program was translated to.
 *
 * @property current the translations of the program as it is, once they were asked for.
 * @param old the last ones of earlier states of it.
 */
internal class KnownTranslations(private val old: Map<TranslationKind, ProgramTranslation> = emptyMap()) {
    val current = mutableMapOf<Pair<TranslationKind, Language>, ProgramTranslation?>()

    fun earlier(kind: TranslationKind): ProgramTranslation? = old[kind]

    /** Those for the same program once it has changed. */
    fun older(): KnownTranslations = KnownTranslations(old + current.values.filterNotNull().associateBy { it.kind })
}
