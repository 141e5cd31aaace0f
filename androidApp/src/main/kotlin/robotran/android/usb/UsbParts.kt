package robotran.android.usb

import android.hardware.usb.UsbDevice
import android.hardware.usb.UsbEndpoint
import android.hardware.usb.UsbInterface

/** The interfaces of a device, in its order. */
internal fun UsbDevice.interfaces(): List<UsbInterface> = (0..<interfaceCount).map(::getInterface)

/** The first endpoint in a [direction]; null for none. */
internal fun UsbInterface.endpoint(direction: Int): UsbEndpoint? =
    (0..<endpointCount).map(::getEndpoint).firstOrNull { it.direction == direction }
