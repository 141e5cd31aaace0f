package robotran.assignments.doing

import robotran.language.ProgramLanguage
import robotran.languagesupport.CodeTokenKind
import robotran.programs.support
import robotran.projects.Assignment
import robotran.projects.ProjectProgram
import robotran.robolang.RobolangWords
import robotran.robolang.robolangTokensOfLines
import robotran.robolang.words.vocabularyOf

private val SENSES = listOf(
    "bumper",
    "light",
    "sensor",
    "button",
    "timer",
    "battery",
    "distance",
    "loudness",
    "colour",
    "turned",
)

/**
 * The words of Robolang that an assignment can allow or not: commands, functions, and what a program can ask the robot
 * for. All others, such as `end`, `left` or `cm`, only complete these and are always allowed.
 */
val wordsToAllow: List<String> = (RobolangWords.commands - "end") + SENSES + RobolangWords.functions.keys

/**
 * The words that [programs] use and [assignment] does not allow, each once, in the order of [wordsToAllow]. Other
 * languages than Robolang have no such words.
 */
fun forbiddenWords(assignment: Assignment, programs: List<ProjectProgram>): List<String> {
    if (assignment.words.isEmpty()) return emptyList()
    val forbidden = wordsToAllow.toSet() - assignment.words.mapNotNull { RobolangWords.spellingOf(it) }.toSet()
    val used = programs.filter { it.language.support.hasBlocks }
        .flatMapTo(mutableSetOf()) { program -> program.files.flatMap { wordsOfLines(it.text).flatten() } }
    return wordsToAllow.filter { it in forbidden && it in used }
}

/** The languages of [programs] that [assignment] does not allow. */
fun forbiddenLanguages(assignment: Assignment, programs: List<ProjectProgram>): List<ProgramLanguage> =
    if (assignment.languages.isEmpty()) {
        emptyList()
    } else {
        programs.map { it.language }.distinct() - assignment.languages.toSet()
    }

/**
 * The words of each line of [program], in their usual English spelling. A word that the program uses as a name is none.
 */
internal fun wordsOfLines(program: String): List<Set<String>> {
    val text = program.removePrefix(BYTE_ORDER_MARK)
    val vocabulary = vocabularyOf(text)
    return text.lines().zip(robolangTokensOfLines(text)) { line, tokens ->
        tokens.filter { it.kind in WORDS }.mapNotNullTo(mutableSetOf()) {
            RobolangWords.spellingOf(line.substring(it.start, it.end), vocabulary)
        }
    }
}

private const val BYTE_ORDER_MARK = "\uFEFF"
private val WORDS = setOf(CodeTokenKind.KEYWORD, CodeTokenKind.BUILT_IN)
