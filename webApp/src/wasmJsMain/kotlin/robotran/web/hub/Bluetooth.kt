@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.hub

import robotran.web.device.JsBytes
import kotlin.js.Promise

/** The parts of the Web Bluetooth API that hubs need. */
internal external interface Bluetooth : JsAny {
    /** Shows the browser's dialog; rejected with `NotFoundError` if the pupil chooses nothing. */
    fun requestDevice(options: JsAny): Promise<BluetoothDevice>
}

internal external interface BluetoothDevice : JsAny {
    val name: String?
    val gatt: BluetoothServer

    fun addEventListener(type: String, listener: (JsAny) -> Unit)
}

internal external interface BluetoothServer : JsAny {
    val connected: Boolean

    fun connect(): Promise<JsAny?>

    fun disconnect()

    fun getPrimaryService(uuid: String): Promise<BluetoothService>
}

internal external interface BluetoothService : JsAny {
    fun getCharacteristic(uuid: String): Promise<BluetoothCharacteristic>
}

internal external interface BluetoothCharacteristic : JsAny {
    fun readValue(): Promise<DataView>

    fun writeValueWithResponse(bytes: JsBytes): Promise<JsAny?>

    fun startNotifications(): Promise<JsAny?>

    fun stopNotifications(): Promise<JsAny?>

    fun addEventListener(type: String, listener: (JsAny) -> Unit)
}

/** JavaScript's `DataView`. */
internal external interface DataView : JsAny

/** Null in browsers without Web Bluetooth, and on pages that are neither `https` nor on this machine. */
internal fun browserBluetooth(): Bluetooth? = js("navigator.bluetooth || null")

/**
 * Hubs that offer one of [services]; the page may use what is in [also], too.
 *
 * @param services UUIDs, with commas between them.
 */
internal fun hubsWith(services: String, also: String): JsAny = js(
    """({
        filters: services.split(',').map((each) => ({ services: [each] })),
        optionalServices: also.split(','),
    })""",
)

/** The value that the event `characteristicvaluechanged` tells. */
internal fun valueOf(event: JsAny): DataView = js("event.target.value")

internal fun bytesOf(view: DataView): JsBytes = js("new Uint8Array(view.buffer, view.byteOffset, view.byteLength)")
