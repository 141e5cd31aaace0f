package robotran.android.hub

import android.app.Application
import android.content.pm.PackageManager
import android.hardware.usb.UsbConstants
import android.hardware.usb.UsbDevice
import android.hardware.usb.UsbInterface
import android.hardware.usb.UsbManager
import kotlinx.coroutines.CancellationException
import kotlinx.coroutines.launch
import kotlinx.coroutines.runBlocking
import kotlinx.coroutines.withTimeout
import org.junit.Assert.assertArrayEquals
import org.junit.Assert.assertEquals
import org.junit.Assert.assertFalse
import org.junit.Assert.assertTrue
import org.junit.Before
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.RobolectricTestRunner
import org.robolectric.RuntimeEnvironment
import org.robolectric.Shadows.shadowOf
import org.robolectric.annotation.Config
import robotran.android.tower.AndroidTowersTest.RecordedConnection
import robotran.android.tower.usbDevice
import robotran.android.tower.usbInterface
import robotran.hublink.HubError
import robotran.hublink.connection.ChosenHub
import robotran.hublink.connection.HubConnection
import robotran.hublink.connection.HubDevice
import robotran.hublink.connection.HubTransport
import robotran.hublink.connection.HubValue
import robotran.hublink.connection.OpenedHub
import kotlin.time.Duration.Companion.seconds

@RunWith(RobolectricTestRunner::class)
@Config(shadows = [RecordedConnection::class])
class UsbHubsTest {
    private val context: Application = RuntimeEnvironment.getApplication()
    private val manager = checkNotNull(context.getSystemService(UsbManager::class.java))
    private val hubs by lazy { AndroidHubPorts(context, BluetoothPermissions(context)) }

    @Before
    fun allowUsb() {
        RecordedConnection.reset()
        shadowOf(context.packageManager).setSystemFeature(PackageManager.FEATURE_BLUETOOTH_LE, false)
        shadowOf(context.packageManager).setSystemFeature(PackageManager.FEATURE_USB_HOST, true)
    }

    @Test
    fun `hubs are told from the tower and from other things, and by their firmware`() = runBlocking {
        assertEquals(setOf(HubTransport.USB_SERIAL, HubTransport.USB_PACKETS), hubs.transports)
        plug(device("tower", product = 0x0001, listOf(PACKETS)))
        plug(device("serial", product = 0x0009, listOf(CONTROL, DATA)))
        plug(device("packets", product = 0x0005, listOf(PACKETS)))
        val found = setOf(
            HubDevice("serial", "SPIKE Prime", HubTransport.USB_SERIAL),
            HubDevice("packets", "EV3", HubTransport.USB_PACKETS),
        )
        assertEquals(found, hubs.available().toSet())
        assertEquals("packets", (hubs.choose(HubTransport.USB_PACKETS) as? ChosenHub.Chosen)?.device?.id)
    }

    @Test
    fun `a hub that is not allowed or unplugged is told`() = runBlocking {
        val hub = device("serial", product = 0x0009, listOf(CONTROL, DATA))
        assertEquals(OpenedHub.Failure(HubError.OutOfReach), hubs.open(SERIAL))
        assertEquals(ChosenHub.None, hubs.choose(HubTransport.USB_SERIAL))
        plug(hub, isAllowed = false)
        assertEquals(emptyList<HubDevice>(), hubs.available())
        assertEquals(OpenedHub.Failure(HubError.NotAllowed), hubs.open(SERIAL))
        plug(hub)
        RecordedConnection.isHeld = true
        assertEquals(OpenedHub.Failure(HubError.Taken), hubs.open(SERIAL))
    }

    @Test
    fun `a serial hub is opened with DTR on, and frames go both ways`() = runBlocking {
        plug(device("serial", product = 0x0009, listOf(CONTROL, DATA)))
        val connection = (hubs.open(SERIAL) as OpenedHub.Success).connection
        assertEquals(listOf("claim", "claim", "21 22 3"), RecordedConnection.calls)
        val outgoing = checkNotNull(RecordedConnection.latest).outgoingDataStream
        assertTrue(connection.subscribe())
        // A frame of at least the two bytes that ask for events, and its end.
        assertEquals(4, outgoing.readNBytes(4).size)
        connection.close()
        assertFalse(connection.subscribe())
    }

    @Test
    fun `values of a hub with packets are read by control transfers, and its events are heard`() = runBlocking {
        plug(device("packets", product = 0x0005, listOf(PACKETS)))
        val connection = (hubs.open(HubDevice("packets", "", HubTransport.USB_PACKETS)) as OpenedHub.Success).connection
        assertEquals(20, connection.read(HubValue.FIRMWARE)?.size)
        assertEquals(listOf("claim", "A1 1 ${0x2A26}"), RecordedConnection.calls)
        val event =
            heard(connection) {
                checkNotNull(RecordedConnection.latest).writeIncomingData(byteArrayOf(2, 0) + ByteArray(62) { 7 })
            }
        assertArrayEquals(byteArrayOf(0) + ByteArray(62) { 7 }, event)
        connection.close()
    }

    private suspend fun heard(connection: HubConnection, happens: () -> Unit): ByteArray? = runBlocking {
        var heard: ByteArray? = null
        val listening = launch {
            connection.listen {
                heard = it
                throw CancellationException("heard")
            }
        }
        happens()
        withTimeout(5.seconds) { listening.join() }
        heard
    }

    private fun plug(device: UsbDevice, isAllowed: Boolean = true) =
        shadowOf(manager).addOrUpdateUsbDevice(device, isAllowed)

    private companion object {
        val SERIAL = HubDevice("serial", "SPIKE Prime", HubTransport.USB_SERIAL)
        val CONTROL = usbInterface(0, UsbConstants.USB_CLASS_COMM, subclass = 2, endpoints = null)
        val DATA = line(1, UsbConstants.USB_CLASS_CDC_DATA)
        val PACKETS = line(0, UsbConstants.USB_CLASS_VENDOR_SPEC, subclass = 0xC5, protocol = 0xF5)

        fun line(number: Int, lineClass: Int, subclass: Int = 0, protocol: Int = 0) =
            usbInterface(number, lineClass, subclass, protocol, UsbConstants.USB_ENDPOINT_XFER_BULK, packetSize = 64)

        fun device(name: String, product: Int, lines: List<UsbInterface>) =
            usbDevice(name, vendor = 0x0694, product, "hub", lines)
    }
}
