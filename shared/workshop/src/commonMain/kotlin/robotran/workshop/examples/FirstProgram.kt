package robotran.workshop.examples

import robotran.language.Language
import robotran.programs.Program
import robotran.workshop.texts.FirstProgramTexts

/** The square program, the initial program of a new project, with its note in [language]. */
fun firstProgram(language: Language): Program = FIRST.getValue(language)

/**
 * Whether this is the initial program of a new project in any language, of this version or one before, and the pupil has
 * changed nothing in it.
 */
internal val Program.isFirst: Boolean
    get() = this in FIRST.values || (name == NAME && files.size == 1 && text.trimEnd() in EARLIER_FIRST_PROGRAMS)

private const val NAME = "square.robo"
private const val NOTE = "// "

private val FIRST: Map<Language, Program> by lazy {
    val lines = exampleTexts.getValue(NAME).substringAfter('\n')
    Language.entries.associateWith { Program.of(NAME, "$NOTE${FirstProgramTexts.note(it)}\n$lines") }
}
