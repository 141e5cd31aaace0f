package robotran.learning

import robotran.language.Language

/**
 * A row of lessons that build on each other.
 *
 * @property name the name of its folder, such as `drive`.
 */
class Strand internal constructor(val name: String, val lessons: List<Lesson>) {
    /** What the strand is called. */
    fun title(language: Language): String = strandTexts(language).getValue(name).first()

    /** What one learns in it, in one sentence. */
    fun about(language: Language): String = strandTexts(language).getValue(name).last()
}

/** The names of all strands, in their order in the file. */
internal fun strandNames(): List<String> = strandTexts(Language.ENGLISH).keys.toList()

private fun strandTexts(language: Language): Map<String, List<String>> = texts.getOrPut(language) {
    sections(commonLessonTexts.translated("strands", language)).associate { it.heading to paragraphs(it.body) }
}

private val texts = mutableMapOf<Language, Map<String, List<String>>>()
