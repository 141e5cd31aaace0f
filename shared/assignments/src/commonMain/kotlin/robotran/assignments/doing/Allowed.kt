package robotran.assignments.doing

import robotran.language.ProgramLanguage
import robotran.projects.Assignment
import robotran.projects.ProjectProgram
import robotran.robolang.RobolangWords
import robotran.robolang.SourceTokenKind
import robotran.robolang.robolangTokens

private val SENSES = listOf("bumper", "light", "sensor", "button", "timer", "battery")

/**
 * The words of Robolang that an assignment can allow or not: commands, functions, and what a program can ask the robot
 * for. All others, such as `end`, `left` or `cm`, only complete these and are always allowed.
 */
val wordsToAllow: List<String> = (RobolangWords.commands - "end") + SENSES + RobolangWords.functions.keys

/**
 * The words that [programs] use and [assignment] does not allow, each once, in the order of [wordsToAllow]. Java has no
 * such words.
 */
fun forbiddenWords(assignment: Assignment, programs: List<ProjectProgram>): List<String> {
    if (assignment.words.isEmpty()) return emptyList()
    val forbidden = wordsToAllow.toSet() - assignment.words.map(::lowercaseWord).toSet()
    val used = programs.filter { it.language == ProgramLanguage.ROBOLANG }
        .flatMapTo(mutableSetOf()) { program -> program.files.flatMap { wordsOf(it.text) } }
    return wordsToAllow.filter { it in forbidden && it in used }
}

/** The languages of [programs] that [assignment] does not allow. */
fun forbiddenLanguages(assignment: Assignment, programs: List<ProjectProgram>): List<ProgramLanguage> =
    if (assignment.languages.isEmpty()) {
        emptyList()
    } else {
        programs.map { it.language }.distinct() - assignment.languages.toSet()
    }

private fun wordsOf(text: String): Set<String> = text.lineSequence().flatMapTo(mutableSetOf()) { line ->
    robolangTokens(line).filter { it.kind in WORDS }.map { lowercaseWord(line.substring(it.start, it.end)) }
}

/** Lowercases only ASCII, which Robolang's words consist of: the platforms differ on some other letters. */
private fun lowercaseWord(word: String): String =
    buildString(word.length) { word.forEach { append(if (it in 'A'..'Z') it + ('a' - 'A') else it) } }

private val WORDS = setOf(SourceTokenKind.KEYWORD, SourceTokenKind.BUILT_IN)
