package robotran.ui.send

import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import robotran.tower.port.TowerDevice
import robotran.tower.port.TowerKind
import robotran.ui.school.tags.SendTags
import robotran.ui.school.texts.SendTexts
import robotran.uikit.*
import robotran.workshop.event.SendEvent
import robotran.workshop.state.SendStep

/** The towers that are there, and a button for each kind that the platform can look for. */
@Composable
internal fun TowerChoice(step: SendStep.ChoosingTower, onEvent: (SendEvent) -> Unit) {
    step.devices.forEachIndexed { index, device ->
        Button(
            nameOf(device),
            SendTags.tower(index),
            ButtonKind.DIALOG_ANSWER,
            Modifier.fillMaxWidth(),
        ) { onEvent(SendEvent.TowerChosen(device)) }
    }
    // The USB tower first: it needs no adapter, so most pupils have one.
    for (kind in step.kinds.sortedByDescending { it == TowerKind.USB }) {
        Button(
            lookingFor(kind)(spoken),
            SendTags.look(kind),
            ButtonKind.DIALOG_ANSWER,
            Modifier.fillMaxWidth(),
        ) {
            onEvent(SendEvent.TowerRequested(kind))
        }
    }
}

@Composable
private fun nameOf(device: TowerDevice): String {
    val (plain, named) = when (device.kind) {
        TowerKind.USB -> SendTexts::usbTower to SendTexts::usbNamed
        TowerKind.SERIAL -> SendTexts::serialTower to SendTexts::serialNamed
    }
    return if (device.name.isEmpty()) plain(spoken) else named(spoken, device.name)
}

private fun lookingFor(kind: TowerKind): Label = when (kind) {
    TowerKind.USB -> SendTexts::lookUsb
    TowerKind.SERIAL -> SendTexts::lookSerial
}
