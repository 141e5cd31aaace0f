package robotran.ui.program.editor

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.text
import androidx.compose.ui.text.AnnotatedString
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import robotran.language.source.Diagnostic
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.EditorTexts
import robotran.uikit.*
import robotran.workshop.state.InlineDiagnostic

/**
 * A diagnostic below its line, with a button for its fix, if any.
 *
 * @param line the text of the line to change.
 */
@OptIn(ExperimentalLayoutApi::class)
@Composable
internal fun LineNote(note: InlineDiagnostic, line: String, standsOut: Boolean, onFix: (Diagnostic) -> Unit) {
    val colours = LocalRobotranColours.current
    val spoken = EditorTexts.mistake(spoken, note.line ?: 0, note.diagnostic.message)
    val frame = Modifier
        .testTag(ProgramTags.note(note.kind))
        .fillMaxWidth()
        .padding(end = 8.dp, top = 2.dp, bottom = 4.dp)
        .clip(Shapes.SMALL)
        .background(if (note.isWarning) colours.line.copy(alpha = QUIET) else colours.errorPane)
        .padding(start = 12.dp, end = 4.dp)
    val message: @Composable (Modifier) -> Unit = { modifier ->
        Text(
            note.diagnostic.message,
            modifier
                .padding(vertical = 8.dp)
                .clearAndSetSemantics {
                    text = AnnotatedString(spoken)
                    liveRegion = LiveRegionMode.Polite
                },
            TextStyles.denseLines.copy(fontWeight = if (standsOut) FontWeight.Bold else FontWeight.Normal),
            color = if (note.isWarning) colours.onPane else colours.error,
        )
    }
    // A button that does not fit next to the message wraps below it.
    FlowRow(frame, Arrangement.spacedBy(8.dp)) {
        message(Modifier.align(Alignment.CenterVertically))
        if (note.diagnostic.fix != null) FixButton(note.diagnostic, line, onFix)
    }
}

private const val QUIET = 0.3f
