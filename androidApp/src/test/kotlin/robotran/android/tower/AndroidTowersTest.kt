package robotran.android.tower

import android.app.Application
import android.content.Intent
import android.content.pm.PackageManager
import android.hardware.usb.UsbConstants
import android.hardware.usb.UsbDevice
import android.hardware.usb.UsbDeviceConnection
import android.hardware.usb.UsbInterface
import android.hardware.usb.UsbManager
import android.os.Looper
import kotlinx.coroutines.async
import kotlinx.coroutines.runBlocking
import kotlinx.coroutines.yield
import org.junit.Assert.assertArrayEquals
import org.junit.Assert.assertEquals
import org.junit.Assert.assertFalse
import org.junit.Assert.assertNull
import org.junit.Before
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.RobolectricTestRunner
import org.robolectric.RuntimeEnvironment
import org.robolectric.Shadows.shadowOf
import org.robolectric.annotation.Config
import org.robolectric.annotation.Implementation
import org.robolectric.annotation.Implements
import org.robolectric.annotation.Resetter
import org.robolectric.shadows.ShadowUsbDeviceConnection
import robotran.tower.port.OpenFailure
import robotran.tower.port.OpenedTower
import robotran.tower.port.TowerDevice
import robotran.tower.port.TowerKind

@RunWith(RobolectricTestRunner::class)
@Config(shadows = [AndroidTowersTest.RecordedConnection::class])
class AndroidTowersTest {
    private val context: Application = RuntimeEnvironment.getApplication()
    private val manager = checkNotNull(context.getSystemService(UsbManager::class.java))
    private val tower = usbDevice("/dev/bus/usb/001/004", vendor = 0x0694, product = 0x0001)
    private val towers by lazy { AndroidTowers(context) }

    @Before
    fun allowUsb() {
        RecordedConnection.reset()
        shadowOf(context.packageManager).setSystemFeature(PackageManager.FEATURE_USB_HOST, true)
    }

    @Test
    fun `a device that is no USB host reaches no tower`() = runBlocking {
        shadowOf(context.packageManager).setSystemFeature(PackageManager.FEATURE_USB_HOST, false)
        assertEquals(emptySet<TowerKind>(), towers.kinds)
        assertNull(towers.choose(TowerKind.USB))
    }

    @Test
    fun `only towers are found among what is plugged in, and only if they are allowed`() = runBlocking {
        plug(usbDevice("/dev/bus/usb/001/002", vendor = 0x046D, product = 0xC077), isAllowed = true)
        assertEquals(emptyList<TowerDevice>(), towers.available())
        plug(tower, isAllowed = false)
        assertEquals(emptyList<TowerDevice>(), towers.available())
        plug(tower, isAllowed = true)
        assertEquals(listOf(TOWER), towers.available())
    }

    @Test
    fun `the user is asked for a tower that was not allowed yet`() = runBlocking {
        plug(tower, isAllowed = false)
        val chosen = async { towers.choose(TowerKind.USB) }
        yield()
        plug(tower, isAllowed = true)
        answer()
        assertEquals(TOWER, chosen.await())
    }

    @Test
    fun `a user who does not allow it has chosen no tower, whatever another app claims`() = runBlocking {
        plug(tower, isAllowed = false)
        val chosen = async { towers.choose(TowerKind.USB) }
        yield()
        answer { putExtra(UsbManager.EXTRA_PERMISSION_GRANTED, true) }
        assertNull(chosen.await())
        assertEquals(OpenedTower.Failure(OpenFailure.NOT_ALLOWED), towers.open(TOWER))
    }

    @Test
    fun `without a tower nobody is asked, and one that was unplugged cannot be opened`() = runBlocking {
        assertNull(towers.choose(TowerKind.USB))
        assertEquals(OpenedTower.Failure(OpenFailure.GONE), towers.open(TOWER))
    }

    @Test
    fun `an open tower was reset and flushed, sends what it is given and hands over what comes`() = runBlocking {
        plug(tower, isAllowed = true)
        val port = (towers.open(TOWER) as OpenedTower.Success).port
        assertEquals(listOf("C0 FD 0", "C0 4 0", "claim", "C0 3 3"), RecordedConnection.calls)
        assertEquals(TowerKind.USB, port.kind)
        val connection = checkNotNull(RecordedConnection.latest)
        val outgoing = connection.outgoingDataStream
        val sent = byteArrayOf(0x55, -1, 0, 0x10, -17, 0x10, -17)
        assertEquals(true, port.send(sent))
        assertArrayEquals(sent, outgoing.readNBytes(sent.size))
        val packet = ByteArray(8) { it.toByte() }
        connection.writeIncomingData(packet)
        assertArrayEquals(packet, port.receive())
        port.close()
        assertFalse(port.send(sent))
        assertNull(port.receive())
    }

    @Test
    fun `a tower whose interface is held by something else is told`() = runBlocking {
        plug(tower, isAllowed = true)
        RecordedConnection.isHeld = true
        assertEquals(OpenedTower.Failure(OpenFailure.HELD_BY_DRIVER), towers.open(TOWER))
    }

    private fun plug(device: UsbDevice, isAllowed: Boolean) = shadowOf(manager).addOrUpdateUsbDevice(device, isAllowed)

    /** The system's answer to the question for permission. */
    private fun answer(more: Intent.() -> Unit = { }) {
        context.sendBroadcast(Intent("robotran.android.USB_PERMISSION").setPackage(context.packageName).apply(more))
        shadowOf(Looper.getMainLooper()).idle()
    }

    /** Records what Robolectric's connection does not. */
    @Implements(UsbDeviceConnection::class)
    class RecordedConnection : ShadowUsbDeviceConnection() {
        @Implementation
        override fun claimInterface(line: UsbInterface, force: Boolean): Boolean {
            calls += "claim"
            latest = this
            return !isHeld && super.claimInterface(line, force)
        }

        @Implementation
        override fun controlTransfer(
            requestType: Int,
            request: Int,
            value: Int,
            index: Int,
            buffer: ByteArray?,
            length: Int,
            timeout: Int,
        ): Int {
            calls += "${requestType.toString(16).uppercase()} ${request.toString(16).uppercase()} $value"
            return length
        }

        companion object {
            val calls = mutableListOf<String>()
            var latest: RecordedConnection? = null
            var isHeld = false

            @Resetter
            @JvmStatic
            fun reset() {
                calls.clear()
                latest = null
                isHeld = false
            }
        }
    }

    private companion object {
        val TOWER = TowerDevice("/dev/bus/usb/001/004", "LEGO USB Tower", TowerKind.USB)

        fun usbDevice(name: String, vendor: Int, product: Int): UsbDevice =
            usbDevice(name, vendor, product, "LEGO USB Tower", listOf(interruptLine()))

        /** One interface with two interrupt endpoints of eight bytes, like the tower's. */
        private fun interruptLine() =
            usbInterface(number = 0, UsbConstants.USB_CLASS_VENDOR_SPEC, endpoints = UsbConstants.USB_ENDPOINT_XFER_INT)
    }
}
