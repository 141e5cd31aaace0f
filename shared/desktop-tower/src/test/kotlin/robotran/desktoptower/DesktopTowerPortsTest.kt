package robotran.desktoptower

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.cancel
import kotlinx.coroutines.runBlocking
import org.junit.jupiter.api.condition.EnabledOnOs
import org.junit.jupiter.api.condition.OS
import robotran.legofirmware.device.DatalogEntry
import robotran.legofirmware.image.Chunk
import robotran.legofirmware.image.ChunkId
import robotran.legofirmware.image.CodeBytes
import robotran.legofirmware.image.FirmwareTarget
import robotran.legofirmware.image.RcxImage
import robotran.legofirmware.run.FirmwareState
import robotran.tower.TowerResult
import robotran.tower.TransferResult
import robotran.tower.port.OpenFailure
import robotran.tower.port.OpenedTower
import robotran.tower.port.TowerDevice
import robotran.tower.port.TowerKind
import robotran.tower.rcx.RcxTower
import robotran.tower.simulated.LineFaults
import robotran.tower.simulated.SimulatedBrick
import robotran.tower.simulated.SimulatedFirmware
import robotran.tower.simulated.SimulatedLegoFirmware
import robotran.tower.simulated.SimulatedLejos
import robotran.tower.simulated.SimulatedTower
import robotran.tower.simulated.brickAfter
import robotran.tower.simulated.programIn
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.createDirectory
import kotlin.io.path.createSymbolicLinkPointingTo
import kotlin.io.path.deleteExisting
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNull

/** Talks to a simulated brick through a pseudo-terminal, which takes the place of a serial port and of a device file. */
@EnabledOnOs(OS.LINUX)
class DesktopTowerPortsTest {
    private val scope = CoroutineScope(Dispatchers.Default)
    private val terminal = PseudoTerminal()
    private val devices: Path = Files.createTempDirectory("robotran")
    private val ports = DesktopTowerPorts(devices)
    private val lejos = SimulatedLejos()
    private val image = byteArrayOf(0xCA.toByte(), 0xF6.toByte()) + ByteArray(600) { (it * 7).toByte() }

    @AfterTest
    fun tidyUp() {
        scope.cancel()
        devices.toFile().deleteRecursively()
    }

    private fun connect(kind: TowerKind, faults: LineFaults = LineFaults(), firmware: SimulatedFirmware = lejos) {
        // One thread, as the simulation has no locks.
        val line = CoroutineScope(scope.coroutineContext + Dispatchers.Default.limitedParallelism(1))
        terminal.connect(SimulatedTower(line, SimulatedBrick(firmware), kind, faults, speed = 20), scope)
    }

    private suspend fun open(device: TowerDevice) = assertIs<OpenedTower.Success>(ports.open(device)).port

    @Test
    fun `a program gets through a serial port`() = runBlocking {
        connect(TowerKind.SERIAL)
        val tower = RcxTower(open(ports.named(terminal.path)))
        assertEquals(TransferResult.Success(602, repeats = 0), tower.sendProgram(image))
        assertContentEquals(image, lejos.program)
        tower.close()
    }

    @Test
    fun `a program gets through a serial port that loses bytes`() = runBlocking {
        connect(TowerKind.SERIAL, LineFaults(seed = 5, loss = 0.004))
        val tower = RcxTower(open(ports.named(terminal.path)))
        assertIs<TransferResult.Success>(tower.sendProgram(image))
        assertContentEquals(image, lejos.program)
        tower.close()
    }

    @Test
    fun `a program gets through the device file of the USB tower`() = runBlocking {
        connect(TowerKind.USB)
        val file = devices.resolve("usb").createDirectory().resolve("legousbtower0")
        file.createSymbolicLinkPointingTo(Path.of(terminal.path))
        val device = ports.available().first()
        assertEquals(TowerDevice("$file", "legousbtower0", TowerKind.USB), device)
        val tower = RcxTower(open(device))
        assertEquals(TransferResult.Success(602, repeats = 0), tower.sendProgram(image))
        assertContentEquals(image, lejos.program)
        tower.close()
    }

    @Test
    fun `a program for LEGO's firmware gets through, runs on the virtual brick, and its datalog comes back`() =
        runBlocking {
            val lego = SimulatedLegoFirmware()
            connect(TowerKind.SERIAL, LineFaults(seed = 7, loss = 0.004), lego)
            val tower = RcxTower(open(ports.named(terminal.path)))
            val code = CodeBytes.of(0x14, 0, 2, 42, 0, 0x21, 0x81)
            val image = RcxImage(FirmwareTarget.RCX2, listOf(Chunk(ChunkId.MAIN, code)))
            assertIs<TransferResult.Success>(tower.sendLegoProgram(5, image))
            assertEquals(image.chunks, lego.programIn(slot = 5).image.chunks)
            val state = brickAfter(lego.programIn(slot = 5), milliseconds = 50).firmwareState
            assertEquals(42, assertIs<FirmwareState>(state).variables.first())
            lego.datalog = List(70) { 0x40 to it }
            val entries = List(70) { DatalogEntry(0x40, it) }
            assertEquals(TowerResult.Success(entries), tower.readLegoDatalog())
            tower.close()
        }

    @Test
    fun `a tower that is unplugged receives nothing any more`() = runBlocking {
        val serial = open(ports.named(terminal.path))
        val file = devices.resolve("legousbtower0").createSymbolicLinkPointingTo(Path.of(terminal.path))
        val usb = open(ports.named("legousbtower0"))
        file.deleteExisting()
        terminal.close()
        assertNull(serial.receive())
        assertNull(usb.receive())
        serial.close()
        usb.close()
    }

    @Test
    fun `a port that was closed takes and gives nothing any more`() = runBlocking {
        val port = open(ports.named(terminal.path))
        port.close()
        port.close()
        assertNull(port.receive())
        assertEquals(false, port.send(byteArrayOf(1)))
    }

    @Test
    fun `a port that does not exist is gone`() = runBlocking {
        for (name in listOf("/dev/no-such-port", "$devices/legousbtower7")) {
            assertEquals(OpenedTower.Failure(OpenFailure.GONE), ports.open(ports.named(name)), name)
        }
    }

    @Test
    fun `ports are named in full or by their last part`() {
        assertEquals(TowerDevice("$devices/ttyUSB0", "ttyUSB0", TowerKind.SERIAL), ports.named("ttyUSB0"))
        assertEquals(TowerKind.USB, ports.named("/dev/usb/legousbtower1").kind)
    }
}
