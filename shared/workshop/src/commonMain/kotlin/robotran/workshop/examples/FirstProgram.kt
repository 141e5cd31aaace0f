package robotran.workshop.examples

import robotran.language.Language
import robotran.programs.Program
import robotran.workshop.texts.FirstProgramTexts

/** The square program, the initial program of a new project, with its note in [language]. */
fun firstProgram(language: Language): Program = FIRST.getValue(language)

/** Whether this is the initial program of a new project in any language, and the pupil has changed nothing in it. */
internal val Program.isFirst: Boolean get() = this in FIRST.values

private const val NAME = "square.robo"
private const val NOTE = "// "

private val FIRST: Map<Language, Program> by lazy {
    val lines = exampleTexts.getValue(NAME).substringAfter('\n')
    Language.entries.associateWith { Program.of(NAME, "$NOTE${FirstProgramTexts.note(it)}\n$lines") }
}
