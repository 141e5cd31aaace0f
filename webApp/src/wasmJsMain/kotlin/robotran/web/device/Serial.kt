@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.device

import kotlin.js.Promise

/** The parts of the Web Serial API that towers and hubs need. */
internal external interface Serial : JsAny {
    fun getPorts(): Promise<JsArray<SerialPort>>

    /** Shows the browser's dialog; rejected with `NotFoundError` if the pupil chooses nothing. */
    fun requestPort(): Promise<SerialPort>

    fun requestPort(options: JsAny): Promise<SerialPort>
}

internal external interface SerialPort : JsAny {
    /** Null once the device is gone. After a damaged byte another one takes its place. */
    val readable: ReadableStream?
    val writable: WritableStream?

    fun open(options: JsAny): Promise<JsAny?>

    fun close(): Promise<JsAny?>

    fun setSignals(signals: JsAny): Promise<JsAny?>

    fun getInfo(): SerialPortInfo
}

internal external interface SerialPortInfo : JsAny {
    val usbVendorId: Int?
    val usbProductId: Int?
}

internal external interface ReadableStream : JsAny {
    fun getReader(): StreamReader
}

internal external interface StreamReader : JsAny {
    fun read(): Promise<StreamPart>

    fun cancel(): Promise<JsAny?>

    fun releaseLock()
}

internal external interface StreamPart : JsAny {
    val done: Boolean
    val value: JsBytes?
}

internal external interface WritableStream : JsAny {
    fun getWriter(): StreamWriter
}

internal external interface StreamWriter : JsAny {
    fun write(bytes: JsBytes): Promise<JsAny?>

    fun releaseLock()
}

/** Null in browsers without Web Serial, and on pages that are neither `https` nor on this machine. */
internal fun browserSerial(): Serial? = js("navigator.serial || null")
