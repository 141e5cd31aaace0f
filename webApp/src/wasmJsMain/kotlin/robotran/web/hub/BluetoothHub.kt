@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.hub

import kotlinx.coroutines.delay
import robotran.hublink.HubError
import robotran.hublink.connection.CommandAnswer
import robotran.hublink.connection.HubConnection
import robotran.hublink.connection.HubUuids
import robotran.hublink.connection.HubValue
import robotran.hublink.connection.OpenedHub
import robotran.web.device.Outcome
import robotran.web.device.ReceivedPackets
import robotran.web.device.outcome
import robotran.web.device.toByteArray
import robotran.web.device.toJs
import kotlin.js.Promise
import kotlin.time.Duration.Companion.seconds

/** A hub by Bluetooth, which is connected. [commands] takes commands and tells events. */
internal class BluetoothHub private constructor(
    private val device: BluetoothDevice,
    private val service: BluetoothService,
    private val commands: BluetoothCharacteristic,
) : HubConnection {
    override val isSureOfPybricks: Boolean get() = true

    private val events = ReceivedPackets()

    /** Bluetooth takes one operation after the other, also if nobody waits for the first any more. */
    private var last: Promise<JsAny?>? = null

    init {
        commands.addEventListener("characteristicvaluechanged") { events.add(bytesOf(valueOf(it)).toByteArray()) }
        device.addEventListener("gattserverdisconnected") { events.end() }
        if (!device.gatt.connected) events.end()
    }

    override suspend fun listen(take: (ByteArray) -> Unit) {
        while (true) take(events.take() ?: break)
    }

    override suspend fun read(value: HubValue): ByteArray? {
        if (value == HubValue.NAME) return device.name?.encodeToByteArray()
        val from = if (value == HubValue.CAPABILITIES) service else information() ?: return null
        val found = from.getCharacteristic(HubUuids.of(value)).outcome().valueOrNull ?: return null
        val read = operate { found.readValue() }.valueOrNull ?: return null
        return bytesOf(read.unsafeCast()).toByteArray()
    }

    private suspend fun information(): BluetoothService? =
        device.gatt.getPrimaryService(HubUuids.DEVICE_INFORMATION).outcome().valueOrNull

    override suspend fun subscribe(): Boolean {
        // Without this, nothing comes after a second connection.
        operate { commands.stopNotifications() }
        return operate { commands.startNotifications() }.error == null
    }

    override suspend fun command(command: ByteArray): CommandAnswer {
        val error = operate { commands.writeValueWithResponse(command.toJs()) }.error
        return when {
            error == null -> CommandAnswer.Accepted
            !device.gatt.connected -> CommandAnswer.Gone
            else -> CommandAnswer.Refused(null)
        }
    }

    override suspend fun close() {
        device.gatt.disconnect()
        events.end()
    }

    private suspend fun <T : JsAny?> operate(operation: () -> Promise<T>): Outcome<T> {
        while (true) {
            val before = last ?: break
            before.outcome()
            if (last === before) last = null
        }
        val promise = operation()
        last = promise.unsafeCast()
        return promise.outcome()
    }

    companion object {
        /** A hub needs a moment before it answers; Pybricks' own editor waits as long. */
        private val READY = 1.seconds

        suspend fun open(device: BluetoothDevice): OpenedHub {
            device.gatt.connect().outcome().error?.let { return OpenedHub.Failure(errorOf(it)) }
            delay(READY)
            val found = findIn(device)
            if (found is OpenedHub.Failure) device.gatt.disconnect()
            return found
        }

        private suspend fun findIn(device: BluetoothDevice): OpenedHub {
            val service = device.gatt.getPrimaryService(HubUuids.SERVICE).outcome()
            service.error?.let { error ->
                val isGone = !device.gatt.connected
                return OpenedHub.Failure(if (isGone) HubError.OutOfReach else errorOfService(error))
            }
            val commands = service.value.getCharacteristic(HubUuids.COMMANDS).outcome()
            if (commands.error != null) {
                return OpenedHub.Failure(if (device.gatt.connected) HubError.TooOld(null) else HubError.OutOfReach)
            }
            return OpenedHub.Success(BluetoothHub(device, service.value, commands.value))
        }

        private fun errorOfService(error: String) =
            if (error == "NotFoundError") HubError.LegoFirmware else errorOf(error)

        private fun errorOf(error: String): HubError = when (error) {
            "SecurityError", "NotAllowedError" -> HubError.NotAllowed
            else -> HubError.OutOfReach
        }
    }
}

private val <T : JsAny?> Outcome<T>.valueOrNull: T? get() = if (error == null) value else null
