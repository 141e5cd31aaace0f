@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.tower

import kotlin.js.Promise

/** The parts of the Web Serial API that towers need. */
internal external interface Serial : JsAny {
    fun getPorts(): Promise<JsArray<SerialPort>>

    /** Shows the browser's dialog; rejected with `NotFoundError` if the pupil chooses nothing. */
    fun requestPort(): Promise<SerialPort>
}

internal external interface SerialPort : JsAny {
    /** Null once the device is gone. After a damaged byte another one takes its place. */
    val readable: ReadableStream?
    val writable: WritableStream?

    fun open(options: JsAny): Promise<JsAny?>

    fun close(): Promise<JsAny?>

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

/** The options of a tower's port. The browser's default buffer is smaller than the echo of a message. */
internal fun towerLine(): JsAny = js("({ baudRate: 2400, dataBits: 8, stopBits: 1, parity: 'odd', bufferSize: 65536 })")
