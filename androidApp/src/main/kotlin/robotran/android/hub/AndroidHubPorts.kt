package robotran.android.hub

import android.content.Context
import robotran.hublink.HubError
import robotran.hublink.connection.ChosenHub
import robotran.hublink.connection.HubDevice
import robotran.hublink.connection.HubPorts
import robotran.hublink.connection.HubWay
import robotran.hublink.connection.OpenedHub

/** Hubs with Pybricks near an Android device: by Bluetooth, and at its USB if it can be a host. */
internal class AndroidHubPorts(context: Context, permissions: BluetoothPermissions) : HubPorts {
    private val bluetooth by lazy(LazyThreadSafetyMode.NONE) { BluetoothHubs(context, permissions) }
    private val usb by lazy(LazyThreadSafetyMode.NONE) { UsbHubs(context) }

    override val ways: Set<HubWay>
        get() = (if (bluetooth.isThere) setOf(HubWay.BLUETOOTH) else emptySet()) +
            (if (usb.isThere) setOf(HubWay.USB_SERIAL, HubWay.USB_PACKETS) else emptySet())

    override suspend fun available(): List<HubDevice> = usb.available() + bluetooth.seen()

    /** Of several hubs near the device none is chosen: the user takes one from those that are available then. */
    override suspend fun choose(way: HubWay): ChosenHub = when (way) {
        HubWay.BLUETOOTH -> bluetooth.choose()
        HubWay.USB_SERIAL, HubWay.USB_PACKETS -> ChosenHub.of(usb.choose(way))
    }

    override suspend fun open(device: HubDevice): OpenedHub = try {
        when (device.way) {
            HubWay.BLUETOOTH -> bluetooth.open(device)
            HubWay.USB_SERIAL, HubWay.USB_PACKETS -> usb.open(device)
        }
    } catch (_: SecurityException) {
        // The user has taken the permission back in the settings of the system.
        OpenedHub.Failure(HubError.NotAllowed)
    }
}
