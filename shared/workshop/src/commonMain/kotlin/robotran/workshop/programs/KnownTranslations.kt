package robotran.workshop.programs

import robotran.language.Language
import robotran.language.ShownLanguage
import robotran.programs.ProgramTranslation

/**
 * What a program was translated to.
 *
 * @property current the translations of the program as it is, once they were asked for.
 * @param old the last ones of earlier states of it.
 */
internal class KnownTranslations(private val old: Map<ShownLanguage, ProgramTranslation> = emptyMap()) {
    val current = mutableMapOf<Pair<ShownLanguage, Language>, ProgramTranslation?>()

    fun earlier(to: ShownLanguage): ProgramTranslation? = old[to]

    /** Those for the same program once it has changed. */
    fun older(): KnownTranslations = KnownTranslations(old + current.values.filterNotNull().associateBy { it.language })
}
