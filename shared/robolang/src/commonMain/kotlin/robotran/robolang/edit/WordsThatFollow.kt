package robotran.robolang.edit

import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.languagesupport.CompletionSuffix
import robotran.robolang.RobolangWords
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.outline.PhrasePart
import robotran.robolang.outline.outlineRobolang
import robotran.robolang.words.LineForm
import robotran.robolang.words.ValueForm

/** The words behind which only those that can follow are offered. Behind others a number or a name is as likely. */
internal val OFFERING = setOf(
    "turn",
    "start",
    "turning",
    "pen",
    "wait",
    "reset",
    "clear",
    "button",
    "facing",
    "brick",
    "for",
    "left",
    "right",
)

/** The words that can follow [word] in a program for [brick], if only those are offered; null otherwise. */
internal fun followersOf(word: String, brick: BrickKind): List<String>? {
    if (word !in OFFERING) return null
    val steps = STEPS_ON.getValue(brick).filter { word in it.words }
    return steps.filter { it.line == null }.flatMap { it.next }.ifEmpty { steps.flatMap { it.next } }.distinct()
}

/** The text behind [word] at the beginning of a line; null if nothing must follow. */
internal fun suffixOfCommand(word: String): CompletionSuffix? =
    suffixOf(STEPS.filter { it.line != null && it.isFirst && word in it.words })

/** The text behind [word] at the beginning of a value, or behind an operator; null if nothing must follow. */
internal fun suffixOfValue(word: String): CompletionSuffix? = if (word in RobolangWords.operators) {
    SPACE
} else {
    suffixOf(STEPS.filter { it.line == null && it.isFirst && word in it.words })
}

/** The text behind [word] where it follows [last]; null if nothing must follow. */
internal fun suffixAfter(last: String, word: String): CompletionSuffix? =
    suffixOf(STEPS.filter { word in it.words && last in it.before && it.line?.isSetting != true })

/**
 * A word of a line or a value, or several of which one stands there.
 *
 * @property before the words that can stand before it; empty if it is the first, or if a value comes before it.
 * @property next the words that can follow; empty if a value follows, or nothing.
 * @property rest what follows in the example, with its marks.
 * @property line the form of the line; null in a value.
 */
private class Step(
    val words: List<String>,
    val isFirst: Boolean,
    val before: List<String>,
    val next: List<String>,
    val rest: String,
    val line: LineForm?,
)

private fun suffixOf(steps: List<Step>): CompletionSuffix? {
    val step = steps.firstOrNull() ?: return null
    return when {
        step.rest.startsWith(" |") -> CompletionSuffix.of(step.rest)
        step.rest.isEmpty() -> SPACE.takeIf { step.isFirst && step.line?.isOpener == true }
        step.next.size == 1 && steps.all { it.next == step.next } -> CompletionSuffix.of(" " + step.next.single())
        step.next.size > 1 && !step.isFirst -> null
        else -> SPACE
    }
}

private fun stepsOf(form: LineForm, marked: String): List<Step> {
    val example = marked.replace("|", "")
    val source = if (form.isSetting) "robot\n$example\nend" else example
    val line = outlineRobolang(
        source,
        messages = RobolangMessages.of(Language.ENGLISH),
    ).lines[if (form.isSetting) 1 else 0]
    return stepsOf(line.parts, source, line.span.start, marked.substringBefore('\n'), form)
}

private fun stepsOf(marked: String): List<Step> {
    val source = VALUE_LINE + marked.replace("|", "")
    val value = outlineRobolang(
        source,
        messages = RobolangMessages.of(Language.ENGLISH),
    ).lines.first().parts.last() as PhrasePart.Value
    return stepsOf(value.value.parts, source, VALUE_LINE.length, marked, line = null)
}

/** The words among [parts], which begin in [source] at [start]. */
private fun stepsOf(parts: List<PhrasePart>, source: String, start: Int, marked: String, line: LineForm?): List<Step> {
    val words = parts.map { part ->
        when (part) {
            is PhrasePart.Word -> listOf(part.span.textIn(source))
            is PhrasePart.Choice -> part.options
            is PhrasePart.NamePart, is PhrasePart.Text, is PhrasePart.Value -> emptyList()
        }
    }
    return parts.indices.filter { words[it].isNotEmpty() }.map { index ->
        Step(
            words[index],
            index == 0,
            words.getOrNull(index - 1).orEmpty(),
            words.getOrNull(index + 1).orEmpty(),
            behind(parts[index].span.end - start, marked),
            line,
        )
    }
}

/** What comes in [marked] behind its first [count] characters without the marks. */
private fun behind(count: Int, marked: String): String {
    var left = count
    return marked.dropWhile { it == '|' || left-- > 0 }
}

private const val VALUE_LINE = "var x = "

private val SPACE = CompletionSuffix.of(" ")

private val STEPS: List<Step> = LineForm.entries.flatMap { form -> form.marked?.let { stepsOf(form, it) }.orEmpty() } +
    ValueForm.entries.flatMap { form -> form.marked?.let(::stepsOf).orEmpty() }

private val STEPS_ON: Map<BrickKind, List<Step>> = BrickKind.entries.associateWith { brick ->
    LineForm.entries.flatMap { form -> form.exampleOn(brick)?.let { stepsOf(form, it) }.orEmpty() } +
        ValueForm.entries.flatMap { form -> form.exampleOn(brick)?.let(::stepsOf).orEmpty() }
}
