package robotran.hublink.hub

import kotlinx.coroutines.awaitCancellation
import kotlinx.coroutines.delay
import kotlinx.coroutines.launch
import kotlinx.coroutines.test.runTest
import robotran.hublink.DownloadProgress
import robotran.hublink.DownloadResult
import robotran.hublink.HubError
import robotran.hublink.HubKind
import robotran.hublink.HubResult
import robotran.hublink.HubVersion
import robotran.hublink.Remains
import robotran.hublink.bytesOf
import robotran.hublink.connection.HubTransport
import robotran.hublink.hexOf
import robotran.hublink.mpyOf
import robotran.hublink.output.OutputReader
import robotran.hublink.output.SourceMap
import robotran.hublink.program.HubProgram
import robotran.hublink.simulated.SimulatedBluetooth
import robotran.hublink.simulated.SimulatedModel
import robotran.hublink.simulated.SimulatedProgram
import robotran.hublink.simulated.WireFaults
import robotran.hublink.vectorLines
import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNull
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

class HubLinkTest {
    private val endless = SimulatedProgram { awaitCancellation() }

    @Test
    fun `a hub tells what it is on every transport`() = runTest {
        for (transport in HubTransport.entries) {
            val hub = TestHub(this, transport).open()
            assertEquals("Pybricks Hub", hub.name, "$transport")
            assertEquals(
                if (transport ==
                    HubTransport.USB_PACKETS
                ) {
                    HubKind.EV3
                } else {
                    HubKind.SPIKE_PRIME
                },
                hub.kind,
                "$transport",
            )
            assertTrue(hub.firmware >= HubVersion(4, 0), "$transport")
            assertEquals(52_300, hub.programRoom, "$transport")
        }
    }

    @Test
    fun `a program is sent and started and heard on every transport`() = runTest {
        for (transport in HubTransport.entries) {
            val test = TestHub(this, transport)
            test.open()
            val reports = mutableListOf<DownloadProgress>()
            assertEquals(
                DownloadResult.Success(365, attempts = 1),
                test.link.send(square) {
                    reports += it
                },
                "$transport",
            )
            assertContentEquals(square.bytes, test.hub.slot, "$transport")
            assertEquals(0, reports.first().confirmedBytes)
            assertEquals(DownloadProgress(365, 365, 1), reports.last())
            assertEquals(HubResult.Success(Unit), test.link.start(), "$transport")
            delay(1.seconds)
            assertEquals(listOf("hello"), test.link.state.value.console.lines, "$transport")
        }
    }

    @Test
    fun `every profile from 1_2 on is spoken`() = runTest {
        for (minor in 2..7) {
            val model = SimulatedModel(profile = HubVersion(1, minor), slots = if (minor < 4) 0 else 5)
            val test = TestHub(this, HubTransport.BLUETOOTH, model, program = endless)
            assertEquals(minor == 7, test.open().isNewerThanKnown)
            assertIs<DownloadResult.Success>(test.link.send(square), "1.$minor")
            assertEquals(HubResult.Success(Unit), test.link.start(), "1.$minor")
            delay(1.seconds)
            assertTrue(test.link.state.value.isProgramRunning, "1.$minor")
            assertEquals(HubResult.Success(Unit), test.link.stop(), "1.$minor")
            assertTrue(!test.hub.isProgramRunning, "1.$minor")
        }
    }

    @Test
    fun `what goes over Bluetooth is what the editor of Pybricks sends`() = runTest {
        for (line in vectorLines("downloads.txt")) {
            val test = TestHub(this, model = SimulatedModel(messageBytes = line[0].toInt()))
            test.open()
            val container = bytesOf(line[1])
            assertIs<DownloadResult.Success>(test.link.send(requireNotNull(HubProgram.read(container))))
            test.link.start()
            val sent = (test.connection as SimulatedBluetooth).commands.map(::hexOf)
            assertEquals(line.drop(2), sent, "${container.size} bytes, ${line[0]} at a time")
        }
    }

    @Test
    fun `a program that runs is stopped before another one is sent`() = runTest {
        for (transport in HubTransport.entries) {
            val test = TestHub(this, transport, program = endless)
            test.open()
            test.link.send(square)
            test.link.start()
            delay(1.seconds)
            assertTrue(test.hub.isProgramRunning)
            assertIs<DownloadResult.Success>(test.link.send(HubProgram(mpyOf("hello.py"))), "$transport")
            assertTrue(!test.hub.isProgramRunning)
            assertContentEquals(HubProgram(mpyOf("hello.py")).bytes, test.hub.slot)
        }
    }

    @Test
    fun `a program that catches everything is told not to stop and the old one stays`() = runTest {
        val stubborn = SimulatedProgram { host ->
            host.catchEverything("caught\r\n")
            awaitCancellation()
        }
        val test = TestHub(this, program = stubborn)
        test.open()
        test.link.send(square)
        test.link.start()
        delay(1.seconds)
        assertEquals(HubResult.Failure(HubError.DoesNotStop), test.link.stop())
        val result = test.link.send(HubProgram(mpyOf("hello.py")))
        assertEquals(DownloadResult.Failure(HubError.DoesNotStop, Remains.AS_BEFORE), result)
        assertContentEquals(square.bytes, test.hub.slot)
    }

    @Test
    fun `the button that starts the old program in the middle does not harm`() = runTest {
        val test = TestHub(this, program = endless, faults = WireFaults(longestDelay = 60.milliseconds))
        test.open()
        test.link.send(square)
        test.hub.pressButton()
        assertIs<DownloadResult.Success>(test.link.send(HubProgram(mpyOf("hello.py"))))
        assertContentEquals(HubProgram(mpyOf("hello.py")).bytes, test.hub.slot)
    }

    @Test
    fun `a download that somebody else has begun is waited for`() = runTest {
        val test = TestHub(this)
        test.open()
        test.hub.command(bytesOf("0300000000"))
        assertEquals(DownloadResult.Success(365, attempts = 2), test.link.send(square))
        assertContentEquals(square.bytes, test.hub.slot)
    }

    @Test
    fun `a browser that hides the reason is no hindrance`() = runTest {
        val test = TestHub(this, program = endless, faults = WireFaults(hidesReasons = true))
        test.open()
        test.hub.command(bytesOf("0300000000"))
        assertEquals(DownloadResult.Success(365, attempts = 2), test.link.send(square))
        assertEquals(HubResult.Success(Unit), test.link.start())
    }

    @Test
    fun `what a hub cannot take is not sent`() = runTest {
        val test = TestHub(this, model = SimulatedModel(programBytes = 300))
        test.open()
        test.hub.slot = byteArrayOf(1)
        assertEquals(DownloadResult.Failure(HubError.TooLarge(365, 300)), test.link.send(square))
        val long = test.link.send(HubProgram(mpyOf("numbers.py")))
        assertEquals(DownloadResult.Failure(HubError.NumberTooLarge("1073741824")), long)
        assertEquals(DownloadResult.Failure(HubError.NotAProgram), test.link.send(HubProgram(byteArrayOf(1))))
        assertContentEquals(byteArrayOf(1), test.hub.slot)
    }

    @Test
    fun `old firmware and LEGO's own are told`() = runTest {
        val old = TestHub(this, model = SimulatedModel(profile = HubVersion(1, 1), firmware = "3.1.0"))
        assertEquals(HubResult.Failure(HubError.TooOld(HubVersion(3, 1))), old.link.open())
        val withoutModules = TestHub(this, model = SimulatedModel(flags = 1))
        assertEquals(HubResult.Failure(HubError.TooOld(HubVersion(4, 0, 1))), withoutModules.link.open())
        val lego = TestHub(this, HubTransport.USB_SERIAL, faults = WireFaults(losses = 1.0))
        assertEquals(HubResult.Failure(HubError.LegoFirmware), lego.link.open())
    }

    @Test
    fun `a hub without a program says so`() = runTest {
        val test = TestHub(this)
        test.open()
        assertEquals(HubResult.Failure(HubError.NoProgram), test.link.start())
    }

    @Test
    fun `a second start is refused while the program runs`() = runTest {
        val test = TestHub(this, program = endless)
        test.open()
        test.link.send(square)
        test.link.start()
        delay(1.seconds)
        assertEquals(HubResult.Failure(HubError.Busy), test.link.start())
    }

    @Test
    fun `an error comes back with the pupil's line`() = runTest {
        val failing = SimulatedProgram { host ->
            host.print("grüße\r\n${OutputReader.MARK}2\r\n")
            delay(1.seconds)
            host.print(
                "Traceback (most recent call last):\r\n  File \"p.py\", line 2, in <module>\r\nIndexError: x\r\n",
            )
        }
        for (transport in HubTransport.entries) {
            val test = TestHub(this, transport, program = failing)
            test.open()
            test.link.send(square)
            test.link.start(SourceMap("p.py", listOf("a", "b"), mapOf(2 to 9)))
            delay(500.milliseconds)
            assertEquals(9, test.link.state.value.console.runningLine, "$transport")
            delay(1.seconds)
            assertEquals(9, test.link.state.value.console.error?.line, "$transport")
            assertEquals("grüße", test.link.state.value.console.lines.first(), "$transport")
            assertTrue(!test.link.state.value.isProgramRunning, "$transport")
        }
    }

    @Test
    fun `a lost connection is told at once and everything after says so`() = runTest {
        for (transport in HubTransport.entries) {
            val test = TestHub(this, transport)
            test.open()
            test.disconnect()
            delay(100.milliseconds)
            assertTrue(test.link.state.value.isGone, "$transport")
            assertEquals(
                HubError.OutOfReach,
                assertIs<DownloadResult.Failure>(test.link.send(square)).error,
                "$transport",
            )
            assertEquals(HubResult.Failure(HubError.OutOfReach), test.link.start(), "$transport")
            assertEquals(HubResult.Failure(HubError.OutOfReach), test.link.stop(), "$transport")
            test.link.close()
        }
    }

    @Test
    fun `nothing can be sent before the hub is known`() = runTest {
        val test = TestHub(this)
        assertEquals(DownloadResult.Failure(HubError.OutOfReach), test.link.send(square))
        assertNull(test.hub.slot)
    }

    @Test
    fun `a download that was cancelled leaves nothing and the next one succeeds`() = runTest {
        for (transport in HubTransport.entries) {
            val test = TestHub(this, transport)
            test.open()
            val sending = launch { test.link.send(square) }
            delay(70.milliseconds)
            sending.cancel()
            sending.join()
            assertTrue(!test.link.state.value.isSending)
            assertIs<DownloadResult.Success>(test.link.send(square), "$transport")
            assertContentEquals(square.bytes, test.hub.slot, "$transport")
        }
    }
}
