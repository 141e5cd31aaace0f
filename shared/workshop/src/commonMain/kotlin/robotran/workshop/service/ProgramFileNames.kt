package robotran.workshop.service

import robotran.language.ProgramLanguage
import robotran.programs.support

/** The ending of the file [name] of a program in [language]. */
fun endingOf(name: String, language: ProgramLanguage): String = language.support.files.endingOf(name)

/** The name that the file [old] of a program in [language] gets by the input [typed], with or without ending. */
internal fun fileNameFor(typed: String, old: String, language: ProgramLanguage): String =
    endingOf(old, language).let { typed.trim().removeSuffix(it) + it }
