package robotran.workshop.send

import kotlinx.coroutines.CompletableDeferred
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import robotran.language.source.Diagnostic
import robotran.language.source.Severity
import robotran.legofirmware.device.DatalogEntry
import robotran.legofirmware.image.Chunk
import robotran.legofirmware.image.ChunkId
import robotran.legofirmware.image.CodeBytes
import robotran.legofirmware.image.FirmwareTarget
import robotran.legofirmware.image.RcxImage
import robotran.programs.Program
import robotran.projects.Project
import robotran.simulation.state.SessionState
import robotran.tower.RcxVersion
import robotran.tower.ReceivedMessage
import robotran.tower.Remains
import robotran.tower.TowerError
import robotran.tower.TowerResult
import robotran.tower.TransferProgress
import robotran.tower.TransferResult
import robotran.tower.firmware.FirmwareKind
import robotran.tower.port.OpenFailure
import robotran.tower.port.TowerKind
import robotran.workshop.documents.MemoryFilePicker
import robotran.workshop.event.SendEvent
import robotran.workshop.platform.FixedClock
import robotran.workshop.platform.MemoryPlatform
import robotran.workshop.platform.OpenedFile
import robotran.workshop.service.CurrentProject
import robotran.workshop.service.ProgramTabs
import robotran.workshop.state.SendError
import robotran.workshop.state.SendStep
import robotran.workshop.state.Transfer
import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class SendStateHolderTest {
    private val towers = PluggedTowers(listOf(USB_TOWER))
    private val files = MemoryFilePicker()
    private val clock = FixedClock()
    private val robot = ScriptedRobot()
    private val images = TextImages()
    private val shown = mutableListOf<Diagnostic>()
    private val holder = SendStateHolder(
        MemoryPlatform(files = files, clock = clock, towers = towers),
        CoroutineScope(Dispatchers.Unconfined),
        OneProgram,
        RememberingTabs(shown),
        images,
        robot,
    )

    private val step: SendStep? get() = holder.state?.step

    private fun request() = holder.handle(SendEvent.Requested)

    @Test
    fun `the only tower is used without a question, and the program is in the brick at the end`() {
        request()
        assertEquals(SendStep.Done(PROGRAM.length), step)
        assertEquals("square.robo", holder.state?.program)
        assertContentEquals(PROGRAM.encodeToByteArray(), robot.programs.single())
        assertEquals(emptyList(), towers.asked)
    }

    @Test
    fun `with several towers the pupil chooses, and is not asked again for the next program`() {
        towers.devices = listOf(SERIAL_TOWER, USB_TOWER)
        request()
        assertEquals(SendStep.ChoosingTower(towers.devices, listOf(TowerKind.SERIAL, TowerKind.USB)), step)
        holder.handle(SendEvent.TowerChosen(USB_TOWER))
        assertIs<SendStep.Done>(step)
        holder.handle(SendEvent.Cancelled)
        request()
        assertIs<SendStep.Done>(step)
        assertEquals(listOf(USB_TOWER, USB_TOWER), towers.opened.map { it.device })
    }

    @Test
    fun `without a tower the platform is asked for one, and whoever chooses none is told and may ask again`() {
        towers.devices = emptyList()
        request()
        assertEquals(false, assertIs<SendStep.ChoosingTower>(step).isMissing)
        holder.handle(SendEvent.TowerRequested(TowerKind.SERIAL))
        assertEquals(true, assertIs<SendStep.ChoosingTower>(step).isMissing)
        towers.chosen = SERIAL_TOWER
        holder.handle(SendEvent.TowerRequested(TowerKind.SERIAL))
        assertIs<SendStep.Done>(step)
        assertEquals(listOf(TowerKind.SERIAL, TowerKind.SERIAL), towers.asked)
    }

    @Test
    fun `a platform that reaches no tower says so once the program is known to be right`() {
        val none = SendStateHolder(
            MemoryPlatform(),
            CoroutineScope(Dispatchers.Unconfined),
            OneProgram,
            RememberingTabs(shown),
            images,
            robot,
        )
        none.handle(SendEvent.Requested)
        assertEquals(SendStep.NoTowers, none.state?.step)
    }

    @Test
    fun `a program with a mistake is not sent, and its mistake can be shown`() {
        val mistake = Diagnostic(Severity.ERROR, "square.robo", null, "This is too long for a brick.")
        images.result = ProgramImageResult.Failure(listOf(mistake))
        request()
        assertEquals(SendStep.HasErrors(mistake), step)
        holder.handle(SendEvent.DiagnosticShown)
        assertNull(holder.state)
        assertEquals(listOf(mistake), shown)
        assertEquals(emptyList(), towers.opened)
    }

    @Test
    fun `a compiler that did not load is asked for again`() {
        images.result = ProgramImageResult.NoCompiler
        request()
        assertEquals(SendStep.NoCompiler, step)
        images.result = null
        holder.handle(SendEvent.Retried)
        assertIs<SendStep.Done>(step)
    }

    @Test
    fun `a try after a compiler that did not load sends no program of before`() {
        request()
        holder.handle(SendEvent.Cancelled)
        images.result = ProgramImageResult.NoCompiler
        request()
        holder.handle(SendEvent.Retried)
        assertEquals(SendStep.NoCompiler, step)
        assertEquals(1, robot.programs.size)
    }

    @Test
    fun `a tower that cannot be opened is told with its kind, and another try may succeed`() {
        for (failure in OpenFailure.entries) {
            towers.failure = failure
            request()
            assertEquals(SendStep.Failed(SendError.OfPort(failure, TowerKind.USB)), step)
            towers.failure = null
            holder.handle(SendEvent.Retried)
            assertIs<SendStep.Done>(step)
            holder.handle(SendEvent.Cancelled)
        }
    }

    @Test
    fun `a brick that is off is told, and the next try uses the open tower`() {
        robot.checks += TowerError.BrickSilent
        request()
        assertEquals(SendStep.Failed(SendError.OfTower(TowerError.BrickSilent)), step)
        holder.handle(SendEvent.Retried)
        assertIs<SendStep.Done>(step)
        assertEquals(1, towers.opened.size)
    }

    @Test
    fun `a port that is there without a tower is told after a short look, unless the pupil has chosen it`() {
        towers.devices = listOf(SERIAL_TOWER)
        robot.isTowerThere = false
        request()
        assertEquals(SendStep.Failed(SendError.OfTower(TowerError.TowerSilent)), step)
        assertEquals(emptyList(), robot.programs)
        holder.handle(SendEvent.TowerChosen(SERIAL_TOWER))
        assertIs<SendStep.Done>(step)
        assertEquals(1, robot.looks)
    }

    @Test
    fun `a tower unplugged in the middle is opened anew at the next try`() {
        robot.transfers += TransferResult.Failure(TowerError.TowerGone)
        request()
        assertEquals(SendStep.Failed(SendError.OfTower(TowerError.TowerGone)), step)
        assertTrue(towers.opened.single().isClosed)
        holder.handle(SendEvent.Retried)
        assertIs<SendStep.Done>(step)
        assertEquals(2, towers.opened.size)
    }

    @Test
    fun `a brick without leJOS gets the firmware that the pupil chooses, and then the program`() {
        robot.transfers += TransferResult.Failure(TowerError.NoLejos())
        request()
        assertEquals(SendStep.NeedsFirmware(), step)
        files.chosen = listOf(OpenedFile("lejos.srec", firmwareFile()))
        holder.handle(SendEvent.FirmwareFileRequested)
        val chosen = assertNotNull(assertIs<SendStep.NeedsFirmware>(step).file)
        val usable = chosen.usable(needsLego = false)
        assertEquals("lejos.srec" to FirmwareKind.UNKNOWN, chosen.name to usable?.kind)
        assertEquals(emptyList(), robot.firmwares)
        holder.handle(SendEvent.FirmwareConfirmed)
        assertEquals(listOf(usable), robot.firmwares)
        assertIs<SendStep.Done>(step)
        assertEquals(2, robot.programs.size)
    }

    @Test
    fun `a firmware whose transfer was cancelled need not be chosen again`() {
        robot.transfers += TransferResult.Failure(TowerError.NoLejos())
        request()
        files.chosen = listOf(OpenedFile("lejos.srec", firmwareFile()))
        holder.handle(SendEvent.FirmwareFileRequested)
        robot.hold = CompletableDeferred()
        holder.handle(SendEvent.FirmwareConfirmed)
        holder.handle(SendEvent.Cancelled)
        assertEquals(SendStep.Cancelled(Transfer.FIRMWARE), step)
        robot.hold = null
        robot.transfers += TransferResult.Failure(TowerError.NoLejos())
        holder.handle(SendEvent.Retried)
        assertNotNull(assertIs<SendStep.NeedsFirmware>(step).usable)
    }

    @Test
    fun `a file that is no firmware, and the firmware of LEGO, are not sent`() {
        val useless = mapOf("square.robo" to "forward 20".encodeToByteArray(), "f.lgo" to firmwareFile("FIRM0328.LGO"))
        for ((name, bytes) in useless) {
            robot.transfers += TransferResult.Failure(TowerError.NoLejos())
            request()
            files.chosen = listOf(OpenedFile(name, bytes))
            holder.handle(SendEvent.FirmwareFileRequested)
            holder.handle(SendEvent.FirmwareConfirmed)
            val needed = assertIs<SendStep.NeedsFirmware>(step)
            assertEquals(name, needed.file?.name)
            assertNull(needed.usable)
            holder.handle(SendEvent.Cancelled)
        }
        assertEquals(emptyList(), robot.firmwares)
    }

    @Test
    fun `whoever chooses no file is where they were`() {
        robot.transfers += TransferResult.Failure(TowerError.NoLejos())
        request()
        holder.handle(SendEvent.FirmwareFileRequested)
        assertEquals(SendStep.NeedsFirmware(), step)
    }

    @Test
    fun `a program for LEGO's firmware asks for its slot, and the next one too, naming the last`() {
        images.result = ProgramImageResult.Success(LEGO)
        request()
        assertEquals(SendStep.ChoosingSlot(last = null), step)
        holder.handle(SendEvent.SlotChosen(3))
        assertEquals(SendStep.Done(LEGO.image.codeSize, slot = 3), step)
        holder.handle(SendEvent.Cancelled)
        request()
        assertEquals(SendStep.ChoosingSlot(last = 3), step)
        assertEquals(listOf(3 to false), robot.slots)
    }

    @Test
    fun `another try takes the slot that was chosen, and whoever cancels is told which slot is empty`() {
        images.result = ProgramImageResult.Success(LEGO)
        robot.transfers += TransferResult.Failure(TowerError.BadConnection, Remains.NO_PROGRAM)
        request()
        holder.handle(SendEvent.SlotChosen(2))
        val failed = SendStep.Failed(SendError.OfTower(TowerError.BadConnection), Remains.NO_PROGRAM, slot = 2)
        assertEquals(failed, step)
        robot.hold = CompletableDeferred()
        holder.handle(SendEvent.Retried)
        assertIs<SendStep.Sending>(step)
        holder.handle(SendEvent.Cancelled)
        assertEquals(SendStep.Cancelled(Transfer.PROGRAM, slot = 2), step)
        robot.hold = null
        holder.handle(SendEvent.Retried)
        assertEquals(SendStep.Done(LEGO.image.codeSize, slot = 2), step)
    }

    @Test
    fun `a brick without room can be emptied`() {
        images.result = ProgramImageResult.Success(LEGO)
        robot.transfers += TransferResult.Failure(TowerError.TooLarge(900, null), Remains.NO_PROGRAM)
        request()
        holder.handle(SendEvent.SlotChosen(1))
        assertIs<SendStep.Failed>(step)
        holder.handle(SendEvent.SlotsEmptied)
        assertIs<SendStep.Done>(step)
        assertEquals(listOf(1 to false, 1 to true), robot.slots)
    }

    @Test
    fun `a program for LEGO's firmware needs it, and version 2_0 of it`() {
        images.result = ProgramImageResult.Success(LEGO)
        for (why in listOf(TowerError.NoLegoFirmware, TowerError.LegoFirmwareTooOld(RcxVersion(3, 9)))) {
            robot.checks += why
            request()
            assertEquals(why, assertIs<SendStep.NeedsFirmware>(step).why)
            for (useless in listOf("?LIB_VERSION_L00", "")) {
                files.chosen =
                    listOf(OpenedFile("f.lgo", if (useless.isEmpty()) byteArrayOf(1) else firmwareFile(useless)))
                holder.handle(SendEvent.FirmwareFileRequested)
                assertNull(assertIs<SendStep.NeedsFirmware>(step).usable)
            }
            files.chosen = listOf(OpenedFile("firm0328.lgo", firmwareFile("FIRM0328.LGO")))
            holder.handle(SendEvent.FirmwareFileRequested)
            holder.handle(SendEvent.FirmwareConfirmed)
            assertIs<SendStep.ChoosingSlot>(step)
            holder.handle(SendEvent.Cancelled)
        }
        assertEquals(2, robot.firmwares.size)
    }

    @Test
    fun `the datalog is read before a slot is chosen, saved, and a slot can be chosen afterwards`() {
        images.result = ProgramImageResult.Success(LEGO)
        val entries = listOf(DatalogEntry(0x40, 55), DatalogEntry(3, -1))
        robot.datalog = TowerResult.Success(entries)
        request()
        holder.handle(SendEvent.DatalogRequested)
        assertEquals(SendStep.Datalog(entries), step)
        holder.handle(SendEvent.DatalogSaved)
        assertEquals(SendStep.Datalog(entries), step)
        files.location = "/home/log.csv"
        files.full = true
        holder.handle(SendEvent.DatalogSaved)
        assertEquals(SendStep.Datalog(entries, isRefused = true), step)
        files.full = false
        holder.handle(SendEvent.DatalogSaved)
        assertEquals(SendStep.Datalog(entries, savedAs = "log.csv"), step)
        val csv = "entry,source,number,value\n1,sensor,1,55\n2,variable,3,-1\n"
        assertEquals(csv, files.disk.getValue("/home/log.csv").decodeToString())
        holder.handle(SendEvent.Retried)
        assertEquals(SendStep.ChoosingSlot(last = null), step)
        robot.datalog = TowerResult.Failure(TowerError.BadConnection)
        holder.handle(SendEvent.DatalogRequested)
        assertEquals(SendStep.Failed(SendError.OfTower(TowerError.BadConnection)), step)
        assertEquals(emptyList(), robot.slots)
    }

    @Test
    fun `progress is shown, and whoever cancels is told what the brick lacks now`() {
        robot.hold = CompletableDeferred()
        request()
        val progress = TransferProgress(confirmedBlocks = 3, totalBlocks = 12, repeats = 1, secondsLeft = 20)
        assertEquals(SendStep.Sending(Transfer.PROGRAM, progress), step)
        holder.handle(SendEvent.Cancelled)
        assertEquals(SendStep.Cancelled(Transfer.PROGRAM), step)
        robot.hold = null
        holder.handle(SendEvent.Retried)
        assertIs<SendStep.Done>(step)
    }

    @Test
    fun `a step that comes after the sheet was closed changes nothing, and the tower is free again`() {
        val hold = CompletableDeferred<Unit>()
        robot.hold = hold
        request()
        holder.close()
        hold.complete(Unit)
        assertNull(holder.state)
        assertTrue(towers.opened.single().isClosed)
    }

    @Test
    fun `closing after the end releases the tower`() {
        request()
        assertFalse(towers.opened.single().isClosed)
        holder.handle(SendEvent.Cancelled)
        assertNull(holder.state)
        assertTrue(towers.opened.single().isClosed)
    }

    @Test
    fun `another tower can be chosen, which releases the first`() {
        request()
        holder.handle(SendEvent.OtherTowerRequested)
        assertIs<SendStep.ChoosingTower>(step)
        assertTrue(towers.opened.single().isClosed)
    }

    @Test
    fun `messages of the robot are listed with their time until the tower is gone`() {
        val sent = listOf(ReceivedMessage.Number(7), ReceivedMessage.Raw(listOf(-1, 0)))
        robot.messages = sent
        request()
        holder.handle(SendEvent.WatchingRequested)
        val watching = assertIs<SendStep.Watching>(step)
        assertEquals(sent, watching.messages.map { it.received })
        assertEquals(listOf(0, 1), watching.messages.map { it.number })
        assertTrue(watching.isOver)
        assertTrue(towers.opened.single().isClosed)
    }

    @Test
    fun `only the latest messages are kept`() {
        robot.messages = List(SendStep.MAX_MESSAGES + 5) { ReceivedMessage.Number(it) }
        request()
        holder.handle(SendEvent.WatchingRequested)
        val watching = assertIs<SendStep.Watching>(step)
        assertEquals(SendStep.MAX_MESSAGES, watching.messages.size)
        assertEquals(5, watching.messages.first().number)
    }

    @Test
    fun `nothing happens while the sheet is closed`() {
        for (event in listOf(SendEvent.Retried, SendEvent.Cancelled, SendEvent.TowerChosen(USB_TOWER))) {
            holder.handle(event)
            assertNull(holder.state)
        }
        assertEquals(emptyList(), towers.opened)
    }

    private object OneProgram : CurrentProject {
        override val shownProgram = Program.of("square.robo", PROGRAM)
        override val project: Project get() = error("Sending needs only the program.")
        override val replay: Project get() = error("Sending needs only the program.")
        override val session: SessionState get() = error("Sending needs only the program.")
    }

    private class RememberingTabs(private val errors: MutableList<Diagnostic>) : ProgramTabs {
        override fun addProgram(program: Program, replacing: Boolean) = error("Sending adds no program.")

        override fun chooseProgram(index: Int) = error("Sending chooses no program.")

        override fun removeProgram(index: Int) = error("Sending removes no program.")

        override fun replacePrograms(programs: List<Program>) = error("Sending replaces no program.")

        override fun removePrograms(isMeant: (Program) -> Boolean) = error("Sending removes no program.")

        override fun showLine(index: Int, line: Int) = error("Sending shows no line.")

        override fun showDiagnostic(diagnostic: Diagnostic) {
            errors += diagnostic
        }
    }

    private companion object {
        const val PROGRAM = "forward 20\n"
        val LEGO = BuiltProgram.Lego(
            RcxImage(FirmwareTarget.RCX2, listOf(Chunk(ChunkId.MAIN, CodeBytes.of(0x51, 1)))),
        )
    }
}
