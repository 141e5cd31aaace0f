package robotran.desktoptower.hub

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.async
import kotlinx.coroutines.awaitCancellation
import kotlinx.coroutines.cancel
import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.first
import kotlinx.coroutines.runBlocking
import kotlinx.coroutines.withTimeout
import org.junit.jupiter.api.condition.EnabledOnOs
import org.junit.jupiter.api.condition.OS
import robotran.desktoptower.PseudoTerminal
import robotran.hublink.DownloadResult
import robotran.hublink.HubDescription
import robotran.hublink.HubError
import robotran.hublink.HubKind
import robotran.hublink.HubResult
import robotran.hublink.HubVersion
import robotran.hublink.connection.HubTransport
import robotran.hublink.connection.OpenedHub
import robotran.hublink.hub.HubLink
import robotran.hublink.program.HubProgram
import robotran.hublink.simulated.SimulatedHub
import robotran.hublink.simulated.SimulatedModel
import robotran.hublink.simulated.SimulatedProgram
import robotran.hublink.simulated.SimulatedSerialPort
import robotran.hublink.simulated.WireFaults
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

/** Talks to a simulated hub through a pseudo-terminal, which takes the place of its serial port. */
@EnabledOnOs(OS.LINUX)
class DesktopHubPortsTest {
    private val scope = CoroutineScope(Dispatchers.Default)
    private val terminal = PseudoTerminal()
    private val ports = DesktopHubPorts()

    // print("hello"), compiled as hello.py
    private val hello = "4d06001f04001068656c6c6f2e7079000f0a68656c6c6f00817760080201110310023401595163"
        .chunked(2).map { it.toInt(16).toByte() }.toByteArray()

    @AfterTest
    fun tidyUp() = scope.cancel()

    private fun hubAtTerminal(program: SimulatedProgram): SimulatedHub {
        // One thread, as the simulation has no locks.
        val line = CoroutineScope(scope.coroutineContext + Dispatchers.Default.limitedParallelism(1))
        val hub = SimulatedHub(line, SimulatedModel(profile = HubVersion(1, 6), messageBytes = 60)) { program }
        val port = SimulatedSerialPort(line, hub, WireFaults(longestDelay = 2.milliseconds))
        terminal.connect(scope, port::send, port::receive)
        return hub
    }

    private suspend fun link() =
        HubLink(assertIs<OpenedHub.Success>(ports.open(ports.named(terminal.path))).connection, scope)

    @Test
    fun `a program gets through a serial port, starts, is heard and stops`() = runBlocking {
        val hub = hubAtTerminal { host ->
            host.print("hello\r\n")
            awaitCancellation()
        }
        val link = link()
        assertEquals(HubKind.SPIKE_PRIME, assertIs<HubResult.Success<HubDescription>>(link.open()).value.kind)
        val program = HubProgram(hello)
        assertEquals(DownloadResult.Success(program.bytes.size, attempts = 1), link.send(program))
        assertContentEquals(program.bytes, hub.slot)
        assertEquals(HubResult.Success(Unit), link.start())
        withTimeout(5.seconds) { link.state.first { "hello" in it.console.lines } }
        assertEquals(HubResult.Success(Unit), link.stop())
        link.close()
    }

    @Test
    fun `a port where nobody answers has no Pybricks`() = runBlocking {
        val link = link()
        assertEquals(HubResult.Failure(HubError.LegoFirmware), link.open())
        link.close()
    }

    @Test
    fun `a hub that is unplugged is gone`() = runBlocking {
        val link = link()
        val opened = async { link.open() }
        delay(200.milliseconds)
        terminal.close()
        withTimeout(5.seconds) { link.state.first { it.isGone } }
        assertEquals(HubResult.Failure(HubError.OutOfReach), opened.await())
        assertEquals(HubResult.Failure(HubError.OutOfReach), link.start())
    }

    @Test
    fun `a port that does not exist is out of reach`() = runBlocking {
        assertEquals(OpenedHub.Failure(HubError.OutOfReach), ports.open(ports.named("no-such-port")))
        assertEquals("/dev/ttyACM0", ports.named("ttyACM0").id)
        assertEquals(HubTransport.USB_SERIAL, ports.named("ttyACM0").transport)
    }
}
