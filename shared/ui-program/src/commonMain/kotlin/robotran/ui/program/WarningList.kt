package robotran.ui.program

import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import robotran.brick.program.RuntimeWarning
import robotran.simulation.state.MissingSensors
import robotran.ui.common.PlugInButton
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.EditorTexts
import robotran.ui.texts.CommonTexts
import robotran.uikit.*

/**
 * Warnings of a run, such as where the brick's results differ from Java's; empty if there are none. It covers the
 * bottom of the program, which does not move, until it is closed or there are more.
 *
 * @param max how many there is room for.
 * @param missingSensors the sensors that one of the remarks is about; that remark has a button.
 * @param onPlug plugs them in.
 */
@Composable
internal fun WarningList(
    warnings: List<RuntimeWarning>,
    max: Int,
    missingSensors: MissingSensors?,
    onPlug: (MissingSensors) -> Unit,
    modifier: Modifier = Modifier,
) {
    val colours = LocalRobotranColours.current
    val shown = warnings.take(max)
    var isClosed by remember(shown) { mutableStateOf(false) }
    if (shown.isEmpty() || isClosed) return
    Surface(modifier.fillMaxWidth().padding(8.dp), color = colours.desk) {
        Row {
            Column(
                Modifier
                    .weight(1f)
                    .testTag(ProgramTags.REMARKS)
                    .announced()
                    .padding(start = 16.dp, top = 4.dp, bottom = 4.dp),
            ) {
                for (warning in shown) {
                    Row(verticalAlignment = Alignment.CenterVertically) {
                        Text(textOf(warning), Modifier.weight(1f).padding(vertical = 6.dp), TextStyles.body)
                        missingSensors?.takeIf { it.warning == warning }?.let { PlugInButton(it, onPlug) }
                    }
                }
            }
            IconButton(Icon.CLOSE, CommonTexts.noticeClose(spoken), ProgramTags.REMARKS_CLOSE) { isClosed = true }
        }
    }
}

@Composable
private fun textOf(warning: RuntimeWarning): String {
    val file = warning.sourceFile
    return when {
        warning.sourceLine == 0 -> warning.message
        file == null -> EditorTexts.mistake(spoken, warning.sourceLine, warning.message)
        else -> CommonTexts.mistakeInLineOfFile(spoken, file, warning.sourceLine, warning.message)
    }
}
