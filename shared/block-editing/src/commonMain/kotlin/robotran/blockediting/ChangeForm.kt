package robotran.blockediting

import robotran.language.source.SourceSpan
import robotran.robolang.outline.OutlineLine
import robotran.robolang.outline.PhrasePart
import robotran.robolang.outline.outlineRobolang
import robotran.robolang.words.LineForm
import robotran.robolang.words.Vocabulary
import robotran.robolang.words.inEnglish
import robotran.textediting.TextEdit

/** The forms between which a line can change, in groups. */
private val RELATED: List<List<LineForm>> = listOf(
    listOf(LineForm.MOVE, LineForm.MOVE_FOR_TIME, LineForm.START_MOVING),
    listOf(LineForm.TURN, LineForm.TURN_FOR_TIME, LineForm.START_TURNING),
    listOf(LineForm.POWER, LineForm.POWER_OF_SIDE),
    listOf(LineForm.MOTOR, LineForm.POWER_OF_MOTOR),
    listOf(LineForm.MOTOR_TURN, LineForm.START_MOTOR_TURN),
    listOf(LineForm.WAIT, LineForm.WAIT_UNTIL),
    listOf(LineForm.BEEP, LineForm.BUZZ),
    listOf(LineForm.BREAK, LineForm.CONTINUE),
    listOf(LineForm.SHOW, LineForm.SHOW_TEXT),
    listOf(LineForm.REPEAT, LineForm.REPEAT_FOREVER, LineForm.REPEAT_WHILE, LineForm.REPEAT_UNTIL),
    listOf(LineForm.FOR, LineForm.FOR_WITH_STEP),
    listOf(LineForm.DECLARE_VARIABLE, LineForm.DECLARE_CONSTANT),
    listOf(LineForm.RETURN, LineForm.RETURN_VALUE),
)

/** The other forms that a line of [form] can take; empty if there are none. */
fun formsFor(form: LineForm): List<LineForm> = RELATED.firstOrNull { form in it }.orEmpty() - form

/** Writes the line in its new form, with the choices, names and values of the old one that fit. */
internal fun changedForm(program: BlockProgram, edit: BlockEdit.ChangeForm): BlockEditResult {
    val line = program.outline.lines.getOrNull(edit.line) ?: return refused(BlockEditError.NotFound)
    val form = line.form ?: return refused(BlockEditError.NoSuchForm)
    if (edit.form !in formsFor(form)) return refused(BlockEditError.NoSuchForm)
    val template = program.inWords(checkNotNull(edit.form.example).substringBefore('\n'))
    val span = SourceSpan(line.parts.first().span.start, line.parts.last().span.end)
    val text = filledIn(template, line, program)
    val change = TextEdit(span.start, span.textIn(program.text), text)
    return resultOf(program, listOf(change), SourceSpan(span.start, span.start + text.length))
}

private fun filledIn(template: String, line: OutlineLine, program: BlockProgram): String = buildString {
    val words = program.vocabulary
    val left = line.parts.toMutableList()
    val parts = outlineRobolang(template, program.messages, words, program.brick).lines.first().parts
    val places = keywordPlaces(template, parts, words, words)
    var position = 0
    for (part in parts) {
        append(template, position, part.span.start)
        val same = left.firstOrNull { isAlike(it, part) }
        val old = same?.span?.textIn(program.text)
        append(
            when {
                old == null -> part.span.textIn(template)

                // A word may be another one at another place.
                same is PhrasePart.Choice && words !== Vocabulary.ENGLISH ->
                    places.option(part.span, words.inEnglish(old))

                else -> old
            },
        )
        left -= setOfNotNull(same)
        position = part.span.end
    }
}

private fun isAlike(one: PhrasePart, other: PhrasePart): Boolean = when (one) {
    is PhrasePart.Choice -> other is PhrasePart.Choice && one.options == other.options
    is PhrasePart.NamePart -> other is PhrasePart.NamePart && one.role == other.role
    is PhrasePart.Value -> other is PhrasePart.Value && one.use == other.use
    is PhrasePart.Word, is PhrasePart.Text -> false
}
