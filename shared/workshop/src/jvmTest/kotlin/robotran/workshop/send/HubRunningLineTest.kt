package robotran.workshop.send

import kotlinx.coroutines.awaitCancellation
import robotran.hublink.output.OutputReader
import robotran.hublink.simulated.SimulatedModel
import robotran.hublink.simulated.SimulatedProgram
import robotran.workshop.event.HubSendEvent
import robotran.workshop.event.SendEvent
import robotran.workshop.state.HubSendStep
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertTrue

/** Which line of the program runs, as a real hub tells it. */
internal class HubRunningLineTest : HubSendBench() {
    @Test
    fun `the line that runs on the hub is lit in the program`() = onHub(
        program = SimulatedProgram {
            it.print("${OutputReader.MARK}${lineOfMark("pen_down()")}\r\n")
            awaitCancellation()
        },
    ) { workshop ->
        sendFirst(workshop)
        workshop.handle(HubSendEvent.Started)
        assertEquals(2, assertIs<HubSendStep.Running>(end(workshop)).console.runningLine)
        assertEquals(2, workshop.state.shownProgramRun.runningLine)
        workshop.handle(HubSendEvent.Stopped)
        end(workshop)
        assertEquals(0, workshop.state.shownProgramRun.runningLine)
    }

    @Test
    fun `a program does not tell its lines if the pupil does not want it`() = onHub { workshop ->
        sendFirst(workshop)
        val telling = checkNotNull(hub.slot).size
        workshop.handle(HubSendEvent.LineSwitched(isOn = false))
        assertEquals(HubSendStep.Found, end(workshop))
        assertEquals(false, workshop.state.hubSend?.tellsLine)
        workshop.handle(HubSendEvent.Confirmed)
        assertTrue(assertIs<HubSendStep.Ready>(end(workshop)).bytes < telling)
        assertFalse("at_line(" in CompilerInTest.lastSource)
    }

    @Test
    fun `a program that has no room if it tells its lines does not`() {
        var room = 0
        onHub { workshop ->
            sendFirst(workshop)
            room = checkNotNull(hub.slot).size - 1
        }
        onHub(SimulatedModel(programBytes = room.toLong())) { workshop ->
            sendFirst(workshop)
            assertEquals(false, workshop.state.hubSend?.tellsLine)
            assertFalse("at_line(" in CompilerInTest.lastSource)
            workshop.handle(HubSendEvent.Cancelled)
            end(workshop)
            workshop.handle(SendEvent.Requested)
            assertEquals(true, workshop.state.hubSend?.tellsLine, "the next program may have room")
        }
    }

    /** The line of the Python that was sent which tells that [statement] runs, by what stands below it. */
    private fun lineOfMark(statement: String): Int {
        val lines = CompilerInTest.lastSource.lines()
        return lines.indices.single { lines[it].startsWith("at_line(") && lines[it + 1] == statement } + 1
    }
}
