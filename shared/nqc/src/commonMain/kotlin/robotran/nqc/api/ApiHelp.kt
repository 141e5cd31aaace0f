package robotran.nqc.api

import robotran.language.Language

/** One sentence in each language; [text] has a line such as `- en: Switches motors on.` for each. */
internal class ApiHelp(text: String) {
    private val sentences = text.lines().mapNotNull { line ->
        MARKS.firstOrNull { line.trimStart(' ', '*').startsWith(it.second) }
            ?.let { (language, mark) -> language to line.substringAfter(mark) }
    }.toMap()

    /** The sentence in [language]; in English if it is not translated. */
    fun of(language: Language): String = sentences[language] ?: sentences.getValue(Language.ENGLISH)

    private companion object {
        val MARKS = Language.entries.map { it to "- ${it.tag}: " }
    }
}
