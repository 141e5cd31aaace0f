package robotran.microbitlink.link

import kotlinx.coroutines.delay
import kotlinx.coroutines.launch
import kotlinx.coroutines.test.runTest
import robotran.microbitlink.BoardError
import robotran.microbitlink.MicrobitBoard
import robotran.microbitlink.Remains
import robotran.microbitlink.SendResult
import robotran.microbitlink.files.MAIN_FILE
import robotran.microbitlink.hex.HexMemory
import robotran.microbitlink.image.MicroPythonImage
import robotran.microbitlink.serial.PythonError
import robotran.microbitlink.simulated.CableFaults
import robotran.microbitlink.simulated.SimulatedBoard
import robotran.microbitlink.simulated.SimulatedDapPort
import robotran.microbitlink.value
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertNull
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.seconds

class ReplTest {
    @Test
    fun `a program alone is written over the serial line and started`() = runTest {
        for (type in MicrobitBoard.entries) {
            for (size in listOf(1, 64, 117, 3_000)) {
                val test = TestBoard(this, type, baudRate = if (type == MicrobitBoard.V1) 9_600 else 115_200)
                test.open()
                val program = programOf(size)
                assertEquals(SendResult.Success(attempts = 1), test.link.sendMain(program), "$type, $size bytes")
                assertContentEquals(program, test.board.python.files[MAIN_FILE])
                assertTrue(test.board.python.isRunning, "not started")
                val image = MicroPythonImage.of(test.board.memory)
                assertContentEquals(program, image?.files()?.value()?.get(MAIN_FILE))
            }
        }
    }

    @Test
    fun `other files of the board stay`() = runTest {
        val test = TestBoard(this)
        val image = checkNotNull(MicroPythonImage.of(test.board.memory))
        val files = mapOf("buggy.py" to programOf(300), MAIN_FILE to programOf(20))
        val board = SimulatedBoard(image.withFiles(files).value().memory)
        val link = MicrobitLink(SimulatedDapPort(backgroundScope, board))
        link.open()
        assertEquals(SendResult.Success(attempts = 1), link.sendMain(programOf(50)))
        assertEquals(setOf("buggy.py", MAIN_FILE), board.python.files.keys)
        assertContentEquals(programOf(300), board.python.files["buggy.py"])
    }

    @Test
    fun `a board without MicroPython or with a program that goes on says so and keeps what it has`() = runTest {
        val empty = SimulatedBoard(checkNotNull(HexMemory.of(emptyList())))
        val link = MicrobitLink(SimulatedDapPort(backgroundScope, empty))
        link.open()
        assertEquals(SendResult.Failure(BoardError.NoPython), link.sendMain(programOf(50)))
        val test = TestBoard(this)
        test.board.python.isInterruptible = false
        test.open()
        assertEquals(SendResult.Failure(BoardError.NoPython), test.link.sendMain(programOf(50)))
        assertEquals(TestBoard.OLD, test.board.python.main)
    }

    @Test
    fun `a program that has printed much does not disturb sending`() = runTest {
        val test = TestBoard(this)
        test.open()
        test.board.python.print("raw REPL; CTRL-B to exit\r\n> and more\r\n".repeat(20))
        assertEquals(SendResult.Success(attempts = 1), test.link.sendMain(programOf(200)))
        assertContentEquals(programOf(200), test.board.python.files[MAIN_FILE])
    }

    @Test
    fun `a program without room is told and half of it is never started`() = runTest {
        val test = TestBoard(this)
        test.open()
        val none = SendResult.Failure(BoardError.NoRoom, Remains.PART)
        assertEquals(none, test.link.sendMain(programOf(20_300)))
        assertTrue(!test.board.python.isRunning)
    }

    @Test
    fun `bytes that the board loses are noticed`() = runTest {
        var wrong = 0
        for (seed in 1..20) {
            val test = TestBoard(this, faults = CableFaults(Random(seed), serialLosses = 0.0005))
            test.open()
            val program = programOf(1_000)
            val result = test.link.sendMain(program)
            val held = test.board.python.files[MAIN_FILE]
            if (result is SendResult.Success) assertContentEquals(program, held, "seed $seed") else wrong++
        }
        assertTrue(wrong in 1..19, "$wrong of 20 wrong")
    }

    @Test
    fun `what the program prints is watched and an error leads to its line`() = runTest {
        val test = TestBoard(this, MicrobitBoard.V1, baudRate = 9_600)
        test.open()
        val watching = launch { test.link.watch() }
        delay(1.seconds)
        assertEquals(1, test.board.starts)
        test.board.python.print("Grüße\r\n12\r\nunfini")
        delay(1.seconds)
        assertEquals(listOf("Grüße", "12"), test.link.state.value.console.lines)
        assertEquals("unfini", test.link.state.value.console.unfinished)
        test.board.python.print(
            "shed\r\nTraceback (most recent call last):\r\n  File \"__main__\", line 12, in <module>\r\n" +
                "  File \"buggy.py\", line 3, in go\r\nZeroDivisionError: divide by zero\r\n>>> ",
        )
        delay(1.seconds)
        assertEquals(PythonError(12, "ZeroDivisionError: divide by zero"), test.link.state.value.console.error)
        assertTrue(test.link.state.value.console.hasEnded)
        assertEquals("", test.link.state.value.console.unfinished)
        test.board.python.print("MicroPython v1.18 on 2022-01-17; micro:bit v2.1.2 with nRF52833\r\n>>> again\r\n")
        delay(1.seconds)
        assertEquals("again", test.link.state.value.console.lines.last())
        assertNull(test.link.state.value.console.error, "a new run has not failed yet")
        assertTrue(!test.link.state.value.console.hasEnded)
        test.link.clearConsole()
        assertEquals(emptyList(), test.link.state.value.console.lines)
        assertNull(test.link.state.value.console.error)
        watching.cancel()
    }

    @Test
    fun `watching waits while a program is sent and ends when the board is unplugged`() = runTest {
        val test = TestBoard(this)
        test.open()
        var end: BoardError? = null
        val watching = launch { end = test.link.watch() }
        assertEquals(SendResult.Success(attempts = 1), test.link.sendMain(programOf(500)))
        test.board.python.print("after\r\n")
        delay(1.seconds)
        assertTrue("after" in test.link.state.value.console.lines, "${test.link.state.value.console}")
        test.port.unplug()
        watching.join()
        assertEquals(BoardError.OutOfReach, end)
    }
}
