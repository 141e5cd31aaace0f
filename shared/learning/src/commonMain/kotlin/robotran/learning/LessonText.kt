package robotran.learning

import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.languagesupport.LanguageSupport
import robotran.learning.hint.HintCondition

/**
 * The text of a [Lesson]. Program text is between backticks.
 *
 * @property paragraphs two to four short ones; none for the task of a [GalleryWorld].
 * @property skill what one can do after it, to stand behind "You can", such as `make it repeat`; null for the task of a
 * [GalleryWorld].
 * @property nudge the first hint: where to look.
 * @property part the second hint: a part of the solution.
 * @property solution the third hint: the whole solution in words.
 * @property whens hints for what may go wrong, in the order in which they are tried.
 * @property goals what the goals of its worlds say where an author has written that, the same in every language at the
 * same place; none if all sentences are made from figures.
 * @property again what is different in [LessonPlace.AGAIN]; null for a lesson with one place.
 */
data class LessonText(
    val title: String,
    val paragraphs: List<String>,
    val skill: String?,
    val task: String,
    val nudge: String,
    val part: String,
    val solution: String,
    val whens: List<ConditionalHint>,
    val again: String? = null,
    val goals: List<String> = emptyList(),
) {
    /** The same with its program text, in the usual words of [code], in those of [words]. */
    internal fun inWords(code: LanguageSupport, words: Language): LessonText = withCode { code.pieceInWords(it, words) }

    /** The same with its program text as [write] makes it of what is written between backticks. */
    fun withCode(write: (String) -> String): LessonText {
        val written = { text: String -> withCode(text, write) }
        return copy(
            paragraphs = paragraphs.map(written),
            skill = skill?.let(written),
            task = written(task),
            nudge = written(nudge),
            part = written(part),
            solution = written(solution),
            whens = whens.map { it.copy(text = written(it.text)) },
            again = again?.let(written),
        )
    }

    internal companion object {
        /**
         * The text of the harder variation of a world with the index [index] in [file], the text of the world: under
         * `Harder: ` and its title are its task and its three hints, a paragraph each. What may go wrong is the same.
         */
        fun ofHarder(file: String, index: Int, inBlocks: Boolean): LessonText {
            val parts = sections(sections(file).single().body, "## ")
            val harder = parts.filter { it.heading.startsWith(HARDER) }[index]
            val (task, nudge, part, solution) = paragraphsFor(inBlocks, paragraphs(harder.body))
            return of(file, inBlocks, BrickKind.default).copy(
                title = harder.heading.removePrefix(HARDER),
                task = task,
                nudge = nudge,
                part = part,
                solution = solution,
            )
        }

        /**
         * The text in [file] for a pupil who sees programs in blocks, or as text, and whose robot has a [brick]. Fails if
         * the file is invalid.
         */
        fun of(file: String, inBlocks: Boolean, brick: BrickKind): LessonText {
            val whole = sections(file).single()
            val parts = sections(whole.body, "## ").associate { it.heading to it.body }
            val shownParagraphs = { body: String -> paragraphsFor(inBlocks, paragraphsOn(brick, paragraphs(body))) }
            val under = { heading: String -> shownParagraphs(parts.getValue(heading)).joinToString(" ") }
            return LessonText(
                whole.heading,
                shownParagraphs(whole.body.substringBefore("## ")),
                if ("Skill" in parts) under("Skill") else null,
                under("Task"),
                under("Nudge"),
                under("Part"),
                under("Solution"),
                conditionalHints(parts, shownParagraphs),
                if ("Again" in parts) under("Again") else null,
                goalSentences(parts[GOALS].orEmpty()),
            )
        }
    }
}

/** A hint for a try that shows [condition]. */
data class ConditionalHint(val condition: HintCondition, val text: String)

/** The hints below the headings `When ...`. */
private fun conditionalHints(
    parts: Map<String, String>,
    shownParagraphs: (String) -> List<String>,
): List<ConditionalHint> = parts.filterKeys { it.startsWith(WHEN) }.map { (heading, body) ->
    val phrase = heading.removePrefix(WHEN)
    val condition = requireNotNull(HintCondition.of(phrase)) { "There is no condition \"$phrase\"." }
    ConditionalHint(condition, shownParagraphs(body).joinToString(" "))
}.filter { it.text.isNotEmpty() }

/** The hints in [file] that every lesson falls back on. */
internal fun commonHints(file: String): List<ConditionalHint> =
    conditionalHints(sections(file, "## ").associate { it.heading to it.body }) { paragraphs(it) }

/** The [paragraphs] for a pupil who sees programs in blocks, or as text. The mark at the start of one says for whom. */
private fun paragraphsFor(inBlocks: Boolean, paragraphs: List<String>): List<String> {
    val (own, other) = if (inBlocks) FOR_BLOCKS to FOR_TEXT else FOR_TEXT to FOR_BLOCKS
    return paragraphs.filterNot { it.startsWith(other) }.map { it.removePrefix(own).trim() }
}

/** The [paragraphs] for a pupil whose robot has a [brick]: those of the nearest brick that has any, and those of all. */
private fun paragraphsOn(brick: BrickKind, paragraphs: List<String>): List<String> {
    val own = brick.marks.map(::markFor).firstOrNull { mark -> paragraphs.any { it.startsWith(mark) } }
    val others = BrickKind.entries.map(::markFor) - setOfNotNull(own)
    return paragraphs.filterNot { text -> others.any(text::startsWith) }
        .map { text -> (if (own == null) text else text.removePrefix(own)).trim() }
}

/** [text] with the program text between its backticks in the words of [language]. */
internal fun LanguageSupport.markedInWords(text: String, language: Language): String =
    withCode(text) { pieceInWords(it, language) }

/** [text] with the program text between its backticks as [write] makes it. */
fun withCode(text: String, write: (String) -> String): String = MARKED.replace(text) { "`${write(it.groupValues[1])}`" }

private val MARKED = Regex("`([^`]*)`")

/** [text] without the backticks around program text. */
internal fun withoutBackticks(text: String): String = text.replace("`", "")

/** The heading above what the goals say. */
internal const val GOALS = "Goals"

private const val WHEN = "When "
private const val HARDER = "Harder: "
private const val FOR_TEXT = "(text) "
private const val FOR_BLOCKS = "(blocks) "

private fun markFor(brick: BrickKind) = "(${brick.name.lowercase()}) "
