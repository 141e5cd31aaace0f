package robotran.workshop.examples

import robotran.language.Language
import robotran.programs.Program
import robotran.workshop.texts.FirstProgramTexts

/** The square program, the initial program of a new project, with its note in [language], in [words]. */
fun firstProgram(language: Language, words: Language = Language.ENGLISH): Program =
    FIRST.getValue(language).inWords(words)

/**
 * Whether this is the initial program of a new project in any language, of this version or one before, and the pupil has
 * changed nothing in it.
 */
internal val Program.isFirst: Boolean
    get() {
        if (name != NAME || files.size != 1) return false
        val usual = inUsualWords()
        return usual in FIRST.values || usual.text.trimEnd() in EARLIER_FIRST_PROGRAMS
    }

private const val NAME = "square.robo"
private const val NOTE = "// "

private val FIRST: Map<Language, Program> by lazy {
    val lines = exampleTexts.getValue(NAME).substringAfter('\n')
    Language.entries.associateWith { Program.of(NAME, "$NOTE${FirstProgramTexts.note(it)}\n$lines") }
}
