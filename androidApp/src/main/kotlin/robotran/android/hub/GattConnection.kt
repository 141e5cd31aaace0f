package robotran.android.hub

import android.annotation.SuppressLint
import android.bluetooth.BluetoothDevice
import android.bluetooth.BluetoothGatt
import android.bluetooth.BluetoothGattCallback
import android.bluetooth.BluetoothGattCharacteristic
import android.bluetooth.BluetoothGattDescriptor
import android.bluetooth.BluetoothProfile
import android.content.Context
import android.os.Handler
import android.os.Looper
import kotlinx.coroutines.CompletableDeferred
import kotlinx.coroutines.channels.BufferOverflow
import kotlinx.coroutines.channels.Channel
import kotlinx.coroutines.withTimeoutOrNull
import robotran.hublink.HubError
import robotran.hublink.connection.HubUuids
import robotran.hublink.connection.OpenedHub
import java.util.UUID
import kotlin.time.Duration
import kotlin.time.Duration.Companion.seconds

/**
 * Android's side of a connection by Bluetooth. It does one thing at a time, so each waits for the one before, also if that
 * was given up. Everything happens on the main thread: what is written and what is heard share a buffer in Android.
 */
@SuppressLint("MissingPermission") // BluetoothHubs looks at the permissions before it opens one.
internal class GattConnection : BluetoothGattCallback() {
    private var gatt: BluetoothGatt? = null
    private var inFlight: CompletableDeferred<GattAnswer>? = null

    var isGone = false
        private set

    /** What the hub tells, in order. Closed once it is gone. */
    val events = Channel<ByteArray>(MOST_EVENTS, BufferOverflow.DROP_OLDEST)

    /** The characteristic [id] of [service]; null if the hub has none. */
    fun characteristic(service: String, id: String): BluetoothGattCharacteristic? =
        gatt?.getService(UUID.fromString(service))?.getCharacteristic(UUID.fromString(id))

    suspend fun read(value: BluetoothGattCharacteristic): GattAnswer = operate { it.readCharacteristic(value) }

    @Suppress("DEPRECATION") // What is newer is not in Android 8.
    suspend fun write(value: BluetoothGattCharacteristic, bytes: ByteArray): GattAnswer = operate {
        value.writeType = BluetoothGattCharacteristic.WRITE_TYPE_DEFAULT
        value.value = bytes
        it.writeCharacteristic(value)
    }

    /** Asks for the events of [value]; whether the hub agrees. */
    @Suppress("DEPRECATION")
    suspend fun subscribe(value: BluetoothGattCharacteristic): Boolean {
        val configuration = value.getDescriptor(UUID.fromString(CONFIGURATION)) ?: return false
        return operate {
            configuration.value = BluetoothGattDescriptor.ENABLE_NOTIFICATION_VALUE
            it.setCharacteristicNotification(value, true) && it.writeDescriptor(configuration)
        }.isGood
    }

    fun close() {
        end()
        gatt?.disconnect()
        gatt?.close()
        gatt = null
    }

    /** Does what [begin] begins, and waits for Android's answer. */
    private suspend fun operate(begin: (BluetoothGatt) -> Boolean): GattAnswer {
        inFlight?.let { before -> withTimeoutOrNull(LATEST_ANSWER) { before.await() } }
        val gatt = gatt
        if (gatt == null || isGone) return GattAnswer.GONE
        val answer = CompletableDeferred<GattAnswer>()
        inFlight = answer
        if (!begin(gatt)) answer.complete(GattAnswer(GattAnswer.NOT_BEGUN))
        return answer.await()
    }

    private suspend fun connect(context: Context, device: BluetoothDevice): Boolean {
        val connected = CompletableDeferred<GattAnswer>()
        inFlight = connected
        gatt = device.connectGatt(
            context,
            false,
            this,
            BluetoothDevice.TRANSPORT_LE,
            BluetoothDevice.PHY_LE_1M_MASK,
            Handler(Looper.getMainLooper()),
        )
        return connected.await().isGood && operate { it.requestMtu(LARGEST) } != GattAnswer.GONE &&
            operate { it.discoverServices() }.isGood
    }

    override fun onConnectionStateChange(gatt: BluetoothGatt, status: Int, newState: Int) {
        if (status == BluetoothGatt.GATT_SUCCESS &&
            newState == BluetoothProfile.STATE_CONNECTED
        ) {
            answer(status)
        } else {
            end()
        }
    }

    override fun onMtuChanged(gatt: BluetoothGatt, mtu: Int, status: Int) = answer(status)

    override fun onServicesDiscovered(gatt: BluetoothGatt, status: Int) = answer(status)

    @Suppress("DEPRECATION")
    @Deprecated("Newer Androids call it, too.")
    override fun onCharacteristicRead(gatt: BluetoothGatt, value: BluetoothGattCharacteristic, status: Int) =
        answer(status, value.value)

    override fun onCharacteristicWrite(gatt: BluetoothGatt, value: BluetoothGattCharacteristic, status: Int) =
        answer(status)

    override fun onDescriptorWrite(gatt: BluetoothGatt, descriptor: BluetoothGattDescriptor, status: Int) =
        answer(status)

    @Suppress("DEPRECATION")
    @Deprecated("Newer Androids call it, too.")
    override fun onCharacteristicChanged(gatt: BluetoothGatt, value: BluetoothGattCharacteristic) {
        value.value?.let { events.trySend(it.copyOf()) }
    }

    private fun answer(status: Int, value: ByteArray? = null) {
        inFlight?.complete(GattAnswer(status, value?.copyOf()))
    }

    private fun end() {
        isGone = true
        inFlight?.complete(GattAnswer.GONE)
        events.close()
    }

    companion object {
        /** Of a hub that prints without end while nobody reads, the oldest are lost. */
        private const val MOST_EVENTS = 4_096

        private const val CONFIGURATION = "00002902-0000-1000-8000-00805f9b34fb"

        /** What Android takes at most; the hub and it agree on what both can do. */
        private const val LARGEST = 517
        private val LATEST_ANSWER = 5.seconds
        private val CONNECTING: Duration = 15.seconds

        /** Connects [device], which shows itself as [name]. */
        suspend fun open(context: Context, device: BluetoothDevice, name: String): OpenedHub {
            val connection = GattConnection()
            var isOpen = false
            try {
                val isConnected = withTimeoutOrNull(CONNECTING) { connection.connect(context, device) } == true
                if (!isConnected) return OpenedHub.Failure(HubError.OutOfReach)
                connection.characteristic(HubUuids.SERVICE, HubUuids.COMMANDS)
                    ?: return OpenedHub.Failure(HubError.LegoFirmware)
                isOpen = true
                return OpenedHub.Success(GattHub(connection, name))
            } finally {
                if (!isOpen) connection.close()
            }
        }
    }
}

/**
 * What became of something that was asked.
 *
 * @property status 0 for good; otherwise an error of ATT, or one of Android's.
 */
internal class GattAnswer(val status: Int, val value: ByteArray? = null) {
    val isGood: Boolean get() = status == BluetoothGatt.GATT_SUCCESS

    companion object {
        const val NOT_BEGUN = -2
        val GONE = GattAnswer(status = -1)
    }
}
