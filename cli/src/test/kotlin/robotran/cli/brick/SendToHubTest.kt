package robotran.cli.brick

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.cancel
import robotran.cli.CommandLine
import robotran.cli.CommandTest
import robotran.cli.TestDesktop
import robotran.hublink.HubError
import robotran.hublink.connection.ChosenHub
import robotran.hublink.connection.HubDevice
import robotran.hublink.connection.HubPorts
import robotran.hublink.connection.HubTransport
import robotran.hublink.connection.OpenedHub
import robotran.hublink.program.HubProgram
import robotran.hublink.simulated.SimulatedBluetooth
import robotran.hublink.simulated.SimulatedHub
import robotran.hublink.simulated.SimulatedModel
import kotlin.io.path.createTempFile
import kotlin.io.path.deleteIfExists
import kotlin.io.path.writeBytes
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertNull

class SendToHubTest : CommandTest() {
    private val scope = CoroutineScope(Dispatchers.Default.limitedParallelism(1))
    private val file = createTempFile("program", ".mpy")

    // print("hello"), compiled as hello.py
    private val hello = "4d06001f04001068656c6c6f2e7079000f0a68656c6c6f00817760080201110310023401595163"
        .chunked(2).map { it.toInt(16).toByte() }.toByteArray()

    @AfterTest
    fun endHub() {
        scope.cancel()
        file.deleteIfExists()
    }

    private fun send(opened: OpenedHub?, bytes: ByteArray, vararg arguments: String): Int {
        file.writeBytes(bytes)
        val ports = TestHubs(opened)
        val line = CommandLine(console, TestDesktop(), hubs = { Hubs(ports, ports::named) })
        return line.execute(listOf("send", "$file") + arguments)
    }

    private fun hub(model: SimulatedModel = SimulatedModel()) = SimulatedHub(scope, model)

    private fun reached(hub: SimulatedHub) = OpenedHub.Success(SimulatedBluetooth(hub))

    @Test
    fun `a module gets onto the hub as a program`() {
        val hub = hub()
        assertEquals(0, send(reached(hub), hello), console.complaints.joinToString("\n"))
        assertContentEquals(HubProgram(hello).bytes, hub.slot)
        assertEquals("The hub has the program, 52 bytes. Press its button.", console.said.single())
        assertEquals("At COM9: SPIKE Prime with Pybricks 4.0.1\n", console.mentions.first())
        assertEquals("52 of 52 bytes\n", console.mentions.last())
    }

    @Test
    fun `a program in Robolang is compiled and gets onto the hub`() {
        val hub = hub()
        val ports = TestHubs(reached(hub))
        val line = CommandLine(console, TestDesktop(), hubs = { Hubs(ports, ports::named) })
        assertEquals(0, line.execute(listOf("send", square, "--brick", "spike-prime")), "${console.complaints}")
        assertContains(console.said.single(), Regex("The hub has the program, \\d+ bytes"))
        assertEquals(null, HubProgram.read(assertNotNull(hub.slot))?.mistake())
    }

    @Test
    fun `a hub chooses the slot itself`() {
        assertEquals(2, send(null, hello, "--slot", "2"))
        assertContains(console.complaints.single(), "leave --slot out")
    }

    @Test
    fun `a packed program gets onto the hub as it is`() {
        val hub = hub()
        assertEquals(0, send(reached(hub), HubProgram(hello).bytes, "--port", "COM3"))
        assertContentEquals(HubProgram(hello).bytes, hub.slot)
    }

    @Test
    fun `a hub that has no room is told with both sizes and with what it has`() {
        val hub = hub(SimulatedModel(programBytes = 50))
        assertEquals(4, send(reached(hub), hello))
        assertContains(console.complaints.first(), "it has 52 bytes, and the hub has room for 50")
        assertEquals("The hub still has its old program.", console.complaints.last())
        assertNull(hub.slot)
    }

    @Test
    fun `no hub and one that is taken are told with what to do`() {
        assertEquals(4, send(null, hello))
        assertContains(console.complaints.single(), "No hub with Pybricks 4.1 or newer is plugged in.")
        console.complaints.clear()
        assertEquals(4, send(OpenedHub.Failure(HubError.Taken), hello))
        assertContains(console.complaints.single(), "Another app, tab or tablet uses the hub.")
    }

    @Test
    fun `what is no program for a hub is not sent`() {
        val hub = hub()
        assertEquals(2, send(reached(hub), "print(1)".encodeToByteArray()))
        assertContains(console.complaints.single(), "is not a compiled program for a hub")
        console.complaints.clear()
        assertEquals(2, send(reached(hub), hello, "$file"))
        assertContains(console.complaints.single(), "one program at a time")
        assertNull(hub.slot)
    }

    private class TestHubs(private val opened: OpenedHub?) : HubPorts {
        override val transports = setOf(HubTransport.USB_SERIAL)

        override suspend fun available() = if (opened == null) emptyList() else listOf(named("COM9"))

        override suspend fun choose(transport: HubTransport) = ChosenHub.of(available().firstOrNull())

        override suspend fun open(device: HubDevice) = opened ?: OpenedHub.Failure(HubError.OutOfReach)

        fun named(name: String) = HubDevice(name, name, HubTransport.USB_SERIAL)
    }
}
