package robotran.blockediting

import robotran.language.source.SourceSpan
import robotran.robolang.outline.PhrasePart
import robotran.robolang.outline.outlineRobolang
import robotran.robolang.words.ValueForm
import robotran.robolang.words.agreeing
import robotran.textediting.TextEdit

/** Edits of the words and values of a line. */
internal class PartEdits(private val program: BlockProgram) {
    fun replace(edit: BlockEdit.Replace): BlockEditResult {
        val text = edit.text.trim()
        return when (val part = program.partAt(edit.part)) {
            is PhrasePart.Value -> value(part, text)
            is PhrasePart.Choice -> choice(part, text)
            is PhrasePart.NamePart -> name(part, text)
            is PhrasePart.Text -> shownText(part, edit.text)
            is PhrasePart.Word, null -> refused(BlockEditError.NotFound)
        }
    }

    fun clear(edit: BlockEdit.ClearValue): BlockEditResult {
        val part = program.partAt(edit.part) as? PhrasePart.Value ?: return refused(BlockEditError.NotFound)
        return value(part, part.use.example)
    }

    fun move(edit: BlockEdit.MoveValue): BlockEditResult {
        val from = program.partAt(edit.from) as? PhrasePart.Value ?: return refused(BlockEditError.NotFound)
        val to = program.partAt(edit.to) as? PhrasePart.Value ?: return refused(BlockEditError.NotFound)
        if (edit.to in edit.from) return refused(BlockEditError.IntoItself)
        val text = edit.from.textIn(program.text)
        return value(to, text, if (edit.from in edit.to) emptyList() else changes(from, from.use.example))
    }

    /** @param left changes elsewhere that are made together with this one. */
    private fun value(part: PhrasePart.Value, english: String, left: List<TextEdit> = emptyList()): BlockEditResult {
        val text = program.inWords(english)
        val line = program.inWords(VALUE_LINE) + text
        val alone = outlineRobolang(line, program.messages, program.vocabulary, program.brick).lines
        val isValue = alone.size == 1 && alone.first().comment == null &&
            alone.first().parts.filterIsInstance<PhrasePart.Value>().any { it.span.length == text.length }
        if (!isValue) return refused(BlockEditError.NoValue(text, alone.first().error))
        val head = program.lineAt(part.span.start)
        // An operand with a weaker operator inside needs brackets.
        for (attempt in listOf(text, "($text)")) {
            val changes = (left + changes(part, attempt)).sortedBy { it.start }
            val start = part.span.start + left.filter { it.start < part.span.start }.sumOf { it.growth }
            val placed = SourceSpan(start, start + attempt.length)
            val after = blocksOf(changed(program.text, changes), program.messages, program)
            val now = after.partAt(placed) as? PhrasePart.Value
            if (now == null || after.lineAt(placed.start).form != head.form || now.use != part.use) continue
            val isFit = fits(after.kindOf(now.value), part.use)
            if (!isFit) return refused(checkNotNull(errorOf(part.use.kind)))
            return doneWith(program, after, changes, placed)
        }
        return refused(BlockEditError.NoValue(text, error = null))
    }

    private fun changes(part: PhrasePart.Value, text: String): List<TextEdit> =
        listOf(change(part.span, text)) + listOfNotNull(unitChange(part, text))

    /** The unit behind a number takes its singular or plural. */
    private fun unitChange(part: PhrasePart.Value, text: String): TextEdit? {
        val line = program.lineAt(part.span.start)
        val place = line.parts.indexOfFirst { it.span == part.span }
        val unit = line.parts.getOrNull(place + 1)?.takeIf { place >= 0 } ?: return null
        val word = unit.span.textIn(program.text)
        val agreeing = program.vocabulary.agreeing(word, text)
        return change(unit.span, agreeing).takeIf { word != agreeing }
    }

    private fun choice(part: PhrasePart.Choice, text: String): BlockEditResult {
        val option = part.options.firstOrNull { it.equals(text, ignoreCase = true) }
            ?: return refused(BlockEditError.NoChoice(part.options))
        val parts = program.lineAt(part.span.start).parts
        val places = keywordPlaces(program.text, parts, program.vocabulary, program.vocabulary)
        return sameForm(part.span, places.option(part.span, option)) { it is PhrasePart.Choice }
            ?: refused(BlockEditError.NoChoice(part.options))
    }

    private fun name(part: PhrasePart.NamePart, text: String): BlockEditResult = if (isName(text, program.vocabulary)) {
        sameForm(part.span, text) { it is PhrasePart.NamePart } ?: refused(BlockEditError.NoName(text))
    } else {
        refused(BlockEditError.NoName(text))
    }

    private fun shownText(part: PhrasePart.Text, text: String): BlockEditResult =
        if (text.any { it == '"' || it == '\n' || it == '\r' }) {
            refused(BlockEditError.NoText)
        } else {
            sameForm(part.span, "\"$text\"") { it is PhrasePart.Text } ?: refused(BlockEditError.NoText)
        }

    /** Puts [text] at [span]; null unless the line then has a part there for which [isRight] holds. */
    private fun sameForm(span: SourceSpan, text: String, isRight: (PhrasePart) -> Boolean): BlockEditResult? {
        val changes = listOf(change(span, text))
        val placed = SourceSpan(span.start, span.start + text.length)
        val after = blocksOf(changed(program.text, changes), program.messages, program)
        val now = after.partAt(placed) ?: return null
        // A value that is only a name has the same place as that name.
        val isKept = isRight(now) || (now as? PhrasePart.Value)?.value?.form == ValueForm.NAME
        return if (isKept) doneWith(program, after, changes, placed) else null
    }

    private fun change(span: SourceSpan, text: String) = TextEdit(span.start, span.textIn(program.text), text)

    private companion object {
        const val VALUE_LINE = "var value = "
    }
}
