package robotran.ui.program.editor

import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.PathEffect
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.graphics.drawscope.clipRect
import androidx.compose.ui.text.drawText
import androidx.compose.ui.unit.dp
import robotran.language.source.SourceRange
import robotran.languagesupport.CodeTokens
import robotran.ui.code.CodeColours
import robotran.uikit.*

/** Draws the visible lines and their markings. */
internal class EditorDrawing(
    private val paint: EditorPaint,
    private val pieces: CodeTokens,
    private val view: EditorView,
    private val layouts: LineLayouts,
    private val colours: RobotranColours,
    private val code: CodeColours,
) {
    private val draft = paint.draft
    private val marks = paint.marks
    private val caretLine = draft.lines.lineOf(draft.selection.caret)

    fun DrawScope.draw() {
        val lines = visible()
        for (line in lines) drawBand(line)
        clipRect(left = view.gutter) {
            for (line in lines) drawLine(line)
            if (paint.hasFocus && caretLine in lines) drawCaret()
        }
    }

    private fun visible(): IntRange = view.visibleLines.let { it.first..minOf(it.last, draft.lines.count - 1) }

    private fun DrawScope.drawBand(line: Int) {
        val top = view.geometry.top(line) - view.scrollY
        val band = Size(size.width, view.geometry.heightOf(line))
        if (line == caretLine && paint.hasFocus) drawRect(code.caretLine, Offset(0f, top), band)
        if (line + 1 in marks.partners) {
            drawRect(code.partner, Offset(0f, top), band)
            drawRect(colours.focus, Offset(0f, top), Size(3.dp.toPx(), band.height))
        }
        if (line + 1 == marks.runningLine || line + 1 in marks.runningPartners) {
            drawRect(colours.runningLine, Offset(0f, top), band)
        }
        if (line + 1 == marks.failedLine) drawRect(colours.errorPane, Offset(0f, top), band)
    }

    private fun DrawScope.drawLine(line: Int) {
        val laidOut = view.laidOut(line, draft, layouts, pieces)
        val top = view.geometry.top(line) - view.scrollY
        drawMatches(line, laidOut, top)
        drawSelection(line, laidOut, top)
        for (row in 0..<laidOut.rows.count) {
            val y = top + row * view.geometry.lineHeight
            if (y > size.height) break
            if (y + view.geometry.lineHeight < 0) continue
            drawText(laidOut.layout(row), topLeft = Offset(view.gutter + laidOut.left(row), y))
        }
        for (diagnostic in marks.diagnostics) {
            if (diagnostic.line == line + 1) {
                for (piece in pieces(diagnostic, laidOut)) drawWave(span(piece), bottom(top, piece), colours.error)
            }
        }
        for (warning in marks.warnings) {
            if (warning.line == line + 1) {
                for (piece in pieces(warning, laidOut)) drawDots(span(piece), bottom(top, piece), code.warning)
            }
        }
        drawComposing(line, laidOut, top)
    }

    private fun DrawScope.drawSelection(line: Int, laidOut: LaidOutLine, top: Float) {
        val selection = draft.selection
        val start = draft.lines.start(line)
        val end = draft.lines.end(line)
        if (selection.isEmpty || selection.start > end || selection.end < start) return
        val goesOn = selection.end > end
        val pieces = laidOut.pieces((selection.start - start).coerceAtLeast(0), minOf(selection.end, end) - start)
        pieces.forEachIndexed { index, piece ->
            val behind = if (goesOn && index == pieces.lastIndex) layouts.characterWidth / 2 else 0f
            val width = piece.right + behind - piece.left
            val corner = Offset(view.gutter + piece.left, top + piece.row * view.geometry.lineHeight)
            if (width > 0) drawRect(code.selection, corner, Size(width, view.geometry.lineHeight))
        }
    }

    private fun DrawScope.drawMatches(line: Int, laidOut: LaidOutLine, top: Float) {
        if (marks.matches.isEmpty()) return
        val start = draft.lines.start(line)
        val end = draft.lines.end(line)
        var index = marks.matches.binarySearch { if (it.end <= start) -1 else 1 }.let { if (it < 0) -it - 1 else it }
        while (index < marks.matches.size && marks.matches[index].start < end) {
            val match = marks.matches[index++]
            val pieces = laidOut.pieces((match.start - start).coerceAtLeast(0), minOf(match.end, end) - start)
            for (piece in pieces) drawMatch(piece, top)
        }
    }

    private fun DrawScope.drawMatch(piece: RowPiece, top: Float) {
        val y = top + piece.row * view.geometry.lineHeight + 1.dp.toPx()
        val corner = Offset(view.gutter + piece.left, y)
        val place = Size(piece.right - piece.left, view.geometry.lineHeight - 2.dp.toPx())
        val radius = CornerRadius(3.dp.toPx())
        drawRoundRect(code.match, corner, place, radius)
        drawRoundRect(code.plain, corner, place, radius, Stroke(1.dp.toPx()))
    }

    private fun DrawScope.drawComposing(line: Int, laidOut: LaidOutLine, top: Float) {
        val composing = marks.composing ?: return
        if (draft.lines.lineOf(composing.start) != line) return
        val start = draft.lines.start(line)
        for (piece in laidOut.pieces(composing.start - start, composing.end - start)) {
            val y = bottom(top, piece) - 2.dp.toPx()
            drawLine(
                code.plain,
                Offset(view.gutter + piece.left, y),
                Offset(view.gutter + piece.right, y),
                1.dp.toPx(),
            )
        }
    }

    private fun DrawScope.drawCaret() {
        val place = view.caretBounds(caretLine, draft.lines.columnOf(draft.selection.caret), draft, layouts, pieces)
        drawRect(
            colours.focus,
            Offset(place.left - 1.dp.toPx(), place.top + 1.dp.toPx()),
            Size(
                2.dp.toPx(),
                place.height - 2.dp.toPx(),
            ),
        )
    }

    private fun pieces(range: SourceRange, laidOut: LaidOutLine) = laidOut.pieces(range.column - 1, range.endColumn - 1)

    private fun bottom(top: Float, piece: RowPiece) = top + (piece.row + 1) * view.geometry.lineHeight

    private fun DrawScope.span(piece: RowPiece): Pair<Float, Float> {
        val from = view.gutter + piece.left
        return from to (view.gutter + piece.right).coerceAtLeast(from + MIN_WIDTH.toPx())
    }

    private fun DrawScope.drawDots(span: Pair<Float, Float>, bottom: Float, colour: Color) {
        val gap = 2.dp.toPx()
        val y = bottom - 2.dp.toPx()
        val dots = PathEffect.dashPathEffect(floatArrayOf(gap, gap))
        drawLine(colour, Offset(span.first, y), Offset(span.second, y), 2.dp.toPx(), pathEffect = dots)
    }
}

private fun DrawScope.drawWave(span: Pair<Float, Float>, bottom: Float, colour: Color) {
    val step = WAVE.toPx()
    val middle = bottom - step
    val wave = Path().apply {
        moveTo(span.first, middle)
        var x = span.first
        var up = true
        while (x < span.second) {
            x = (x + step).coerceAtMost(span.second)
            lineTo(x, if (up) middle - step / 2 else middle + step / 2)
            up = !up
        }
    }
    drawPath(wave, colour, style = Stroke(1.5.dp.toPx()))
}

private val WAVE = 3.dp
private val MIN_WIDTH = 9.dp
