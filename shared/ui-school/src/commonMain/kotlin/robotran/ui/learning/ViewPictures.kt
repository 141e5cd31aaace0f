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
import robotran.language.Language
import robotran.programs.blockLanguage
import robotran.programs.support
import robotran.robolang.words.BlockGroup
import robotran.robolang.words.LineForm
import robotran.ui.code.BlockSigns
import robotran.ui.code.CodeColours
import robotran.ui.code.codeColours
import robotran.ui.code.rememberBlockLooks
import robotran.uikit.*

/** A short program in blocks, in the words of the app's language. */
@Composable
internal fun BlocksPicture() {
    Piece(LineForm.PEN, PROGRAM[0], sockets = setOf(1))
    Piece(LineForm.REPEAT, PROGRAM[1], sockets = setOf(1))
    Row(Modifier.height(IntrinsicSize.Min)) {
        val bar = rememberBlockLooks().of(BlockGroup.CONTROL).edge
        Box(Modifier.width(6.dp).fillMaxHeight().background(bar))
        Column(Modifier.padding(start = 6.dp), Arrangement.spacedBy(2.dp)) {
            Piece(LineForm.MOVE, PROGRAM[2], sockets = setOf(1))
            Piece(LineForm.TURN, PROGRAM[3], sockets = setOf(1, 2))
        }
    }
}

/** The [line] of [form]; the words at [sockets] are in sockets. */
@Composable
private fun Piece(form: LineForm, line: String, sockets: Set<Int>) {
    val language = LocalLanguage.current
    val words = remember(line, language) { inWordsOf(language, line).trim().split(' ') }
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
        IconView(BlockSigns.of(form, line.trim()), look.ink, size = 14.dp)
        words.forEachIndexed { index, word ->
            val isSocket = index in sockets
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
    val language = LocalLanguage.current
    val text = remember(colours, language) { PROGRAM.map { coloured(inWordsOf(language, it), colours) } }
    val style = codeStyle().copy(fontSize = pictureSize(), lineHeight = pictureSize())
    for (line in text) {
        Row(Modifier.height(PIECE), verticalAlignment = Alignment.CenterVertically) {
            Text(line, style = style, maxLines = 1)
        }
    }
}

private fun inWordsOf(language: Language, line: String): String {
    val words = line.trimStart()
    return line.dropLast(words.length) + blockLanguage.support.pieceInWords(words, language)
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
