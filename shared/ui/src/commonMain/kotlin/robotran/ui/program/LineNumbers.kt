package robotran.ui.program

import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.widthIn
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.text.AnnotatedString
import androidx.compose.ui.text.SpanStyle
import androidx.compose.ui.text.buildAnnotatedString
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.text.withStyle
import androidx.compose.ui.unit.dp
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.codeStyle

/** The numbers 1 to [count] beside the program; those of [mistaken] lines carry a mark. */
@Composable
internal fun LineNumbers(count: Int, mistaken: Set<Int>, modifier: Modifier = Modifier) {
    val colours = LocalRobotranColours.current
    val text = remember(count, mistaken, colours) { numbers(count, mistaken, colours.mistake) }
    Text(
        text,
        modifier.padding(horizontal = 12.dp).widthIn(min = 28.dp).clearAndSetSemantics { },
        style = codeStyle(colours.quiet).copy(textAlign = TextAlign.End),
    )
}

private fun numbers(count: Int, mistaken: Set<Int>, mistakeColour: Color): AnnotatedString = buildAnnotatedString {
    for (line in 1..count) {
        if (line > 1) append('\n')
        if (line in mistaken) {
            withStyle(SpanStyle(color = mistakeColour, fontWeight = FontWeight.Bold)) { append("! $line") }
        } else {
            append("$line")
        }
    }
}
