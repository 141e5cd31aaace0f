package robotran.ui.handins

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.horizontalScroll
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.IntrinsicSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.text.selection.SelectionContainer
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.text.AnnotatedString
import androidx.compose.ui.text.SpanStyle
import androidx.compose.ui.text.buildAnnotatedString
import androidx.compose.ui.unit.dp
import robotran.brick.kind.BrickKind
import robotran.language.ProgramLanguage
import robotran.languagesupport.CodeTokens
import robotran.languagesupport.TextLines
import robotran.programs.support
import robotran.projects.ProjectProgram
import robotran.ui.code.CodeColours
import robotran.ui.code.codeColours
import robotran.uikit.*
import robotran.workshop.handins.equalLines

/**
 * Programs to read, in the colours of the editor.
 *
 * @param title whose they are, where there are others beside them.
 * @param besides the programs that they are compared with: equal lines have a bar and a ground; empty for none.
 */
@Composable
internal fun ReadOnlyPrograms(
    title: String,
    programs: List<ProjectProgram>,
    besides: List<ProjectProgram>,
    tag: String,
    modifier: Modifier = Modifier,
) = Column(modifier.testTag(tag), Arrangement.spacedBy(Space.SMALL)) {
    if (besides.isNotEmpty()) {
        Text(title, style = TextStyles.body.strong)
    }
    for (program in programs) {
        for (file in program.files) {
            Text(file.name, style = TextStyles.small, color = LocalRobotranColours.current.quiet)
            CodeLines(file.text, program.language, besides)
        }
    }
}

@Composable
private fun CodeLines(text: String, language: ProgramLanguage, besides: List<ProjectProgram>) {
    val colours = LocalRobotranColours.current
    val code = codeColours()
    val lines = remember(text, code) { coloured(text.trimEnd(), language, code) }
    val equal = remember(text, besides) {
        val others = besides.flatMap { other -> other.files.flatMap { usualLines(it.text, other.language) } }
        if (others.isEmpty()) emptyList() else equalLines(usualLines(text.trimEnd(), language), others)
    }
    SelectionContainer {
        Column(
            Modifier
                .fillMaxWidth()
                .border(1.dp, colours.line, Shapes.SMALL)
                .background(colours.pane, Shapes.SMALL)
                .horizontalScroll(rememberScrollState())
                .padding(vertical = Space.SMALL)
                .width(IntrinsicSize.Max),
        ) {
            val style = codeStyle()
            lines.forEachIndexed { index, line ->
                val isEqual = equal.getOrElse(index) { false }
                Text(
                    line,
                    Modifier.fillMaxWidth().marked(isEqual, colours).padding(horizontal = Space.MEDIUM),
                    style,
                    softWrap = false,
                )
            }
        }
    }
}

/** The lines of [text] in the usual words, since programs may be in the words of different languages of people. */
internal fun usualLines(text: String, language: ProgramLanguage): List<String> =
    language.support.inUsualWords(text).lines()

/** A line that the other program has, too: a bar at its left, so that the ground's colour is not needed. */
private fun Modifier.marked(isEqual: Boolean, colours: RobotranColours): Modifier = if (!isEqual) {
    this
} else {
    drawBehind {
        drawRect(colours.runningLine.copy(alpha = GROUND))
        drawRect(barColour(colours), Offset.Zero, Size(BAR.toPx(), size.height))
    }
}

private fun barColour(colours: RobotranColours): Color = colours.onPane

private fun coloured(text: String, language: ProgramLanguage, colours: CodeColours): List<AnnotatedString> {
    val lines = TextLines(text)
    val tokens = CodeTokens(lines, language.support.code, BrickKind.default)
    return (0..<minOf(lines.count, MAX_LINES)).map { index ->
        buildAnnotatedString {
            append(lines.line(index))
            for (token in tokens.of(index)) {
                addStyle(SpanStyle(color = colours.of(token.kind)), token.start, token.end)
            }
        }
    }
}

private val BAR = 4.dp
private const val GROUND = 0.5f

/** Nobody reads further, and a hostile program may have far more. */
private const val MAX_LINES = 500
