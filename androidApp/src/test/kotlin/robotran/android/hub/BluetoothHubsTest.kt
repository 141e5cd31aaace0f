package robotran.android.hub

import android.Manifest
import android.app.Application
import android.bluetooth.BluetoothDevice
import android.bluetooth.BluetoothGatt
import android.bluetooth.BluetoothGattCharacteristic
import android.bluetooth.BluetoothGattDescriptor
import android.bluetooth.BluetoothGattService
import android.bluetooth.BluetoothManager
import android.bluetooth.BluetoothProfile
import android.bluetooth.le.ScanResult
import android.content.pm.PackageManager
import android.os.Looper
import kotlinx.coroutines.async
import kotlinx.coroutines.launch
import kotlinx.coroutines.runBlocking
import kotlinx.coroutines.yield
import org.junit.Assert.assertArrayEquals
import org.junit.Assert.assertEquals
import org.junit.Assert.assertNull
import org.junit.Assert.assertTrue
import org.junit.Before
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.RobolectricTestRunner
import org.robolectric.RuntimeEnvironment
import org.robolectric.Shadows.shadowOf
import robotran.hublink.HubError
import robotran.hublink.connection.ChosenHub
import robotran.hublink.connection.CommandAnswer
import robotran.hublink.connection.HubConnection
import robotran.hublink.connection.HubDevice
import robotran.hublink.connection.HubTransport
import robotran.hublink.connection.HubUuids
import robotran.hublink.connection.HubValue
import robotran.hublink.connection.OpenedHub
import java.util.UUID

@RunWith(RobolectricTestRunner::class)
class BluetoothHubsTest {
    private val context: Application = RuntimeEnvironment.getApplication()
    private val adapter = checkNotNull(context.getSystemService(BluetoothManager::class.java)).adapter
    private val device: BluetoothDevice = adapter.getRemoteDevice(ADDRESS)
    private val ports by lazy { AndroidHubPorts(context, BluetoothPermissions(context)) }

    @Before
    fun switchOn() {
        shadowOf(context.packageManager).setSystemFeature(PackageManager.FEATURE_BLUETOOTH_LE, true)
        shadowOf(context.packageManager).setSystemFeature(PackageManager.FEATURE_USB_HOST, false)
        shadowOf(adapter).setEnabled(true)
    }

    private fun allow() = shadowOf(context)
        .grantPermissions(Manifest.permission.BLUETOOTH_SCAN, Manifest.permission.BLUETOOTH_CONNECT)

    @Test
    fun `a device without Bluetooth reaches no hub`() {
        shadowOf(context.packageManager).setSystemFeature(PackageManager.FEATURE_BLUETOOTH_LE, false)
        assertEquals(emptySet<HubTransport>(), ports.transports)
    }

    @Test
    fun `without the permissions nothing is looked for and nothing opened`() = runBlocking {
        assertEquals(setOf(HubTransport.BLUETOOTH), ports.transports)
        assertEquals(emptyList<HubDevice>(), ports.available())
        assertEquals(ChosenHub.Refused(HubError.BluetoothNotAllowed), ports.choose(HubTransport.BLUETOOTH))
        assertEquals(OpenedHub.Failure(HubError.BluetoothNotAllowed), ports.open(HUB))
    }

    @Test
    fun `the only hub that shows itself is chosen, and of several none`() = runBlocking {
        allow()
        assertEquals(ADDRESS, whileLooking { show(ADDRESS) }?.id)
        assertNull(
            whileLooking {
                show(ADDRESS)
                show("00:11:22:33:44:66")
            },
        )
        assertEquals(listOf(ADDRESS, "00:11:22:33:44:66"), ports.available().map { it.id })
    }

    @Test
    fun `with Bluetooth off a hub is out of reach`() = runBlocking {
        allow()
        shadowOf(adapter).setEnabled(false)
        assertEquals(ChosenHub.None, ports.choose(HubTransport.BLUETOOTH))
        assertEquals(OpenedHub.Failure(HubError.OutOfReach), ports.open(HUB))
    }

    @Test
    fun `an open hub tells what it is, takes commands and tells events until it is gone`() = runBlocking {
        allow()
        val connection = (open(pybricks()) as OpenedHub.Success).connection
        assertEquals("4.0.1", connection.read(HubValue.FIRMWARE)?.decodeToString())
        assertEquals("Ada", connection.read(HubValue.NAME)?.decodeToString())
        assertNull(connection.read(HubValue.PNP_ID))
        assertTrue(connection.subscribe())
        val command = byteArrayOf(3, 0, 0, 0, 0)
        assertEquals(CommandAnswer.Accepted, connection.command(command))
        assertArrayEquals(command, shadowOf(gatt).latestWrittenBytes)
        assertArrayEquals(byteArrayOf(0, 1, 2), heard(connection).single())
        assertEquals(CommandAnswer.Gone, connection.command(command))
    }

    @Test
    fun `a command that Android does not begin has no answer, and closing releases the hub`() = runBlocking {
        allow()
        val connection = (open(pybricks(canWrite = false)) as OpenedHub.Success).connection
        assertEquals(CommandAnswer.Unanswered, connection.command(byteArrayOf(0)))
        connection.close()
        assertTrue(shadowOf(gatt).isClosed)
    }

    @Test
    fun `a hub without the service of Pybricks has LEGO's firmware, and is released`() = runBlocking {
        allow()
        val lego =
            BluetoothGattService(UUID.fromString(HubUuids.LEGO_SERVICE), BluetoothGattService.SERVICE_TYPE_PRIMARY)
        assertEquals(OpenedHub.Failure(HubError.LegoFirmware), open(listOf(lego)))
        assertTrue(shadowOf(gatt).isClosed)
    }

    private val gatt: BluetoothGatt get() = shadowOf(device).bluetoothGatts.last()

    private suspend fun open(services: List<BluetoothGattService>): OpenedHub = runBlocking {
        val opened = async { ports.open(HUB) }
        yield()
        services.forEach { shadowOf(gatt).addDiscoverableService(it) }
        for (service in services) service.characteristics.forEach { shadowOf(gatt).allowCharacteristicNotification(it) }
        shadowOf(device).simulateGattConnectionChange(BluetoothGatt.GATT_SUCCESS, BluetoothProfile.STATE_CONNECTED)
        opened.await()
    }

    /** What the hub tells, one event, before it is gone. */
    @Suppress("DEPRECATION")
    private suspend fun heard(connection: HubConnection): List<ByteArray> = runBlocking {
        val heard = mutableListOf<ByteArray>()
        val listening = launch { connection.listen { heard += it } }
        yield()
        val commands = gatt.getService(UUID.fromString(HubUuids.SERVICE))
            .getCharacteristic(UUID.fromString(HubUuids.COMMANDS))
        commands.value = byteArrayOf(0, 1, 2)
        shadowOf(gatt).gattCallback.onCharacteristicChanged(gatt, commands)
        shadowOf(device).simulateGattConnectionChange(BluetoothGatt.GATT_SUCCESS, BluetoothProfile.STATE_DISCONNECTED)
        listening.join()
        heard
    }

    private suspend fun whileLooking(happens: () -> Unit): HubDevice? = runBlocking {
        val chosen = async { ports.choose(HubTransport.BLUETOOTH) }
        yield()
        happens()
        shadowOf(Looper.getMainLooper()).idle()
        (chosen.await() as? ChosenHub.Chosen)?.device
    }

    @Suppress("DEPRECATION")
    private fun show(address: String) {
        val result = ScanResult(adapter.getRemoteDevice(address), null, -60, 0)
        shadowOf(adapter.bluetoothLeScanner).scanCallbacks.forEach { it.onScanResult(0, result) }
    }

    @Suppress("DEPRECATION")
    private fun pybricks(canWrite: Boolean = true): List<BluetoothGattService> {
        val properties = if (canWrite) BluetoothGattCharacteristic.PROPERTY_WRITE else 0
        val commands = BluetoothGattCharacteristic(UUID.fromString(HubUuids.COMMANDS), properties, WRITABLE)
        val configuration = UUID.fromString("00002902-0000-1000-8000-00805f9b34fb")
        commands.addDescriptor(BluetoothGattDescriptor(configuration, WRITABLE))
        val firmware = BluetoothGattCharacteristic(
            UUID.fromString(HubUuids.of(HubValue.FIRMWARE)),
            BluetoothGattCharacteristic.PROPERTY_READ,
            BluetoothGattCharacteristic.PERMISSION_READ,
        )
        firmware.value = "4.0.1".encodeToByteArray()
        return listOf(HubUuids.SERVICE to commands, HubUuids.DEVICE_INFORMATION to firmware).map { (id, value) ->
            BluetoothGattService(UUID.fromString(id), BluetoothGattService.SERVICE_TYPE_PRIMARY)
                .apply { addCharacteristic(value) }
        }
    }

    private companion object {
        const val ADDRESS = "00:11:22:33:44:55"
        const val WRITABLE = BluetoothGattCharacteristic.PERMISSION_WRITE
        val HUB = HubDevice(ADDRESS, "Ada", HubTransport.BLUETOOTH)
    }
}
