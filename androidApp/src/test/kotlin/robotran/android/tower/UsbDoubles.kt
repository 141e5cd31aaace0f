package robotran.android.tower

import android.hardware.usb.UsbConfiguration
import android.hardware.usb.UsbConstants
import android.hardware.usb.UsbDevice
import android.hardware.usb.UsbEndpoint
import android.hardware.usb.UsbInterface
import org.robolectric.shadow.api.Shadow
import org.robolectric.util.ReflectionHelpers
import org.robolectric.util.ReflectionHelpers.ClassParameter.from

/** A device with the interfaces [lines]. */
internal fun usbDevice(
    name: String,
    vendor: Int,
    product: Int,
    productName: String,
    lines: List<UsbInterface>,
): UsbDevice {
    val configuration = made<UsbConfiguration>(1, "", 0, 50)
    ReflectionHelpers.setField(configuration, "mInterfaces", lines.toTypedArray())
    val device = Shadow.newInstanceOf(UsbDevice::class.java)
    val fields = mapOf(
        "mName" to name,
        "mVendorId" to vendor,
        "mProductId" to product,
        "mProductName" to productName,
        "mConfigurations" to arrayOf(configuration),
    )
    for ((field, value) in fields) ReflectionHelpers.setField(device, field, value)
    return device
}

/**
 * An interface with an endpoint in each direction.
 *
 * @param endpoints their kind; null for an interface without any.
 */
internal fun usbInterface(
    number: Int,
    lineClass: Int,
    subclass: Int = 0,
    protocol: Int = 0,
    endpoints: Int?,
    packetSize: Int = 8,
): UsbInterface {
    val line = made<UsbInterface>(number, 0, "", lineClass, subclass, protocol)
    val both = listOf(UsbConstants.USB_DIR_IN or 1, UsbConstants.USB_DIR_OUT or 2)
    val made = if (endpoints == null) emptyList() else both.map { made<UsbEndpoint>(it, endpoints, packetSize, 10) }
    ReflectionHelpers.setField(line, "mEndpoints", made.toTypedArray())
    return line
}

/** Android's constructors of these classes are hidden. */
private inline fun <reified T : Any> made(vararg values: Any): T {
    val parameters = values.map { value ->
        if (value is Int) from(Int::class.javaPrimitiveType, value) else from(String::class.java, value)
    }
    return ReflectionHelpers.callConstructor(T::class.java, *parameters.toTypedArray())
}
