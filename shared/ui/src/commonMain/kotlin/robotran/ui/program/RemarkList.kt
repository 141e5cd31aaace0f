package robotran.ui.program

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import org.jetbrains.compose.resources.stringResource
import robotran.rom.ProgramRemark
import robotran.ui.resources.Res
import robotran.ui.resources.mistake
import robotran.ui.resources.mistake_in_line_of_file
import robotran.ui.theme.LocalRobotranColours

/**
 * What a pupil can learn from a run that went on all the same, such as where a brick calculates otherwise than Java says.
 *
 * @param most how many there is room for.
 */
@Composable
internal fun RemarkList(remarks: List<ProgramRemark>, most: Int) {
    val colours = LocalRobotranColours.current
    Column(
        Modifier
            .fillMaxWidth()
            .background(colours.desk)
            .testTag("remarks")
            .semantics { liveRegion = LiveRegionMode.Polite }
            .padding(horizontal = 16.dp, vertical = 4.dp),
    ) {
        for (remark in remarks.take(most)) {
            Text(textOf(remark), Modifier.padding(vertical = 6.dp), color = colours.onPane, fontSize = 16.sp)
        }
    }
}

@Composable
private fun textOf(remark: ProgramRemark): String {
    val file = remark.sourceFile
    return when {
        remark.sourceLine == 0 -> remark.message
        file == null -> stringResource(Res.string.mistake, remark.sourceLine, remark.message)
        else -> stringResource(Res.string.mistake_in_line_of_file, file, remark.sourceLine, remark.message)
    }
}
