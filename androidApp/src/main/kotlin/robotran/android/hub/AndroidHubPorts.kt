package robotran.android.hub

import android.content.Context
import robotran.hublink.HubError
import robotran.hublink.connection.ChosenHub
import robotran.hublink.connection.HubDevice
import robotran.hublink.connection.HubPorts
import robotran.hublink.connection.HubTransport
import robotran.hublink.connection.OpenedHub

/** Hubs with Pybricks near an Android device: by Bluetooth, and at its USB if it can be a host. */
internal class AndroidHubPorts(context: Context, permissions: BluetoothPermissions) : HubPorts {
    private val bluetooth by lazy(LazyThreadSafetyMode.NONE) { BluetoothHubs(context, permissions) }
    private val usb by lazy(LazyThreadSafetyMode.NONE) { UsbHubs(context) }

    override val transports: Set<HubTransport>
        get() = (if (bluetooth.isThere) setOf(HubTransport.BLUETOOTH) else emptySet()) +
            (if (usb.isThere) setOf(HubTransport.USB_SERIAL, HubTransport.USB_PACKETS) else emptySet())

    override suspend fun available(): List<HubDevice> = usb.available() + bluetooth.seen()

    /** Of several hubs near the device none is chosen: the user takes one from those that are available then. */
    override suspend fun choose(transport: HubTransport): ChosenHub = when (transport) {
        HubTransport.BLUETOOTH -> bluetooth.choose()
        HubTransport.USB_SERIAL, HubTransport.USB_PACKETS -> ChosenHub.of(usb.choose(transport))
    }

    override suspend fun open(device: HubDevice): OpenedHub = try {
        when (device.transport) {
            HubTransport.BLUETOOTH -> bluetooth.open(device)
            HubTransport.USB_SERIAL, HubTransport.USB_PACKETS -> usb.open(device)
        }
    } catch (_: SecurityException) {
        // The user has taken the permission back in the settings of the system.
        OpenedHub.Failure(HubError.NotAllowed)
    }
}
