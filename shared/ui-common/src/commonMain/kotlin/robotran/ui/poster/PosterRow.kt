package robotran.ui.poster

import androidx.compose.ui.graphics.Color
import robotran.ui.code.BlockLook

/**
 * A row of blocks, measured in heights of its letters.
 *
 * @property bars the colours of the bars of the blocks around it, the outermost first.
 * @property own the part of the row in which the bar of its own block is; null if it has none.
 * @property pieces its words and values; none for an empty line and for the room in a block without blocks.
 */
internal class PosterRow(
    private val bars: List<Color>,
    private val own: ClosedFloatingPointRange<Double>?,
    private val look: BlockLook,
    private val pieces: List<PosterPiece>,
) {
    val isBlank: Boolean get() = pieces.isEmpty()

    /** The row in a column of this width: a row that is wider goes on in another line of the same block. */
    fun flow(width: Double): RowFlow {
        if (isBlank) return RowFlow(BLANK, barBoxes(BLANK), emptyList())
        val start = bars.size * INDENT
        val room = (width - start - BEFORE - BEHIND).coerceAtLeast(LEAST_ROOM)
        val placed = place(pieces.flatMap { it.cut(room) }, room)
        val height = (placed.last().line + 1) * LINE
        val right = placed.maxOf { it.left + it.piece.width } + BEFORE + BEHIND
        val body = PosterBox(PosterArea(start, 0.0, right, height), CORNER, look.fill, look.edge)
        val words = placed.map { (piece, line, left) ->
            PlacedWord(start + BEFORE + left + piece.inset, line * LINE + BASELINE, piece.text, piece.inkOn(look))
        }
        val sockets = placed.filter { it.piece.isSocket }.map { (piece, line, left) ->
            val top = line * LINE + SOCKET_TOP
            val area = PosterArea(start + BEFORE + left, top, piece.width, LINE - 2 * SOCKET_TOP)
            PosterBox(area, SOCKET_CORNER, piece.groundOn(look), piece.edgeOn(look))
        }
        val isBroken = placed.last().line > 0
        return RowFlow(height + SPACE, barBoxes(height + SPACE) + body + sockets, words, isBroken)
    }

    private fun barBoxes(height: Double): List<PosterBox> {
        val around = bars.mapIndexed { depth, colour -> barOf(depth, colour, 0.0, height) }
        val below = own?.let { barOf(bars.size, look.edge, it.start * height, it.endInclusive * height) }
        return around + listOfNotNull(below)
    }

    private fun barOf(depth: Int, colour: Color, top: Double, bottom: Double) =
        PosterBox(PosterArea(depth * INDENT, top, BAR, bottom - top + SEAM), corner = 0.0, colour)

    private fun place(pieces: List<PosterPiece>, room: Double): List<PlacedPiece> {
        var line = 0
        var left = 0.0
        return pieces.map { piece ->
            if (left > 0 && left + piece.width > room) {
                line++
                left = 0.0
            }
            PlacedPiece(piece, line, left).also { left += piece.width + BETWEEN }
        }
    }

    private data class PlacedPiece(val piece: PosterPiece, val line: Int, val left: Double)

    private companion object {
        const val INDENT = 1.1
        const val BAR = 0.7

        /** Bars overlap, so that nothing shines through between them. */
        const val SEAM = 0.04
        const val LINE = 2.0
        const val SPACE = 0.14
        const val BLANK = 1.0
        const val CORNER = 0.5
        const val BASELINE = 1.36
        const val SOCKET_TOP = 0.22
        const val SOCKET_CORNER = 0.75
        const val BEFORE = 1.0
        const val BEHIND = 0.6
        const val BETWEEN = 0.5
        const val LEAST_ROOM = 6.0
    }
}

/**
 * A row in its column: boxes from back to front, and words. All lengths are in heights of the letters.
 *
 * @property isBroken whether it takes several lines.
 */
internal class RowFlow(
    val height: Double,
    val boxes: List<PosterBox>,
    val words: List<PlacedWord>,
    val isBroken: Boolean = false,
)

internal class PlacedWord(val left: Double, val baseline: Double, val text: String, val colour: Color)

/** A word on a block, a value in its socket, or, with a [note] look, a comment. */
internal class PosterPiece(val text: String, val isSocket: Boolean, private val note: BlockLook? = null) {
    val inset: Double get() = if (isSocket) INSET else 0.0
    val width: Double get() = text.length * CODE_ADVANCE + 2 * inset

    fun inkOn(look: BlockLook): Color = note?.ink ?: if (isSocket) look.socketInk else look.ink

    fun groundOn(look: BlockLook): Color = note?.fill ?: look.socket

    fun edgeOn(look: BlockLook): Color = note?.edge ?: look.edge

    /** This piece in pieces that fit into [room], cut between words where it can be. */
    fun cut(room: Double): List<PosterPiece> {
        val characters = ((room - 2 * inset) / CODE_ADVANCE).toInt().coerceAtLeast(1)
        if (text.length <= characters) return listOf(this)
        val parts = mutableListOf("")
        for (word in text.split(' ').flatMap { it.chunked(characters) }) {
            val longer = "${parts.last()} $word".trimStart()
            if (longer.length <= characters) parts[parts.lastIndex] = longer else parts += word
        }
        return parts.map { PosterPiece(it, isSocket, note) }
    }

    private companion object {
        const val INSET = 0.55
    }
}
