package robotran.ui.program

import androidx.compose.foundation.background
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
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import org.jetbrains.compose.resources.stringResource
import robotran.ui.resources.Res
import robotran.ui.resources.program_closed
import robotran.ui.resources.program_reopen
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.Measures
import robotran.ui.theme.focusRing

/** Says that the program or class called [name] was closed, and brings it back if there is [room] for it. */
@Composable
internal fun ClosedProgram(name: String, room: Boolean, onReopen: () -> Unit) {
    val colours = LocalRobotranColours.current
    Row(
        Modifier
            .fillMaxWidth()
            .background(colours.desk)
            .padding(horizontal = 16.dp)
            .defaultMinSize(minHeight = Measures.TARGET)
            .testTag("closed-program"),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        Text(
            stringResource(Res.string.program_closed, name),
            Modifier.weight(1f).semantics { liveRegion = LiveRegionMode.Polite },
            color = colours.onPane,
            fontSize = 16.sp,
        )
        if (room) {
            TextButton(onReopen, Modifier.defaultMinSize(minHeight = Measures.TARGET).testTag("reopen-program").focusRing()) {
                Text(stringResource(Res.string.program_reopen), color = colours.focus, fontSize = 16.sp, fontWeight = FontWeight.SemiBold)
            }
        }
    }
}
