package robotran.ui.send

import androidx.compose.foundation.BorderStroke
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.material3.ButtonDefaults
import androidx.compose.material3.OutlinedButton
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.unit.dp
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.tower.port.TowerDevice
import robotran.tower.port.TowerKind
import robotran.ui.resources.*
import robotran.ui.theme.Dimensions
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.TextSizes
import robotran.ui.theme.focusRing
import robotran.workshop.event.SendEvent
import robotran.workshop.state.SendStep

/** The towers that are there, and a button for each kind that the platform can look for. */
@Composable
internal fun TowerChoice(step: SendStep.ChoosingTower, onEvent: (SendEvent) -> Unit) {
    step.devices.forEachIndexed { index, device ->
        TowerButton(nameOf(device), "send-tower-$index") { onEvent(SendEvent.TowerChosen(device)) }
    }
    // The USB tower first: it needs no adapter, so most pupils have one.
    for (kind in step.kinds.sortedByDescending { it == TowerKind.USB }) {
        TowerButton(stringResource(lookingFor(kind)), "send-look-${kind.name.lowercase()}") {
            onEvent(SendEvent.TowerRequested(kind))
        }
    }
}

@Composable
private fun TowerButton(words: String, tag: String, onClick: () -> Unit) {
    val colours = LocalRobotranColours.current
    OutlinedButton(
        onClick,
        Modifier.fillMaxWidth().heightIn(min = Dimensions.TARGET).focusRing(24.dp).testTag(tag),
        colors = ButtonDefaults.outlinedButtonColors(contentColor = colours.onPane),
        border = BorderStroke(1.dp, colours.line),
    ) { Text(words, fontSize = TextSizes.BODY, textAlign = TextAlign.Center) }
}

@Composable
private fun nameOf(device: TowerDevice): String {
    val (plain, named) = when (device.kind) {
        TowerKind.USB -> Res.string.send_usb_tower to Res.string.send_usb_named
        TowerKind.SERIAL -> Res.string.send_serial_tower to Res.string.send_serial_named
    }
    return if (device.name.isEmpty()) stringResource(plain) else stringResource(named, device.name)
}

private fun lookingFor(kind: TowerKind): StringResource = when (kind) {
    TowerKind.USB -> Res.string.send_look_usb
    TowerKind.SERIAL -> Res.string.send_look_serial
}
