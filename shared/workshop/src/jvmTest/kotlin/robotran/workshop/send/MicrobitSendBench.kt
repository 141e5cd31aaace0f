package robotran.workshop.send

import kotlinx.coroutines.ExperimentalCoroutinesApi
import kotlinx.coroutines.test.TestScope
import kotlinx.coroutines.test.runTest
import robotran.documents.MemoryKeyValueStore
import robotran.language.source.Diagnostic
import robotran.language.source.Severity
import robotran.language.source.SourceRange
import robotran.microbitlink.ImageResult
import robotran.microbitlink.MicrobitBoard
import robotran.microbitlink.drive.MicrobitDrives
import robotran.microbitlink.drive.NoMicrobitDrives
import robotran.microbitlink.hex.HexMemory
import robotran.microbitlink.simulated.SimulatedBoard
import robotran.programs.Program
import robotran.workshop.documents.MemoryFilePicker
import robotran.workshop.event.MicrobitSendEvent
import robotran.workshop.platform.MemoryPlatform
import robotran.workshop.platform.OpenedFile
import robotran.workshop.state.MicrobitSendStep
import kotlin.test.assertIs

/** A sheet that gets a program onto a simulated board, into a file or onto a drive. */
@OptIn(ExperimentalCoroutinesApi::class)
internal abstract class MicrobitSendBench {
    protected val files = MemoryFilePicker()
    protected val store = MemoryKeyValueStore()

    protected class SendSheet(
        val scope: TestScope,
        val boards: PluggedBoards,
        val tabs: ShownLines,
        val files: MemoryFilePicker,
        val holder: () -> MicrobitSendStateHolder,
    ) {
        val sending = holder()
        val testScheduler get() = scope.testScheduler

        fun request() {
            sending.handle(MicrobitSendEvent.Requested)
            end()
        }

        fun choose(board: MicrobitBoard) {
            files.chosen = listOf(OpenedFile("${board.name.lowercase()}.hex", madeUpHex(board)))
            after(MicrobitSendEvent.MicroPythonRequested)
        }

        fun send() {
            request()
            after(MicrobitSendEvent.UsbRequested)
            assertIs<MicrobitSendStep.Running>(after(MicrobitSendEvent.Confirmed))
        }

        fun after(event: MicrobitSendEvent): MicrobitSendStep? {
            sending.handle(event)
            return end()
        }

        /** All steps until nothing is under way. */
        fun steps(): Set<MicrobitSendStep?> = buildSet {
            do {
                add(sending.state?.step)
                testScheduler.advanceTimeBy(20)
            } while (sending.state?.step?.isBusy == true)
        }

        /** The step in which nothing is under way any more. */
        fun end(): MicrobitSendStep? {
            do testScheduler.advanceTimeBy(1_000) while (sending.state?.step?.isBusy == true)
            return sending.state?.step
        }

        fun saved(name: String) = files.disk.getValue("/home/ada/$name")
    }

    protected fun onSheet(
        main: String = MAIN,
        translation: MicrobitTranslation = MicrobitTranslation.Success(main, MicrobitBoard.V2, 20_150) { it * 10 },
        board: () -> SimulatedBoard = { boardWith(MicrobitBoard.V2) },
        canReach: Boolean = true,
        drives: MicrobitDrives = NoMicrobitDrives,
        check: suspend SendSheet.() -> Unit,
    ) = runTest {
        val boards = PluggedBoards(backgroundScope, board(), canReach)
        val tabs = ShownLines()
        val platform = MemoryPlatform(files = files, store = store, microbits = boards, microbitDrives = drives)
        val programs = object : MicrobitPrograms {
            override suspend fun build(program: Program) = translation
        }
        SendSheet(this, boards, tabs, files) {
            MicrobitSendStateHolder(platform, backgroundScope, ShownProgram, tabs, programs)
        }.check()
    }

    protected companion object {
        const val MAIN = "from microbit import *\nprint(1 / 0)\n"
        const val OLD = "# the old program\n"
        val MISTAKE =
            Diagnostic(Severity.ERROR, "square.robo", SourceRange(3, 1, 5), "A micro:bit has no battery sensor.")

        /** A board without anything. */
        val EMPTY = { SimulatedBoard(checkNotNull(HexMemory.of(emptyList()))) }

        fun boardWith(type: MicrobitBoard): SimulatedBoard {
            val image = madeUpMicroPython(type).imageFor(type) as ImageResult.Success
            val filled = image.value.withFiles(mapOf("main.py" to OLD.encodeToByteArray())) as ImageResult.Success
            val isFirst = type == MicrobitBoard.V1
            return SimulatedBoard(filled.value.memory, if (isFirst) "9900" else "9904", if (isFirst) 253 else 257)
        }
    }
}
