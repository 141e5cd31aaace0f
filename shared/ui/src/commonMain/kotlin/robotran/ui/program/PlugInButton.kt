package robotran.ui.program

import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.material3.Text
import androidx.compose.material3.TextButton
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.sp
import org.jetbrains.compose.resources.stringResource
import robotran.simulation.state.MissingSensor
import robotran.ui.resources.Res
import robotran.ui.resources.run_plug_in
import robotran.ui.resources.run_plug_in_port
import robotran.ui.theme.Dimensions
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.focusRing

/** Changes the world so that the robot has the sensor [missing]; for the remark about it. */
@Composable
internal fun PlugInButton(missing: MissingSensor, onPlug: (MissingSensor) -> Unit, modifier: Modifier = Modifier) {
    val description = stringResource(Res.string.run_plug_in_port, missing.port)
    TextButton(
        { onPlug(missing) },
        modifier
            .defaultMinSize(minHeight = Dimensions.TARGET)
            .testTag("plug-in-${missing.port}")
            .semantics { contentDescription = description }
            .focusRing(),
    ) {
        Text(
            stringResource(Res.string.run_plug_in),
            color = LocalRobotranColours.current.focus,
            fontSize = 16.sp,
            fontWeight = FontWeight.SemiBold,
        )
    }
}
