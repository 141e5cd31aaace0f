package robotran.ui.program

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import robotran.language.source.Diagnostic
import robotran.programs.Program
import robotran.ui.program.editor.FixButton
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.EditorTexts
import robotran.ui.texts.CommonTexts
import robotran.uikit.*

/**
 * Below the text: the number of errors, with a button that jumps to the next, and the errors without a line in the
 * current file.
 *
 * @param diagnostics all of [program]; those at a line of [file] are shown there.
 * @param max how many of the others there is room for.
 */
@Composable
internal fun DiagnosticStrip(
    program: Program,
    diagnostics: List<Diagnostic>,
    file: String,
    max: Int,
    pointedOut: Boolean,
    onNext: () -> Unit,
    onFix: (Diagnostic) -> Unit,
    modifier: Modifier = Modifier,
) {
    val colours = LocalRobotranColours.current
    val (here, elsewhere) = diagnostics.partition { it.file == file && it.range != null }
    Column(
        modifier.fillMaxWidth().background(
            colours.errorPane,
        ).testTag(ProgramTags.MISTAKES).padding(start = 16.dp, end = 8.dp),
    ) {
        for (diagnostic in elsewhere.take(max)) Elsewhere(diagnostic, program, onFix)
        // At the bottom, so that the button does not move when others appear.
        if (here.isNotEmpty()) {
            Row(
                Modifier.fillMaxWidth().defaultMinSize(minHeight = Dimensions.TARGET),
                verticalAlignment = Alignment.CenterVertically,
            ) {
                val count = diagnostics.size
                Text(
                    if (count == 1) {
                        EditorTexts.mistakeOne(spoken)
                    } else {
                        EditorTexts.mistakes(spoken, count)
                    },
                    Modifier.weight(1f),
                    TextStyles.body.copy(fontWeight = if (pointedOut) FontWeight.Bold else FontWeight.Normal),
                    color = colours.error,
                )
                Button(
                    EditorTexts.nextMistake(spoken),
                    ProgramTags.NEXT_MISTAKE,
                    ButtonKind.SMALL_LINK,
                    style = TextStyles.compact.strong,
                    onClick = onNext,
                )
            }
        }
    }
}

@Composable
private fun Elsewhere(diagnostic: Diagnostic, program: Program, onFix: (Diagnostic) -> Unit) {
    val line = diagnostic.range?.line
    val words = when {
        diagnostic.file.isEmpty() -> diagnostic.message
        line == null -> CommonTexts.mistakeInFile(spoken, diagnostic.file, diagnostic.message)
        else -> CommonTexts.mistakeInLineOfFile(spoken, diagnostic.file, line, diagnostic.message)
    }
    Row(
        Modifier.fillMaxWidth().defaultMinSize(minHeight = Dimensions.TARGET),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        Text(
            words,
            Modifier.weight(1f).padding(vertical = 6.dp).announced(),
            TextStyles.body,
            color = LocalRobotranColours.current.error,
        )
        diagnostic.fix?.let { fix ->
            val text = program.files.firstOrNull { it.name == diagnostic.file }?.text.orEmpty()
            FixButton(
                diagnostic,
                remember(text, fix) {
                    text.lineSequence().elementAtOrElse(fix.range.line - 1) { "" }
                },
                onFix,
            )
        }
    }
}
