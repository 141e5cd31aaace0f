package robotran.workshop.send

import kotlinx.coroutines.CoroutineScope
import robotran.language.source.Diagnostic
import robotran.microbitlink.BoardError
import robotran.microbitlink.ImageResult
import robotran.microbitlink.MicrobitBoard
import robotran.microbitlink.dap.ChosenBoard
import robotran.microbitlink.dap.MicrobitPorts
import robotran.microbitlink.dap.OpenedBoard
import robotran.microbitlink.dap.PluggedBoard
import robotran.microbitlink.drive.DriveResult
import robotran.microbitlink.drive.MicrobitDrive
import robotran.microbitlink.drive.MicrobitDrives
import robotran.microbitlink.image.MicroPythonFile
import robotran.microbitlink.simulated.CableFaults
import robotran.microbitlink.simulated.SimulatedBoard
import robotran.microbitlink.simulated.SimulatedDapPort
import robotran.programs.Program
import robotran.projects.Project
import robotran.simulation.state.SessionState
import robotran.workshop.service.CurrentProject
import robotran.workshop.service.ProgramTabs

internal val MY_BOARD = PluggedBoard("mine", "BBC micro:bit CMSIS-DAP")
internal val OTHER_BOARD = PluggedBoard("other", "BBC micro:bit CMSIS-DAP")

/** A machine with [board] at its USB. */
internal class PluggedBoards(
    private val scope: CoroutineScope,
    var board: SimulatedBoard,
    override val canReach: Boolean = true,
) : MicrobitPorts {
    /** Those that need no question. */
    var boards = emptyList<PluggedBoard>()

    /** What the platform's dialog returns. */
    var chosen: PluggedBoard? = MY_BOARD

    /** Those that are plugged in where the platform has no dialog. */
    var several = emptyList<PluggedBoard>()

    /** Why boards cannot be opened. */
    var failure: BoardError? = null

    /** Why nobody may be asked for a board; null if that is possible. */
    var refused: BoardError? = null

    /** What goes wrong on the next connection. */
    var faults = CableFaults()

    val opened = mutableListOf<PluggedBoard>()
    var questions = 0
        private set
    var port: SimulatedDapPort? = null

    override suspend fun available(): List<PluggedBoard> = boards

    override suspend fun choose(): ChosenBoard {
        questions++
        refused?.let { return ChosenBoard.Refused(it) }
        if (several.isNotEmpty()) return ChosenBoard.Several(several)
        val board = chosen ?: return ChosenBoard.None
        boards = listOf(board)
        return ChosenBoard.Chosen(board)
    }

    override suspend fun open(board: PluggedBoard): OpenedBoard {
        opened += board
        failure?.let { return OpenedBoard.Failure(it) }
        return OpenedBoard.Success(SimulatedDapPort(scope, this.board, faults).also { port = it })
    }
}

/** The drive of a board, which says [result] to each file. */
internal class PluggedDrive(private val result: DriveResult) : MicrobitDrives {
    override val canWrite: Boolean get() = true

    var hex: ByteArray? = null

    override suspend fun available() = listOf(MicrobitDrive("/media/ada/MICROBIT"))

    override suspend fun copy(hex: ByteArray, drive: MicrobitDrive): DriveResult {
        this.hex = hex
        return result
    }
}

/** A made-up file for [board]: no MicroPython, but laid out like it. */
internal fun madeUpHex(board: MicrobitBoard): ByteArray {
    val name = "/vectors/madeup-${board.name.lowercase()}.hex"
    return checkNotNull(PluggedBoards::class.java.getResourceAsStream(name)) { name }.use { it.readBytes() }
}

/** The same, read. */
internal fun madeUpMicroPython(board: MicrobitBoard): MicroPythonFile =
    (MicroPythonFile.read(madeUpHex(board).decodeToString()) as ImageResult.Success).value

/** The programs in a file. */
internal fun programsIn(hex: ByteArray): Map<MicrobitBoard, String?> {
    val file = (MicroPythonFile.read(hex.decodeToString()) as ImageResult.Success).value
    return file.images.mapValues { (_, image) ->
        (image.files() as ImageResult.Success).value["main.py"]?.decodeToString()
    }
}

/** A project of which only the program is asked. */
internal object ShownProgram : CurrentProject {
    override val shownProgram: Program = Program.of("square.robo", "forward 20\n")
    override val project: Project get() = error("not needed")
    override val replay: Project get() = error("not needed")
    override val session: SessionState get() = error("not needed")
}

/** Tabs that remember what is shown. */
internal class ShownLines : ProgramTabs {
    var shown: Diagnostic? = null

    override fun showDiagnostic(diagnostic: Diagnostic) {
        shown = diagnostic
    }

    override fun addProgram(program: Program, replacing: Boolean) = Unit

    override fun chooseProgram(index: Int) = Unit

    override fun replacePrograms(programs: List<Program>) = Unit

    override fun showLine(index: Int, line: Int) = Unit

    override fun removeProgram(index: Int) = Unit

    override fun removePrograms(isMeant: (Program) -> Boolean) = Unit
}
