package robotran.ui.learning

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.IntrinsicSize
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.text.AnnotatedString
import androidx.compose.ui.text.SpanStyle
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.buildAnnotatedString
import androidx.compose.ui.unit.TextUnit
import androidx.compose.ui.unit.dp
import robotran.brick.kind.BrickKind
import robotran.programs.blockLanguage
import robotran.programs.support
import robotran.robolang.words.BlockGroup
import robotran.robolang.words.LineForm
import robotran.ui.code.BlockSigns
import robotran.ui.code.CodeColours
import robotran.ui.code.codeColours
import robotran.ui.code.rememberBlockLooks
import robotran.uikit.*

/** A short program in blocks. */
@Composable
internal fun BlocksPicture() {
    Piece(LineForm.PEN, "pen" to false, "down" to true)
    Piece(LineForm.REPEAT, "repeat" to false, "4" to true, "times" to false)
    Row(Modifier.height(IntrinsicSize.Min)) {
        val bar = rememberBlockLooks().of(BlockGroup.CONTROL).edge
        Box(Modifier.width(6.dp).fillMaxHeight().background(bar))
        Column(Modifier.padding(start = 6.dp), Arrangement.spacedBy(2.dp)) {
            Piece(LineForm.MOVE, "forward" to false, "20" to true)
            Piece(LineForm.TURN, "turn" to false, "left" to true, "90" to true)
        }
    }
}

/** A line of [form] with [words], each with whether it is in a socket. */
@Composable
private fun Piece(form: LineForm, vararg words: Pair<String, Boolean>) {
    val look = rememberBlockLooks().of(form.group)
    Row(
        Modifier
            .height(PIECE)
            .clip(Shapes.PIECE)
            .background(look.fill)
            .border(1.dp, look.edge, Shapes.PIECE)
            .padding(horizontal = 6.dp),
        Arrangement.spacedBy(4.dp),
        Alignment.CenterVertically,
    ) {
        IconView(BlockSigns.of(form, words.joinToString(" ") { it.first }), look.ink, size = 14.dp)
        for ((word, isSocket) in words) {
            val ground = Modifier.clip(Shapes.TINY).background(look.socket).padding(horizontal = 4.dp)
            Text(
                word,
                if (isSocket) ground else Modifier,
                TextStyle(fontSize = pictureSize(), lineHeight = pictureSize()),
                color = if (isSocket) look.socketInk else look.ink,
                maxLines = 1,
            )
        }
    }
}

/** The same program as text, in the colours of the editor. */
@Composable
internal fun TextPicture() {
    val colours = codeColours()
    val text = remember(colours) { PROGRAM.map { coloured(it, colours) } }
    val style = codeStyle().copy(fontSize = pictureSize(), lineHeight = pictureSize())
    for (line in text) {
        Row(Modifier.height(PIECE), verticalAlignment = Alignment.CenterVertically) {
            Text(line, style = style, maxLines = 1)
        }
    }
}

private fun coloured(line: String, colours: CodeColours): AnnotatedString = buildAnnotatedString {
    append(line)
    for (token in blockLanguage.support.code.tokens(line, startsInComment = false, BrickKind.default).tokens) {
        addStyle(SpanStyle(color = colours.of(token.kind)), token.start, token.end)
    }
}

/** A picture does not grow with the text. */
@Composable
private fun pictureSize(): TextUnit = with(LocalDensity.current) { 13.dp.toSp() }

private val PROGRAM = listOf("pen down", "repeat 4 times", "  forward 20", "  turn left 90", "end")
private val PIECE = 22.dp

/** Room for the text, which has a line more than there are blocks. */
internal val VIEW_PICTURE_HEIGHT = (PIECE + 2.dp) * 5
