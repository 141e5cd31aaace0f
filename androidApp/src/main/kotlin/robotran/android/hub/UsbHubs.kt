package robotran.android.hub

import android.content.Context
import android.content.pm.PackageManager
import android.hardware.usb.UsbConstants
import android.hardware.usb.UsbDevice
import android.hardware.usb.UsbDeviceConnection
import android.hardware.usb.UsbInterface
import android.hardware.usb.UsbManager
import robotran.android.tower.askForPermission
import robotran.android.usb.UsbStream
import robotran.android.usb.endpoint
import robotran.android.usb.interfaces
import robotran.hublink.HubError
import robotran.hublink.HubKind
import robotran.hublink.connection.HubConnection
import robotran.hublink.connection.HubDevice
import robotran.hublink.connection.HubTransport
import robotran.hublink.connection.OpenedHub
import robotran.hublink.connection.PacketHub
import robotran.hublink.connection.SerialHub

/** The hubs at the USB of a device that can be a host. Android asks the user once for each that is plugged in. */
internal class UsbHubs(private val context: Context) {
    private val manager: UsbManager? =
        context.takeIf { it.packageManager.hasSystemFeature(PackageManager.FEATURE_USB_HOST) }
            ?.getSystemService(UsbManager::class.java)

    val isThere: Boolean get() = manager != null

    /** Those that the user has allowed. */
    fun available(): List<HubDevice> = plugged().filter(::isAllowed).mapNotNull(::deviceOf)

    suspend fun choose(transport: HubTransport): HubDevice? {
        val usb = manager ?: return null
        val hub = plugged().firstOrNull { deviceOf(it)?.transport == transport } ?: return null
        if (!isAllowed(hub)) askForPermission(context, usb, hub)
        return deviceOf(hub).takeIf { isAllowed(hub) }
    }

    fun open(device: HubDevice): OpenedHub {
        val hub = plugged().firstOrNull { it.deviceName == device.id } ?: return OpenedHub.Failure(HubError.OutOfReach)
        if (!isAllowed(hub)) return OpenedHub.Failure(HubError.NotAllowed)
        val connection = manager?.openDevice(hub) ?: return OpenedHub.Failure(HubError.Taken)
        val isPackets = device.transport == HubTransport.USB_PACKETS
        val opened = if (isPackets) packets(connection, hub) else serial(connection, hub)
        if (opened == null) connection.close()
        return opened?.let { OpenedHub.Success(it) } ?: OpenedHub.Failure(HubError.Taken)
    }

    /** Null if something else holds the hub. */
    private fun packets(connection: UsbDeviceConnection, hub: UsbDevice): HubConnection? {
        val line = hub.interfaces().firstOrNull(::takesPackets) ?: return null
        val stream = stream(connection, listOf(line), line) ?: return null
        return PacketHub(UsbPacketPort(connection, line.id, stream))
    }

    private fun serial(connection: UsbDeviceConnection, hub: UsbDevice): HubConnection? {
        val data = hub.interfaces().firstOrNull(::isSerial) ?: return null
        val control = hub.interfaces().firstOrNull { it.interfaceClass == UsbConstants.USB_CLASS_COMM }
        val stream = stream(connection, listOfNotNull(control, data), data) ?: return null
        // DTR and RTS on: a hub tells nothing without.
        connection.controlTransfer(
            TO_INTERFACE,
            SET_CONTROL_LINE_STATE,
            DTR_AND_RTS,
            control?.id ?: 0,
            null,
            0,
            TIMEOUT,
        )
        return SerialHub(UsbBytePort(stream))
    }

    private fun stream(connection: UsbDeviceConnection, lines: List<UsbInterface>, data: UsbInterface): UsbStream? {
        val input = data.endpoint(UsbConstants.USB_DIR_IN) ?: return null
        val output = data.endpoint(UsbConstants.USB_DIR_OUT) ?: return null
        // Takes them from a driver of the system, too.
        return if (lines.all {
                connection.claimInterface(it, true)
            }
        ) {
            UsbStream(connection, lines, input, output)
        } else {
            null
        }
    }

    private fun plugged(): List<UsbDevice> = manager?.deviceList.orEmpty().values.filter {
        it.vendorId == HubKind.USB_VENDOR && HubKind.ofUsbProduct(it.productId) != null
    }

    private fun isAllowed(hub: UsbDevice) = manager?.hasPermission(hub) == true

    private fun deviceOf(hub: UsbDevice): HubDevice? {
        val transport = when {
            hub.interfaces().any(::takesPackets) -> HubTransport.USB_PACKETS
            hub.interfaces().any(::isSerial) -> HubTransport.USB_SERIAL
            else -> return null
        }
        return HubDevice(hub.deviceName, HubKind.ofUsbProduct(hub.productId)?.productName.orEmpty(), transport)
    }

    private companion object {
        const val TO_INTERFACE = 0x21
        const val SET_CONTROL_LINE_STATE = 0x22
        const val DTR_AND_RTS = 3

        /** Milliseconds. */
        const val TIMEOUT = 1_000

        /** Pybricks 4.0. */
        fun takesPackets(line: UsbInterface) = line.interfaceClass == UsbConstants.USB_CLASS_VENDOR_SPEC &&
            line.interfaceSubclass == 0xC5 && line.interfaceProtocol == 0xF5

        /** Pybricks 4.1, and LEGO's own firmware. */
        fun isSerial(line: UsbInterface) = line.interfaceClass == UsbConstants.USB_CLASS_CDC_DATA
    }
}
