package robotran.desktoptower

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.cancel
import kotlinx.coroutines.runBlocking
import org.junit.jupiter.api.condition.EnabledOnOs
import org.junit.jupiter.api.condition.OS
import robotran.tower.TransferResult
import robotran.tower.port.OpenFailure
import robotran.tower.port.OpenedTower
import robotran.tower.port.TowerDevice
import robotran.tower.port.TowerKind
import robotran.tower.rcx.RcxTower
import robotran.tower.simulated.LineFaults
import robotran.tower.simulated.SimulatedBrick
import robotran.tower.simulated.SimulatedLejos
import robotran.tower.simulated.SimulatedTower
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

    private fun connect(kind: TowerKind, faults: LineFaults = LineFaults()) {
        // One thread, as the simulation has no locks.
        val line = CoroutineScope(scope.coroutineContext + Dispatchers.Default.limitedParallelism(1))
        terminal.connect(SimulatedTower(line, SimulatedBrick(lejos), kind, faults, speed = 20), scope)
    }

    private suspend fun open(device: TowerDevice) = assertIs<OpenedTower.Open>(ports.open(device)).port

    @Test
    fun `a program gets through a serial port`() = runBlocking {
        connect(TowerKind.SERIAL)
        val tower = RcxTower(open(ports.named(terminal.path)))
        assertEquals(TransferResult.Complete(602, repeats = 0), tower.sendProgram(image))
        assertContentEquals(image, lejos.program)
        tower.close()
    }

    @Test
    fun `a program gets through a serial port that loses bytes`() = runBlocking {
        connect(TowerKind.SERIAL, LineFaults(seed = 5, loss = 0.004))
        val tower = RcxTower(open(ports.named(terminal.path)))
        assertIs<TransferResult.Complete>(tower.sendProgram(image))
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
        assertEquals(TransferResult.Complete(602, repeats = 0), tower.sendProgram(image))
        assertContentEquals(image, lejos.program)
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
            assertEquals(OpenedTower.Failed(OpenFailure.GONE), ports.open(ports.named(name)), name)
        }
    }

    @Test
    fun `ports are named in full or by their last part`() {
        assertEquals(TowerDevice("$devices/ttyUSB0", "ttyUSB0", TowerKind.SERIAL), ports.named("ttyUSB0"))
        assertEquals(TowerKind.USB, ports.named("/dev/usb/legousbtower1").kind)
    }
}
