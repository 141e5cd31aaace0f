package robotran.learning

import robotran.language.Language
import robotran.learning.hint.Attempt
import robotran.learning.hint.HintCondition
import robotran.learning.hint.HintMatch
import robotran.learning.hint.commonConditions

/** How much a hint gives away. */
enum class HintStage { NUDGE, PART, SOLUTION }

/**
 * @property text what to read; program text is between backticks.
 * @property condition what went wrong; null for a hint that does not depend on the try.
 * @property line the line of the pupil's program that it concerns, from 1; null for none.
 */
data class Hint(val stage: HintStage, val text: String, val condition: HintCondition? = null, val line: Int? = null)

/**
 * The first hint for [attempt] at the task of [lesson]. If the program is as it was given, the hint says so. Otherwise
 * the hints of the lesson (`## When ...`) are tried, in their order in its text, then those that all lessons share, in the order of [commonConditions]. If none fits, it is
 * the lesson's nudge. Null if the attempt has solved the task.
 */
fun chooseHint(lesson: Lesson, attempt: Attempt, language: Language, inBlocks: Boolean = false): Hint? {
    if (attempt.isSolved) return null
    val text = lesson.text(language, inBlocks)
    val common = sharedHints(language)
    return (common.take(1) + text.whens + common.drop(1)).firstNotNullOfOrNull { hint -> hint.condition.match(attempt)?.let { told(hint, it) } }
        ?: stagedHint(lesson, HintStage.NUDGE, language, inBlocks)
}

/** The hint of [lesson] that does not depend on a try. */
fun stagedHint(lesson: Lesson, stage: HintStage, language: Language, inBlocks: Boolean = false): Hint {
    val text = lesson.text(language, inBlocks)
    return Hint(
        stage,
        when (stage) {
            HintStage.NUDGE -> text.nudge
            HintStage.PART -> text.part
            HintStage.SOLUTION -> text.solution
        },
    )
}

private fun told(hint: ConditionalHint, match: HintMatch) =
    Hint(HintStage.NUDGE, hint.text.replace(WORD, match.word.orEmpty()), hint.condition, match.line)

/** The hints that all lessons share, in the order of [commonConditions]. */
internal fun sharedHints(language: Language): List<ConditionalHint> = shared.getOrPut(language) {
    val texts = commonHints(commonLessonTexts.getValue("hints.${language.tag}.md")).associateBy { it.condition }
    commonConditions.mapNotNull(texts::get)
}

private val shared = mutableMapOf<Language, List<ConditionalHint>>()

/** Stands for the missing word in a text. */
private const val WORD = "{word}"
