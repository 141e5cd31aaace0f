package robotran.blockediting.shown

import robotran.blockediting.BlockProgram
import robotran.blockediting.keywordPlaces
import robotran.language.decimal
import robotran.robolang.outline.OutlineLine
import robotran.robolang.outline.PhrasePart

/** What stands on a block: words that belong to it, or a part of its line, with a label of its own. */
sealed interface ShownPiece {
    data class Words(val text: String) : ShownPiece

    /** @property index its place among the parts of the line or value, from 0. */
    data class Part(val part: PhrasePart, val index: Int) : ShownPiece
}

/**
 * [line] of [program] as its block shows it: in the words of [BlockProgram.shown], in the order of that language, with its
 * decimal sign. The program itself stays as it is.
 */
class ShownLine(private val program: BlockProgram, private val line: OutlineLine) {
    private val places by lazy { keywordPlaces(program.text, line.parts, program.vocabulary, program.shown) }
    private val isForeign = program.shown !== program.vocabulary

    /** The words and parts of the line in the order in which they stand on the block. */
    val pieces: List<ShownPiece> get() = pieces(line.parts, line.form)

    /** The words and parts of [value]. */
    fun piecesOf(value: PhrasePart.Value): List<ShownPiece> = pieces(value.value.parts, value.value.form)

    /** What [part] says: a word, a choice, a name, or a whole value in one line of text. */
    fun labelOf(part: PhrasePart): String = when (part) {
        is PhrasePart.NamePart, is PhrasePart.Text -> source(part)
        is PhrasePart.Word, is PhrasePart.Choice -> if (isForeign) places.written(part.span) else source(part)

        is PhrasePart.Value -> when {
            NUMBER.matches(source(part)) -> program.shown.language.decimal(source(part))
            else -> text(piecesOf(part), part.value.parts)
        }
    }

    /** What [option], an English word that may stand at [choice], says there. */
    fun optionOf(choice: PhrasePart.Choice, option: String): String = places.option(choice.span, option)

    /** The line in words, without its comment. */
    val sentence: String get() = text(pieces, line.parts)

    private fun pieces(parts: List<PhrasePart>, form: Enum<*>?): List<ShownPiece> {
        val phrase = form?.let { phraseOf(it, program.shown.language) }
            ?: return parts.mapIndexed { index, part -> ShownPiece.Part(part, index) }
        return phrase.mapNotNull { piece ->
            when (piece) {
                is PhrasePiece.Words -> ShownPiece.Words(piece.text)
                is PhrasePiece.Part -> parts.getOrNull(piece.index)?.let { ShownPiece.Part(it, piece.index) }
            }
        }
    }

    /** [pieces] in one text, with spaces where the program has them, and between those that a phrase has moved. */
    private fun text(pieces: List<ShownPiece>, parts: List<PhrasePart>): String = buildString {
        var last: ShownPiece? = null
        for (piece in pieces) {
            if (last != null && !touches(last, piece, parts)) append(' ')
            append(
                when (piece) {
                    is ShownPiece.Words -> piece.text
                    is ShownPiece.Part -> labelOf(piece.part)
                },
            )
            last = piece
        }
    }

    private fun touches(before: ShownPiece, after: ShownPiece, parts: List<PhrasePart>): Boolean =
        before is ShownPiece.Part && after is ShownPiece.Part && after.index == before.index + 1 &&
            parts[before.index].span.end == parts[after.index].span.start

    private fun source(part: PhrasePart): String = part.span.textIn(program.text)

    private companion object {
        /** A number with its sign is one value to a pupil. */
        val NUMBER = Regex("-?\\d+(\\.\\d+)?")
    }
}
