package robotran.assignments.doing

import robotran.language.ProgramLanguage
import robotran.projects.Assignment
import robotran.projects.ProjectProgram

/** What a pupil's program has that the assignment does not allow. */
sealed interface NotAllowed {
    /** The name of the program. */
    val program: String

    /** The program is in another [language]. */
    data class InLanguage(override val program: String, val language: ProgramLanguage) : NotAllowed

    /** The program has [word] in its line [line], from 1, and maybe in others. */
    data class HasWord(override val program: String, val word: String, val line: Int) : NotAllowed
}

/** All that [assignment] does not allow in [programs]; each word once for each program. */
fun notAllowedIn(assignment: Assignment, programs: List<ProjectProgram>): List<NotAllowed> =
    programs.flatMap { program ->
        val hasLanguage = forbiddenLanguages(assignment, listOf(program)).isEmpty()
        val other = if (hasLanguage) emptyList() else listOf(NotAllowed.InLanguage(program.name, program.language))
        val words = forbiddenWords(assignment, listOf(program))
        val lines = if (words.isEmpty()) emptyList() else wordsOfLines(program.files.first().text)
        other + words.map { word ->
            NotAllowed.HasWord(program.name, word, maxOf(0, lines.indexOfFirst { word in it }) + 1)
        }
    }
