package robotran.ui.program.editor

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.Text
import androidx.compose.material3.TextButton
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
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import org.jetbrains.compose.resources.stringResource
import robotran.programs.Mistake
import robotran.ui.resources.Res
import robotran.ui.resources.mistake
import robotran.ui.resources.mistake_fix
import robotran.ui.resources.mistake_fix_remove
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.Measures
import robotran.ui.theme.focusRing
import robotran.ui.workshop.ProgramNote

/** What is told about a line, under it, with a button that mends it where that is possible. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
internal fun LineNote(note: ProgramNote, standsOut: Boolean, onFix: (Mistake) -> Unit) {
    val colours = LocalRobotranColours.current
    val spoken = stringResource(Res.string.mistake, note.line ?: 0, note.mistake.message)
    val frame = Modifier
        .testTag(if (note.isDoubt) "doubt" else "mistake")
        .fillMaxWidth()
        .padding(end = 8.dp, top = 2.dp, bottom = 4.dp)
        .clip(RoundedCornerShape(8.dp))
        .background(if (note.isDoubt) colours.line.copy(alpha = QUIET) else colours.mistakePane)
        .padding(start = 12.dp, end = 4.dp)
    val message: @Composable (Modifier) -> Unit = { modifier ->
        Text(
            note.mistake.message,
            modifier
                .padding(vertical = 8.dp)
                .clearAndSetSemantics {
                    text = AnnotatedString(spoken)
                    liveRegion = LiveRegionMode.Polite
                },
            color = if (note.isDoubt) colours.onPane else colours.mistake,
            fontSize = 15.sp,
            lineHeight = 20.sp,
            fontWeight = if (standsOut) FontWeight.Bold else FontWeight.Normal,
        )
    }
    // A button that does not fit beside the message goes under it.
    FlowRow(frame, Arrangement.spacedBy(8.dp)) {
        message(Modifier.align(Alignment.CenterVertically))
        if (note.mistake.fix != null) FixButton(note.mistake, onFix)
    }
}

/** The button that applies the fix of [mistake]. */
@Composable
internal fun FixButton(mistake: Mistake, onFix: (Mistake) -> Unit) {
    val replacement = mistake.fix?.replacement?.trim().orEmpty()
    val removes = replacement.isEmpty()
    val text = if (removes) stringResource(Res.string.mistake_fix_remove) else stringResource(Res.string.mistake_fix, replacement)
    TextButton(
        onClick = { onFix(mistake) },
        modifier = Modifier.defaultMinSize(minHeight = Measures.TARGET).testTag("fix").focusRing(),
    ) {
        Text(
            text,
            color = LocalRobotranColours.current.focus,
            fontSize = 15.sp,
            fontWeight = FontWeight.SemiBold,
            maxLines = 2,
            overflow = TextOverflow.Ellipsis,
        )
    }
}

private const val QUIET = 0.3f
