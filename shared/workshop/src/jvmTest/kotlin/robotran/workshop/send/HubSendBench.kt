package robotran.workshop.send

import kotlinx.coroutines.ExperimentalCoroutinesApi
import kotlinx.coroutines.awaitCancellation
import kotlinx.coroutines.test.TestScope
import kotlinx.coroutines.test.runTest
import robotran.brick.kind.BrickKind
import robotran.hublink.connection.HubTransport
import robotran.hublink.simulated.SimulatedHub
import robotran.hublink.simulated.SimulatedModel
import robotran.hublink.simulated.SimulatedProgram
import robotran.mpycompiler.MpyCompiler
import robotran.programs.Program
import robotran.workshop.Workshop
import robotran.workshop.documents.MemoryFilePicker
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.HubSendEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.SendEvent
import robotran.workshop.openWorkshop
import robotran.workshop.platform.MemoryPlatform
import robotran.workshop.state.HubSendStep
import kotlin.test.assertIs

/** An app with a simulated hub near it. */
@OptIn(ExperimentalCoroutinesApi::class)
internal abstract class HubSendBench {
    protected val files = MemoryFilePicker()
    protected lateinit var platform: MemoryPlatform
    protected lateinit var hub: SimulatedHub
    protected lateinit var ports: NearHubs

    protected fun onHub(
        model: SimulatedModel = SimulatedModel(),
        program: SimulatedProgram = SimulatedProgram.printing("hello\r\n"),
        text: String = PROGRAM,
        transports: Set<HubTransport> = setOf(HubTransport.BLUETOOTH),
        compiler: MpyCompiler = CompilerInTest,
        check: suspend TestScope.(Workshop) -> Unit,
    ) = runTest {
        hub = SimulatedHub(backgroundScope, model) { program }
        ports = NearHubs(hub, transports = transports)
        platform = MemoryPlatform(files = files, hubs = ports, mpyCompiler = compiler)
        val workshop = openWorkshop(platform = platform, scope = backgroundScope)
        workshop.handle(DocumentEvent.NewWithBrick(BrickKind.SPIKE_PRIME))
        end(workshop)
        workshop.handle(ProgramEvent.ProgramAdded(Program.of("drive.robo", text)))
        check(workshop)
        workshop.close()
    }

    protected fun TestScope.connectFirst(workshop: Workshop) {
        workshop.handle(SendEvent.Requested)
        end(workshop)
        workshop.handle(HubSendEvent.HubChosen(MY_HUB))
        end(workshop)
    }

    protected fun TestScope.sendFirst(workshop: Workshop) {
        connectFirst(workshop)
        workshop.handle(HubSendEvent.Confirmed)
        assertIs<HubSendStep.Ready>(end(workshop))
    }

    /** The step in which nothing is under way any more. */
    protected fun TestScope.end(workshop: Workshop): HubSendStep? {
        do testScheduler.advanceTimeBy(3_000) while (workshop.state.hubSend?.step?.isBusy == true)
        return workshop.state.hubSend?.step
    }

    protected companion object {
        const val PROGRAM = "forward 20\npen down\nbeep\n"
        val SMALL_MESSAGES = SimulatedModel(messageBytes = 23)
        val ENDLESS = SimulatedProgram {
            it.print("on\r\n")
            awaitCancellation()
        }
    }
}
