package robotran.learning

import robotran.language.Language
import robotran.learning.hint.Attempt
import robotran.learning.hint.HintCondition
import robotran.learning.hint.HintMatch
import robotran.learning.hint.commonConditions
import robotran.programs.support

/** How much a hint gives away. */
enum class HintStage { NUDGE, PART, SOLUTION }

/**
 * @property text what to read; program text is between backticks.
 * @property textInBlocks the same for a pupil who sees programs in blocks.
 * @property condition what went wrong; null for a hint that does not depend on the try.
 * @property line the line of the pupil's program that it concerns, from 1; null for none.
 */
data class Hint(
    val stage: HintStage,
    val text: String,
    val textInBlocks: String = text,
    val condition: HintCondition? = null,
    val line: Int? = null,
)

/**
 * The first hint for [attempt] at the task of [lesson]. If the program is as it was given, the hint says so; if it has
 * reached the goals in the lesson's other place, what it lacks for this one. Otherwise the hints of the lesson (`## When ...`) are tried, in their order in its text, then those that all lessons share, in
 * the order of [commonConditions]. If none fits, it is the lesson's nudge. Null if the attempt has solved the task.
 *
 * @param words the language whose words program text in the hint has.
 */
fun chooseHint(lesson: Lesson, attempt: Attempt, language: Language, words: Language = Language.ENGLISH): Hint? {
    if (attempt.isSolved) return null
    val common = sharedHints(language).map { HintForViews(it, it) }
    val whens = lesson.text(language).whens
    val own = whens.zip(lesson.text(language, inBlocks = true).whens, ::HintForViews)
    val code = lesson.programLanguage.support
    val (again, others) = (own + common.drop(1)).partition { it.text.condition.phrase == HintCondition.AGAIN }
    return (common.take(1) + again + others).firstNotNullOfOrNull { hint ->
        hint.text.condition.match(attempt)?.let { match -> hintOf(hint, match) { code.markedInWords(it, words) } }
    } ?: stagedHint(lesson, HintStage.NUDGE, language, words)
}

/** The hint of [lesson] that does not depend on a try. */
fun stagedHint(lesson: Lesson, stage: HintStage, language: Language, words: Language = Language.ENGLISH): Hint {
    fun LessonText.hint() = when (stage) {
        HintStage.NUDGE -> nudge
        HintStage.PART -> part
        HintStage.SOLUTION -> solution
    }
    return Hint(
        stage,
        lesson.text(language, words = words).hint(),
        lesson.text(language, inBlocks = true, words).hint(),
    )
}

private class HintForViews(val text: ConditionalHint, val blocks: ConditionalHint)

private fun hintOf(hint: HintForViews, match: HintMatch, written: (String) -> String): Hint {
    fun ConditionalHint.filled() = written(text.replace(WORD, match.word.orEmpty()))
    return Hint(HintStage.NUDGE, hint.text.filled(), hint.blocks.filled(), hint.text.condition, match.line)
}

/** The hints that all lessons share, in the order of [commonConditions]. */
internal fun sharedHints(language: Language): List<ConditionalHint> = shared.getOrPut(language) {
    val texts = commonHints(commonLessonTexts.translated("hints", language)).associateBy { it.condition }
    commonConditions.mapNotNull(texts::get)
}

private val shared = mutableMapOf<Language, List<ConditionalHint>>()

/** Stands for the missing word in a text. */
private const val WORD = "{word}"
