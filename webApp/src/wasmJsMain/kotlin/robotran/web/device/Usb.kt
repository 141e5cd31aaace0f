@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.device

import kotlin.js.Promise

/** The parts of the WebUSB API that towers, hubs and micro:bits need. */
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

    fun controlTransferOut(setup: JsAny, bytes: JsBytes): Promise<UsbOutResult>

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

internal fun bytesOf(result: UsbInResult): JsBytes = js(
    "result.data ? new Uint8Array(result.data.buffer, result.data.byteOffset, result.data.byteLength) : new Uint8Array(0)",
)
