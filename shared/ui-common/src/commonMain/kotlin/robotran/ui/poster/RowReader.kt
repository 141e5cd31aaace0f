package robotran.ui.poster

import robotran.blockediting.Block
import robotran.blockediting.BlockProgram
import robotran.blockediting.shown.ShownLine
import robotran.blockediting.shown.ShownPiece
import robotran.language.source.SourceSpan
import robotran.robolang.outline.OutlineLine
import robotran.robolang.outline.PhrasePart
import robotran.robolang.words.inEnglish
import robotran.robolang.words.written
import robotran.ui.code.BlockLooks
import robotran.workshop.blocks.BlockRow

/** Reads rows of blocks for a poster. Values stand in one socket each, however they are put together. */
internal class RowReader(private val program: BlockProgram, private val looks: BlockLooks) {
    fun read(row: BlockRow): PosterRow {
        val block = row.block
        val pieces = when (row) {
            is BlockRow.Empty -> emptyList()
            is BlockRow.End -> listOf(PosterPiece(program.shown.written("end"), isSocket = false)) +
                noteOf(row.line)
            is BlockRow.Branch -> piecesOf(row.line) + noteOf(row.line)

            is BlockRow.First -> when (block) {
                is Block.Blank -> emptyList()
                is Block.Comment -> wordsOf(commentIn(block.head.span))
                else -> if (block.head.form == null) wordsOf(textOf(block.head.span)) else piecesOf(block.head)
            } + if (block is Block.Comment) emptyList() else noteOf(block.head)
        }
        return PosterRow(row.around.map { looks.of(it).edge }, ownBarOf(row), looks.of(block), pieces)
    }

    private fun ownBarOf(row: BlockRow): ClosedFloatingPointRange<Double>? = when (row) {
        is BlockRow.First -> if (row.block is Block.Construct) HALF..1.0 else null
        is BlockRow.Branch -> 0.0..1.0
        is BlockRow.End -> 0.0..HALF
        is BlockRow.Empty -> null
    }

    private fun piecesOf(line: OutlineLine): List<PosterPiece> {
        val shown = ShownLine(program, line)
        return shown.pieces.map { piece ->
            val part = when (piece) {
                is ShownPiece.Words -> return@map PosterPiece(piece.text, isSocket = false)
                is ShownPiece.Part -> piece.part
            }
            val unit = (part as? PhrasePart.Value)?.let { unitOf(it, line.parts.getOrNull(piece.index + 1)) }
            PosterPiece(listOfNotNull(shown.labelOf(part), unit).joinToString(" "), isSocket = part !is PhrasePart.Word)
        }
    }

    /** The unit of [value], unless the next word is that unit, such as `seconds`. */
    private fun unitOf(value: PhrasePart.Value, next: PhrasePart?): String? {
        val unit = value.use.unit ?: return null
        val shown = program.shown.written(unit)
        val word = next?.let { program.vocabulary.inEnglish(textOf(it.span)) }?.lowercase() ?: return shown
        return shown.takeIf { unit.removeSuffix("s") != word.removeSuffix("s") }
    }

    private fun noteOf(line: OutlineLine?): List<PosterPiece> =
        listOfNotNull(line?.comment).map { PosterPiece(commentIn(it), isSocket = true, note = looks.note) }

    private fun wordsOf(text: String): List<PosterPiece> =
        text.split(' ').filter { it.isNotEmpty() }.map { PosterPiece(it, isSocket = false) }

    private fun commentIn(span: SourceSpan): String = textOf(span).removePrefix("//").trim()

    private fun textOf(span: SourceSpan): String = span.textIn(program.text).trim()

    private companion object {
        const val HALF = 0.5
    }
}
