@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.tower

import kotlin.js.Promise

/** The parts of the WebUSB API that the USB tower needs. */
internal external interface Usb : JsAny {
    fun getDevices(): Promise<JsArray<UsbDevice>>

    /** Shows the browser's dialog; rejected with `NotFoundError` if the pupil chooses nothing. */
    fun requestDevice(options: JsAny): Promise<UsbDevice>
}

internal external interface UsbDevice : JsAny {
    val vendorId: Int
    val productId: Int
    val productName: String?
    val opened: Boolean

    fun open(): Promise<JsAny?>

    fun close(): Promise<JsAny?>

    fun selectConfiguration(number: Int): Promise<JsAny?>

    fun claimInterface(number: Int): Promise<JsAny?>

    fun controlTransferIn(setup: JsAny, length: Int): Promise<UsbInResult>

    fun transferIn(endpoint: Int, length: Int): Promise<UsbInResult>

    fun transferOut(endpoint: Int, bytes: JsBytes): Promise<UsbOutResult>

    fun clearHalt(direction: String, endpoint: Int): Promise<JsAny?>
}

internal external interface UsbInResult : JsAny {
    val status: String
}

internal external interface UsbOutResult : JsAny {
    val status: String
    val bytesWritten: Int
}

/** Null in browsers without WebUSB, and on pages that are neither `https` nor on this machine. */
internal fun browserUsb(): Usb? = js("navigator.usb || null")

internal fun onlyDevice(vendorId: Int, productId: Int): JsAny = js("({ filters: [{ vendorId, productId }] })")

internal fun vendorRequest(request: Int, value: Int): JsAny =
    js("({ requestType: 'vendor', recipient: 'device', request, value, index: 0 })")

/** The number of the endpoint of the first interface in [direction], `in` or `out`; 0 for none. */
internal fun endpointOf(device: UsbDevice, direction: String): Int = js(
    """(() => {
        const found = device.configuration.interfaces[0].alternate.endpoints.find((each) => each.direction === direction);
        return found ? found.endpointNumber : 0;
    })()""",
)

internal fun bytesOf(result: UsbInResult): JsBytes = js(
    "result.data ? new Uint8Array(result.data.buffer, result.data.byteOffset, result.data.byteLength) : new Uint8Array(0)",
)
