package robotran.ui.send.hub

import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import robotran.hublink.connection.HubDevice
import robotran.hublink.connection.HubTransport
import robotran.ui.school.tags.SendTags
import robotran.ui.school.texts.HubSendTexts
import robotran.uikit.*
import robotran.workshop.event.HubSendEvent
import robotran.workshop.state.HubSendStep

/** The hubs that are there, and a button for each transport by which the platform can look for one. */
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
    for (transport in step.transports) {
        Button(
            lookingBy(transport)(spoken),
            SendTags.look(transport),
            ButtonKind.DIALOG_ANSWER,
            Modifier.fillMaxWidth(),
        ) { onEvent(HubSendEvent.TransportRequested(transport)) }
    }
}

@Composable
private fun nameOf(device: HubDevice): String {
    val name = device.name.ifEmpty { "Pybricks" }
    return when (device.transport) {
        HubTransport.BLUETOOTH -> HubSendTexts.byBluetooth(spoken, name)
        HubTransport.USB_SERIAL, HubTransport.USB_PACKETS -> HubSendTexts.byCable(spoken, name)
    }
}

private fun lookingBy(transport: HubTransport): Label = when (transport) {
    HubTransport.BLUETOOTH -> HubSendTexts::lookBluetooth
    HubTransport.USB_SERIAL -> HubSendTexts::lookUsb
    HubTransport.USB_PACKETS -> HubSendTexts::lookUsbPackets
}
