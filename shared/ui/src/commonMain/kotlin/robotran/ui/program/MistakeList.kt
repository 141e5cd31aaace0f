package robotran.ui.program

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.material3.Text
import androidx.compose.material3.TextButton
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
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
import robotran.ui.resources.mistake_in_file
import robotran.ui.resources.mistake_in_line_of_file
import robotran.ui.resources.mistakes_more
import robotran.ui.resources.mistakes_more_one
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.Measures
import robotran.ui.theme.focusRing

/**
 * The first few mistakes under the program, each with a button that mends it where that is possible.
 *
 * @param withFiles whether to say which file each is in.
 * @param most how many there is room for; the others come up as these are mended.
 * @param pointedOut whether somebody tried to run the program: the first mistake then stands out.
 */
@Composable
internal fun MistakeList(
    mistakes: List<Mistake>,
    withFiles: Boolean,
    most: Int,
    pointedOut: Boolean,
    onFix: (Mistake) -> Unit,
    modifier: Modifier = Modifier,
) {
    val colours = LocalRobotranColours.current
    Column(
        modifier
            .fillMaxWidth()
            .background(colours.mistakePane)
            .testTag("mistakes")
            .semantics { liveRegion = LiveRegionMode.Polite }
            .padding(horizontal = 16.dp, vertical = 4.dp),
    ) {
        mistakes.take(most).forEachIndexed { index, mistake -> MistakeRow(mistake, withFiles, pointedOut && index == 0, onFix) }
        val more = mistakes.size - most
        if (more > 0) {
            val text = if (more == 1) stringResource(Res.string.mistakes_more_one) else stringResource(Res.string.mistakes_more, more)
            Text(text, Modifier.padding(bottom = 8.dp), color = colours.mistake, fontSize = 14.sp)
        }
    }
}

@Composable
private fun MistakeRow(mistake: Mistake, withFile: Boolean, standsOut: Boolean, onFix: (Mistake) -> Unit) {
    Row(Modifier.fillMaxWidth().defaultMinSize(minHeight = Measures.TARGET), verticalAlignment = Alignment.CenterVertically) {
        Text(
            textOf(mistake, withFile),
            Modifier.weight(1f).padding(vertical = 6.dp),
            color = LocalRobotranColours.current.mistake,
            fontSize = 16.sp,
            fontWeight = if (standsOut) FontWeight.Bold else FontWeight.Normal,
        )
        if (mistake.fix != null) FixButton(mistake, onFix)
    }
}

@Composable
private fun textOf(mistake: Mistake, withFile: Boolean): String {
    val line = mistake.range?.line
    return when {
        line == null && withFile -> stringResource(Res.string.mistake_in_file, mistake.file, mistake.message)
        line == null -> mistake.message
        withFile -> stringResource(Res.string.mistake_in_line_of_file, mistake.file, line, mistake.message)
        else -> stringResource(Res.string.mistake, line, mistake.message)
    }
}

@Composable
private fun FixButton(mistake: Mistake, onFix: (Mistake) -> Unit) {
    val replacement = mistake.fix?.replacement?.trim().orEmpty()
    val text =
        if (replacement.isEmpty()) stringResource(Res.string.mistake_fix_remove) else stringResource(Res.string.mistake_fix, replacement)
    TextButton(
        onClick = { onFix(mistake) },
        modifier = Modifier.padding(start = 8.dp).defaultMinSize(minHeight = Measures.TARGET).testTag("fix").focusRing(),
    ) {
        Text(
            text,
            color = LocalRobotranColours.current.focus,
            fontSize = 16.sp,
            fontWeight = FontWeight.SemiBold,
            maxLines = 1,
            overflow = TextOverflow.Ellipsis,
        )
    }
}
