package robotran.android.microbit

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
import org.junit.Assert.assertNull
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
import robotran.microbitlink.BoardError
import robotran.microbitlink.dap.ChosenBoard
import robotran.microbitlink.dap.DapPort
import robotran.microbitlink.dap.OpenedBoard
import robotran.microbitlink.dap.PluggedBoard
import kotlin.time.Duration.Companion.seconds

@RunWith(RobolectricTestRunner::class)
@Config(shadows = [RecordedConnection::class])
class AndroidMicrobitPortsTest {
    private val context: Application = RuntimeEnvironment.getApplication()
    private val manager = checkNotNull(context.getSystemService(UsbManager::class.java))
    private val boards by lazy { AndroidMicrobitPorts(context) }

    @Before
    fun allowUsb() {
        RecordedConnection.reset()
        shadowOf(context.packageManager).setSystemFeature(PackageManager.FEATURE_USB_HOST, true)
    }

    @Test
    fun `a micro bit is told from other things at the cable`() = runBlocking {
        assertTrue(boards.canReach)
        plug(usbDevice("hub", vendor = 0x0694, product = 0x0009, "hub", listOf(V2_LINE)))
        assertEquals(ChosenBoard.None, boards.choose())
        plug(board(V2_LINE))
        assertEquals(listOf(BOARD), boards.available())
        assertEquals(ChosenBoard.Chosen(BOARD), boards.choose())
    }

    @Test
    fun `of several boards the app asks for one`() = runBlocking {
        plug(board(V2_LINE))
        plug(board(V1_LINE, id = OTHER.id))
        assertEquals(setOf(BOARD, OTHER), (boards.choose() as ChosenBoard.Several).boards.toSet())
    }

    @Test
    fun `a device that is no host reaches none`() = runBlocking {
        shadowOf(context.packageManager).setSystemFeature(PackageManager.FEATURE_USB_HOST, false)
        assertFalse(boards.canReach)
        assertEquals(emptyList<PluggedBoard>(), boards.available())
        assertEquals(ChosenBoard.None, boards.choose())
    }

    @Test
    fun `a board that is unplugged, not allowed, held or too old is told`() = runBlocking {
        assertEquals(OpenedBoard.Failure(BoardError.OutOfReach), boards.open(BOARD))
        plug(board(V2_LINE), isAllowed = false)
        assertEquals(emptyList<PluggedBoard>(), boards.available())
        assertEquals(OpenedBoard.Failure(BoardError.NotAllowed), boards.open(BOARD))
        plug(board(V2_LINE))
        RecordedConnection.isHeld = true
        assertEquals(OpenedBoard.Failure(BoardError.Taken), boards.open(BOARD))
        RecordedConnection.reset()
        plug(board(DRIVE))
        assertEquals(OpenedBoard.Failure(BoardError.InterfaceTooOld), boards.open(BOARD))
        assertEquals(emptyList<String>(), RecordedConnection.calls)
    }

    @Test
    fun `packets of a V2 go through the interface with endpoints`() = runBlocking {
        plug(board(DRIVE, V1_LINE, V2_LINE))
        val port = open()
        val connection = checkNotNull(RecordedConnection.latest)
        val packet = ByteArray(64) { it.toByte() }
        assertTrue(port.send(packet))
        assertArrayEquals(packet, connection.outgoingDataStream.readNBytes(64))
        connection.writeIncomingData(byteArrayOf(0x80.toByte()) + ByteArray(63))
        assertEquals(0x80.toByte(), withTimeout(PATIENCE) { port.receive() }?.first())
        port.close()
        assertFalse(port.send(packet))
        assertNull(port.receive())
    }

    @Test
    fun `packets of a V1 are reports of control transfers, one answer each`() = runBlocking {
        plug(board(DRIVE, V1_LINE))
        val port = open()
        assertTrue(port.send(ByteArray(64)))
        assertEquals(64, withTimeout(PATIENCE) { port.receive() }?.size)
        assertEquals(listOf("claim", "21 9 ${0x0200}", "A1 1 ${0x0100}"), RecordedConnection.calls)
        port.close()
        assertFalse(port.send(ByteArray(64)))
        assertNull(port.receive())
    }

    @Test
    fun `waiting for a packet can be cancelled`() = runBlocking {
        for (line in listOf(V1_LINE, V2_LINE)) {
            plug(board(line))
            val port = open()
            val waiting = launch { port.receive() }
            waiting.cancel(CancellationException("enough"))
            withTimeout(PATIENCE) { waiting.join() }
            port.close()
        }
    }

    private suspend fun open(): DapPort = (boards.open(BOARD) as OpenedBoard.Success).port

    private fun plug(board: UsbDevice, isAllowed: Boolean = true) {
        shadowOf(manager).addOrUpdateUsbDevice(board, isAllowed)
    }

    private companion object {
        val PATIENCE = 20.seconds
        val BOARD = PluggedBoard("board", "BBC micro:bit CMSIS-DAP")
        val DRIVE =
            usbInterface(0, UsbConstants.USB_CLASS_MASS_STORAGE, endpoints = UsbConstants.USB_ENDPOINT_XFER_BULK)
        val V1_LINE = usbInterface(4, UsbConstants.USB_CLASS_VENDOR_SPEC, subclass = 3, endpoints = null)
        val V2_LINE = usbInterface(
            5,
            UsbConstants.USB_CLASS_VENDOR_SPEC,
            endpoints = UsbConstants.USB_ENDPOINT_XFER_BULK,
            packetSize = 64,
        )

        val OTHER = BOARD.copy(id = "other")

        fun board(vararg lines: UsbInterface, id: String = BOARD.id) =
            usbDevice(id, vendor = 0x0D28, product = 0x0204, BOARD.name, lines.toList())
    }
}
