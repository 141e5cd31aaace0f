package robotran.ui.common

import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import robotran.simulation.state.MissingSensors
import robotran.ui.common.tags.CommonTags
import robotran.ui.texts.CommonTexts
import robotran.uikit.*

/** Changes the world so that the robot has all of the [missing] sensors; for the warning about them. */
@Composable
fun PlugInButton(missing: MissingSensors, onPlug: (MissingSensors) -> Unit, modifier: Modifier = Modifier) {
    val ports = missing.sensors.map { it.label }
    val description = ports.singleOrNull()?.let { CommonTexts.plugInPort(spoken, it) }
        ?: CommonTexts.plugInPorts(spoken, ports)
    Button(
        if (ports.size == 1) CommonTexts.plugIn(spoken) else CommonTexts.plugInSeveral(spoken),
        CommonTags.PLUG_IN,
        ButtonKind.LINK,
        modifier.named(description),
    ) { onPlug(missing) }
}
