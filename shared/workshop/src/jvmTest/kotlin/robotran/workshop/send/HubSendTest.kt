package robotran.workshop.send

import kotlinx.coroutines.ExperimentalCoroutinesApi
import robotran.brick.kind.BrickKind
import robotran.hublink.HubError
import robotran.hublink.HubVersion
import robotran.hublink.Remains
import robotran.hublink.UnseenCause
import robotran.hublink.connection.ChosenHub
import robotran.hublink.connection.HubTransport
import robotran.hublink.output.ProgramErrorKind
import robotran.hublink.simulated.SimulatedModel
import robotran.hublink.simulated.WireFaults
import robotran.mpycompiler.MpyCompiler
import robotran.mpycompiler.MpyResult
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.HubSendEvent
import robotran.workshop.event.SendEvent
import robotran.workshop.openWorkshop
import robotran.workshop.state.HubSendStep
import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

/** From the text of a program to a simulated hub, with everything between. */
@OptIn(ExperimentalCoroutinesApi::class)
internal class HubSendTest : HubSendBench() {
    @Test
    fun `a program gets from the app into a hub, starts there, prints and ends`() = onHub { workshop ->
        workshop.handle(SendEvent.Requested)
        assertEquals(HubSendStep.Choosing(listOf(MY_HUB), listOf(HubTransport.BLUETOOTH)), end(workshop))
        workshop.handle(HubSendEvent.HubChosen(MY_HUB))
        assertEquals(HubSendStep.Found, end(workshop))
        val found = assertNotNull(workshop.state.hubSend?.hub)
        assertEquals(listOf("Pybricks Hub", "SPIKE Prime", "4.0.1"), listOf(found.name, found.model, found.firmware))
        workshop.handle(HubSendEvent.Confirmed)
        val ready = assertIs<HubSendStep.Ready>(end(workshop))
        assertEquals(hub.slot?.size, ready.bytes)
        assertContentEquals("__main__".encodeToByteArray(), hub.slot?.copyOfRange(4, 12))
        workshop.handle(HubSendEvent.Started)
        assertEquals(listOf("hello"), assertIs<HubSendStep.Ended>(end(workshop)).console.lines)
    }

    @Test
    fun `the hub that was used last is taken without asking, as long as the app is open`() = onHub { workshop ->
        sendFirst(workshop)
        workshop.handle(HubSendEvent.Cancelled)
        end(workshop)
        ports.devices = listOf(MY_HUB, OTHER_HUB)
        hub.slot = null
        workshop.handle(SendEvent.Requested)
        assertIs<HubSendStep.Ready>(end(workshop))
        assertEquals(listOf(MY_HUB, MY_HUB), ports.opened)
    }

    @Test
    fun `the only hub at a cable is taken without asking`() = onHub { workshop ->
        val cable = MY_HUB.copy(transport = HubTransport.USB_SERIAL)
        ports.devices = listOf(cable)
        workshop.handle(SendEvent.Requested)
        assertEquals(HubSendStep.Found, end(workshop))
        assertEquals(listOf(cable), ports.opened)
    }

    @Test
    fun `another hub than that of the robot is told before anything is sent`() =
        onHub(SimulatedModel(pnpKind = 0x80)) { workshop ->
            workshop.handle(SendEvent.Requested)
            end(workshop)
            workshop.handle(HubSendEvent.HubChosen(MY_HUB))
            assertEquals(HubSendStep.Found, end(workshop))
            assertEquals("SPIKE Prime", workshop.state.hubSend?.hub?.expected)
            assertNull(hub.slot)
        }

    @Test
    fun `a program that runs prints until it is stopped`() = onHub(program = ENDLESS) { workshop ->
        sendFirst(workshop)
        workshop.handle(HubSendEvent.Started)
        assertEquals(listOf("on"), assertIs<HubSendStep.Running>(end(workshop)).console.lines)
        workshop.handle(HubSendEvent.Stopped)
        assertTrue(assertIs<HubSendStep.Ended>(end(workshop)).console.wasStopped)
    }

    @Test
    fun `somebody may start the program at the hub as often as he likes`() = onHub { workshop ->
        sendFirst(workshop)
        repeat(2) {
            hub.pressButton()
            assertEquals(listOf("hello"), assertIs<HubSendStep.Ended>(end(workshop)).console.lines)
        }
    }

    @Test
    fun `a motor that is not on its port is told at the line of the program that needs it`() = onHub(
        program = { it.print(traceback("Motor(Port.C")) },
    ) { workshop ->
        sendFirst(workshop)
        workshop.handle(HubSendEvent.Started)
        val error = assertNotNull(assertIs<HubSendStep.Ended>(end(workshop)).console.error)
        assertEquals(ProgramErrorKind.MISSING_DEVICE to "C", error.kind to error.port)
        assertEquals(2, error.line)
        workshop.handle(HubSendEvent.LineShown)
        assertNull(workshop.state.hubSend)
    }

    @Test
    fun `a hub that is lost in the middle of a transfer is told, and gets the program with the next try`() =
        onHub { workshop ->
            ports.faults = WireFaults(messagesUntilDisconnect = 2)
            connectFirst(workshop)
            workshop.handle(HubSendEvent.Confirmed)
            assertEquals(HubSendStep.Failed(HubError.BrokenOff, Remains.NO_PROGRAM), end(workshop))
            ports.faults = WireFaults()
            workshop.handle(HubSendEvent.Retried)
            assertIs<HubSendStep.Ready>(end(workshop))
        }

    @Test
    fun `a cable that is pulled out after the transfer is no mistake`() = onHub { workshop ->
        sendFirst(workshop)
        ports.connection?.disconnect()
        assertTrue(assertIs<HubSendStep.Ready>(end(workshop)).isGone)
    }

    @Test
    fun `a hub that is lost while its program runs is told so`() = onHub(program = ENDLESS) { workshop ->
        sendFirst(workshop)
        workshop.handle(HubSendEvent.Started)
        end(workshop)
        ports.connection?.disconnect()
        assertTrue(assertIs<HubSendStep.Ended>(end(workshop)).isGone)
    }

    @Test
    fun `a cancelled transfer leaves no program that could start`() = onHub(SMALL_MESSAGES) { workshop ->
        connectFirst(workshop)
        workshop.handle(HubSendEvent.Confirmed)
        while ((workshop.state.hubSend?.step as? HubSendStep.Sending)?.progress?.confirmedBytes?.let { it > 40 } !=
            true
        ) {
            testScheduler.advanceTimeBy(1)
        }
        workshop.handle(HubSendEvent.Cancelled)
        assertEquals(HubSendStep.Cancelled, end(workshop))
        testScheduler.advanceTimeBy(5_000)
        assertNull(hub.slot)
        workshop.handle(HubSendEvent.Retried)
        assertIs<HubSendStep.Ready>(end(workshop))
    }

    @Test
    fun `closing the sheet releases the hub`() = onHub { workshop ->
        sendFirst(workshop)
        assertTrue(hub.isSubscribed)
        workshop.handle(HubSendEvent.Cancelled)
        end(workshop)
        assertTrue(!hub.isSubscribed)
    }

    @Test
    fun `a hub that hides because its program runs is told with the causes`() = onHub { workshop ->
        val notSeen = HubError.NotSeen(listOf(UnseenCause.PROGRAM_RUNS, UnseenCause.OFF))
        ports.failure = notSeen
        connectFirst(workshop)
        assertEquals(HubSendStep.Failed(notSeen), workshop.state.hubSend?.step)
        ports.chosen = ChosenHub.None
        ports.devices = emptyList()
        workshop.handle(HubSendEvent.TransportRequested(HubTransport.BLUETOOTH))
        val choosing = HubSendStep.Choosing(emptyList(), listOf(HubTransport.BLUETOOTH), isMissing = true)
        assertEquals(choosing, end(workshop))
    }

    @Test
    fun `a program that is too large for the hub is told with both sizes, and the hub keeps its own`() =
        onHub(SimulatedModel(programBytes = 200)) { workshop ->
            hub.slot = byteArrayOf(1)
            connectFirst(workshop)
            workshop.handle(HubSendEvent.Confirmed)
            val failed = assertIs<HubSendStep.Failed>(end(workshop))
            assertEquals(200, assertIs<HubError.TooLarge>(failed.error).maxBytes)
            assertContentEquals(byteArrayOf(1), hub.slot)
        }

    @Test
    fun `a hub with an old firmware is told which one it has`() =
        onHub(SimulatedModel(profile = HubVersion(1, 1), firmware = "3.1.0")) { workshop ->
            connectFirst(workshop)
            assertEquals(HubSendStep.Failed(HubError.TooOld(HubVersion(3, 1))), workshop.state.hubSend?.step)
            assertTrue(!hub.isSubscribed)
        }

    @Test
    fun `LEGO's firmware is told`() = onHub { workshop ->
        ports.failure = HubError.LegoFirmware
        connectFirst(workshop)
        assertEquals(HubSendStep.Failed(HubError.LegoFirmware), workshop.state.hubSend?.step)
    }

    @Test
    fun `a program with a number beyond 31 bits goes to no hub`() = onHub(
        compiler = object : MpyCompiler {
            override suspend fun compile(fileName: String, source: String) =
                CompilerInTest.compile(fileName, "print(1073741824)\n")
        },
    ) { workshop ->
        workshop.handle(SendEvent.Requested)
        assertEquals(HubSendStep.Failed(HubError.NumberTooLarge("1073741824")), end(workshop))
        assertEquals(emptyList(), ports.opened)
    }

    @Test
    fun `a mistake is told instead of anything that would be sent`() = onHub(text = "forwrd 5\n") { workshop ->
        workshop.handle(SendEvent.Requested)
        assertEquals(1, assertIs<HubSendStep.HasErrors>(end(workshop)).first.range?.line)
        workshop.handle(HubSendEvent.LineShown)
        assertNull(workshop.state.hubSend)
    }

    @Test
    fun `where no hub can be reached the program is saved as Python`() = onHub(transports = emptySet()) { workshop ->
        workshop.handle(SendEvent.Requested)
        assertEquals(HubSendStep.NoWay(), end(workshop))
        files.location = "/home/ada/drive.py"
        workshop.handle(HubSendEvent.PythonSaved)
        assertEquals(HubSendStep.NoWay(savedAs = "drive.py"), end(workshop))
        assertTrue("from pybricks" in files.disk.getValue("/home/ada/drive.py").decodeToString())
    }

    @Test
    fun `what is saved for a real robot with a hub is Python`() = onHub { workshop ->
        files.location = "/home/ada/drive.py"
        workshop.handle(DocumentEvent.KitRequested)
        end(workshop)
        assertEquals("drive.py", files.suggestion)
        assertTrue("from pybricks" in files.disk.getValue("/home/ada/drive.py").decodeToString())
    }

    @Test
    fun `the hub that was used last is the first one, also when the app is started again`() = onHub { workshop ->
        sendFirst(workshop)
        workshop.close()
        end(workshop)
        ports.devices = listOf(OTHER_HUB, MY_HUB)
        val again = openWorkshop(platform = platform, scope = backgroundScope)
        again.handle(DocumentEvent.NewWithBrick(BrickKind.SPIKE_PRIME))
        end(again)
        again.handle(SendEvent.Requested)
        val shown = assertIs<HubSendStep.Choosing>(end(again))
        assertEquals(listOf(MY_HUB, OTHER_HUB) to MY_HUB, shown.devices to shown.last)
        again.close()
        ports.devices = listOf(OTHER_HUB, MY_HUB.copy(id = "another"))
        assertEquals("another", HubMemory(platform.store).lastOf(ports.devices)?.id)
        assertNull(
            HubMemory(platform.store).lastOf(listOf(MY_HUB.copy(transport = HubTransport.USB_SERIAL), OTHER_HUB)),
        )
    }

    @Test
    fun `who does not let the app look for hubs is told what to do`() = onHub { workshop ->
        ports.chosen = ChosenHub.Refused(HubError.BluetoothNotAllowed)
        workshop.handle(SendEvent.Requested)
        end(workshop)
        workshop.handle(HubSendEvent.TransportRequested(HubTransport.BLUETOOTH))
        assertEquals(HubSendStep.Failed(HubError.BluetoothNotAllowed), end(workshop))
    }

    @Test
    fun `a compiler that cannot be fetched is told, and fetched again`() {
        var isThere = false
        val compiler = object : MpyCompiler {
            override suspend fun compile(fileName: String, source: String): MpyResult =
                if (isThere) CompilerInTest.compile(fileName, source) else MpyResult.NotLoaded
        }
        onHub(compiler = compiler) { workshop ->
            workshop.handle(SendEvent.Requested)
            assertEquals(HubSendStep.NoCompiler, end(workshop))
            isThere = true
            workshop.handle(HubSendEvent.Retried)
            assertIs<HubSendStep.Choosing>(end(workshop))
        }
    }

    /** What a hub prints if no motor is at the place that the line with [words] creates. */
    private fun traceback(words: String): String {
        val line = CompilerInTest.lastSource.lines().indexOfFirst { words in it } + 1
        return "Traceback (most recent call last):\r\n  File \"drive.py\", line $line, in <module>\r\n" +
            "OSError: [Errno 19] ENODEV: \r\n"
    }
}
