package robotran.ui.send.hub

import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import robotran.hublink.connection.HubDevice
import robotran.hublink.connection.HubWay
import robotran.ui.school.tags.SendTags
import robotran.ui.school.texts.HubSendTexts
import robotran.uikit.*
import robotran.workshop.event.HubSendEvent
import robotran.workshop.state.HubSendStep

/** The hubs that are there, and a button for each way by which the platform can look for one. */
@Composable
internal fun HubChoice(step: HubSendStep.Choosing, onEvent: (HubSendEvent) -> Unit) {
    step.devices.forEachIndexed { index, device ->
        Button(
            if (device == step.last) HubSendTexts.usedLast(spoken, nameOf(device)) else nameOf(device),
            SendTags.hub(index),
            ButtonKind.DIALOG_ANSWER,
            Modifier.fillMaxWidth(),
        ) { onEvent(HubSendEvent.HubChosen(device)) }
    }
    for (way in step.ways) {
        Button(
            lookingBy(way)(spoken),
            SendTags.look(way),
            ButtonKind.DIALOG_ANSWER,
            Modifier.fillMaxWidth(),
        ) { onEvent(HubSendEvent.WayRequested(way)) }
    }
}

@Composable
private fun nameOf(device: HubDevice): String {
    val name = device.name.ifEmpty { "Pybricks" }
    return when (device.way) {
        HubWay.BLUETOOTH -> HubSendTexts.byBluetooth(spoken, name)
        HubWay.USB_SERIAL, HubWay.USB_PACKETS -> HubSendTexts.byCable(spoken, name)
    }
}

private fun lookingBy(way: HubWay): Label = when (way) {
    HubWay.BLUETOOTH -> HubSendTexts::lookBluetooth
    HubWay.USB_SERIAL -> HubSendTexts::lookUsb
    HubWay.USB_PACKETS -> HubSendTexts::lookUsbPackets
}
