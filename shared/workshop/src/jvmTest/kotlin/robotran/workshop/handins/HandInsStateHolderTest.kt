package robotran.workshop.handins

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.ExperimentalCoroutinesApi
import kotlinx.coroutines.awaitCancellation
import kotlinx.coroutines.channels.Channel
import kotlinx.coroutines.launch
import kotlinx.coroutines.test.StandardTestDispatcher
import kotlinx.coroutines.test.TestScope
import kotlinx.coroutines.test.advanceUntilIdle
import kotlinx.coroutines.test.runCurrent
import kotlinx.coroutines.test.runTest
import robotran.assignments.collecting.Submission
import robotran.assignments.collecting.SubmissionRemark
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.grading.GradingPlan
import robotran.documents.ZipEntry
import robotran.documents.zipOf
import robotran.language.Language
import robotran.programs.ProgramCompiler
import robotran.projects.LinkCreation
import robotran.projects.PENBOT_CALIBRATION
import robotran.projects.Project
import robotran.projects.ProjectFileResult
import robotran.projects.RobotLoads
import robotran.projects.linkOf
import robotran.projects.readProject
import robotran.projects.readRobotLoads
import robotran.simulation.Session
import robotran.simulation.grade.runForGoals
import robotran.simulation.physics.loadPhysicsEngine
import robotran.workshop.Workshop
import robotran.workshop.assignment.AnyAssignment
import robotran.workshop.documents.FillingStore
import robotran.workshop.documents.MemoryFilePicker
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.HandInsEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.openWorkshop
import robotran.workshop.platform.FixedClock
import robotran.workshop.platform.GradingCrew
import robotran.workshop.platform.GradingThreads
import robotran.workshop.platform.GradingWorkers
import robotran.workshop.platform.MemoryPlatform
import robotran.workshop.platform.OpenRequest
import robotran.workshop.platform.OpenRequests
import robotran.workshop.platform.OpenedFile
import robotran.workshop.platform.QrScanResult
import robotran.workshop.platform.QrScanner
import robotran.workshop.platform.QrScannerWords
import robotran.workshop.platform.WallClock
import robotran.workshop.state.DocumentDialog
import robotran.workshop.state.HandInOrder
import robotran.workshop.state.HandInRow
import robotran.workshop.state.HandInRun
import robotran.workshop.state.HandInVerdict
import robotran.workshop.state.HandInsDialog
import robotran.workshop.state.HandInsKind
import robotran.workshop.state.HandInsMessage
import robotran.workshop.state.HandInsState
import robotran.workshop.state.Notice
import robotran.workshop.state.QrScannerKind
import robotran.workshop.state.Settings
import robotran.world.World
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

@OptIn(ExperimentalCoroutinesApi::class)
class HandInsStateHolderTest {
    private val files = MemoryFilePicker()
    private val store = FillingStore()
    private var workers: GradingWorkers? = null
    private var scanner: QrScanner? = null

    private companion object {
        val NO_WORDS = QrScannerWords("", "", "", "", "", "")
    }

    @Test
    fun `every hand-in has its verdict, and hostile ones cost only their row`() = looking { workshop ->
        workshop.bring(AnyClass.few)
        val expected = mapOf(
            "Ada" to HandInVerdict.PASSED,
            "Ben" to HandInVerdict.MISSED,
            "Cleo" to HandInVerdict.PARTLY,
            "Dina" to HandInVerdict.HAS_MISTAKES,
            "Emil" to HandInVerdict.MISSED,
            "Fritz" to HandInVerdict.UNUSABLE,
        )
        assertEquals(expected, workshop.page.rows.associate { it.name to it.verdict })
        assertNull(workshop.page.progress)
        assertEquals(HandInsMessage.Brought(5, 0, unusable = 1), workshop.page.told)
        val ada = workshop.row("Ada")
        assertEquals(listOf(2, 2), listOf(ada.lines, (ada.submission as Submission.Usable).handIn?.tries))
    }

    @Test
    fun `the grades are those of runForGoals`() = looking { workshop ->
        workshop.bring(AnyClass.few)
        for (name in listOf("Ada", "Ben", "Cleo")) {
            val graded = checkNotNull(workshop.row(name).results)
            assertEquals(20, graded.runs.size)
            for (run in graded.runs) {
                assertEquals(
                    gradeAlone(workshop.row(name), run.world.world.copy(seed = run.grade.seed)),
                    run.grade.report.toJson(),
                )
            }
        }
    }

    @Test
    fun `without checks a hand-in runs once, and the page says why`() =
        looking(AnyClass.teachers.withoutChecks()) { workshop ->
            assertEquals(HandInsKind.WITHOUT_CHECKS, workshop.page.kind)
            workshop.bring(AnyClass.few.take(2))
            assertEquals(listOf(1, 1), workshop.page.rows.map { it.results?.runs?.size })
        }

    @Test
    fun `a world without goals offers no page, and any world with goals does`() = looking(null) { workshop ->
        assertFalse(workshop.state.document.hasGoals)
        workshop.changeWorld(AnyAssignment.world)
        assertTrue(workshop.state.document.hasGoals)
        workshop.handle(HandInsEvent.Requested)
        advanceUntilIdle()
        assertEquals(HandInsKind.WORLD, workshop.page.kind)
        workshop.bring(AnyClass.few.take(1))
        assertEquals(listOf(HandInVerdict.PASSED), workshop.page.rows.map { it.verdict })
    }

    @Test
    fun `grading goes on in slices, can be stopped, and goes on again`() = looking { workshop ->
        files.chosen = AnyClass.few
        workshop.handle(HandInsEvent.FilesRequested)
        runCurrent()
        while (workshop.page.rows.none { it.name == "Ada" && it.graded != null }) {
            testScheduler.advanceTimeBy(1)
            runCurrent()
        }
        val progress = assertNotNull(workshop.page.progress)
        assertEquals(listOf(2, 6), listOf(progress.handIns, progress.of))
        assertTrue(progress.part in 0.1f..0.9f, "$progress")
        assertTrue(progress.secondsLeft in 1..1_000, "$progress")
        workshop.handle(HandInsEvent.GradingCancelled)
        advanceUntilIdle()
        assertNull(workshop.page.progress)
        assertTrue(workshop.page.isStopped)
        val waiting = workshop.page.rows.filter { it.verdict == HandInVerdict.WAITING }.map { it.name }
        assertEquals(listOf("Ben", "Cleo", "Dina", "Emil"), waiting.sorted())
        workshop.handle(HandInsEvent.GradingResumed)
        advanceUntilIdle()
        assertFalse(workshop.page.isStopped)
        assertTrue(workshop.page.rows.none { it.graded == null })
    }

    @Test
    fun `hand-ins come from zips, folders and links, and what is there already is told`() = looking { workshop ->
        val zip = zipOf(AnyClass.few.take(2).map { ZipEntry("class/${it.name}", it.bytes) })
        workshop.bring(listOf(OpenedFile("class.zip", zip)))
        assertEquals(listOf("Ada", "Ben"), workshop.names)
        workshop.bring(AnyClass.few.take(3))
        assertEquals(HandInsMessage.Brought(1, 2), workshop.page.told)
        workshop.handle(HandInsEvent.PastingRequested)
        assertEquals(HandInsDialog.PastingLinks, workshop.page.dialog)
        val links = listOf("Gabi", "Hans").map { link(AnyClass.handIn(it, AnyClass.solved)) }
        workshop.handle(HandInsEvent.LinksPasted("Here it is: ${links[0]}\nand mine ${links[1]} bye"))
        advanceUntilIdle()
        assertNull(workshop.page.dialog)
        assertEquals(listOf("Ada", "Ben", "Cleo", "Gabi", "Hans"), workshop.names)
        workshop.bring(
            listOf(
                OpenedFile("a.robo", "forward 1".encodeToByteArray(), path = "Class 7/Ina/a.robo"),
                OpenedFile("a.robo", "forward 2".encodeToByteArray(), path = "Class 7/Jo/a.robo"),
            ),
        )
        assertEquals(listOf("Ina", "Jo"), workshop.names.filter { it in setOf("Ina", "Jo") })
        assertEquals(7, workshop.page.rows.count { it.graded != null })
    }

    @Test
    fun `QR codes come in like links, and a camera that is not there is told`() {
        val results = ArrayDeque(listOf(QrScanResult.Ended, QrScanResult.NoCamera))
        var texts = emptyList<String>()
        val useful = mutableListOf<Boolean>()
        scanner = object : QrScanner {
            override val kinds = listOf(QrScannerKind.CAMERA)

            override suspend fun scan(
                kind: QrScannerKind,
                words: QrScannerWords,
                onFound: (String) -> Boolean,
            ): QrScanResult {
                useful += texts.map(onFound)
                return results.removeFirst()
            }
        }
        looking { workshop ->
            assertEquals(listOf(QrScannerKind.CAMERA), workshop.page.scanners)
            texts =
                listOf(
                    "hello",
                    link(AnyClass.handIn("Gabi", AnyClass.solved)),
                    link(AnyClass.handIn("Hans", AnyClass.short)),
                )
            val event = HandInsEvent.ScanRequested(QrScannerKind.CAMERA, NO_WORDS)
            workshop.handle(event)
            advanceUntilIdle()
            assertEquals(listOf(false, true, true), useful)
            assertEquals(listOf("Gabi", "Hans"), workshop.names)
            texts = emptyList()
            workshop.handle(event)
            advanceUntilIdle()
            assertEquals(HandInsMessage.NoCamera, workshop.page.told)
        }
    }

    @Test
    fun `workers of the platform grade the same`() {
        workers = GradingThreads(2)
        looking { workshop ->
            workshop.bring(AnyClass.few)
            while (workshop.page.progress != null) {
                Thread.sleep(5)
                advanceUntilIdle()
            }
            val graded = workshop.page.rows.associate { it.name to it.verdict }
            assertEquals(HandInVerdict.PASSED, graded["Ada"])
            assertEquals(HandInVerdict.PARTLY, graded["Cleo"])
            assertEquals(HandInVerdict.HAS_MISTAKES, graded["Dina"])
        }
    }

    @Test
    fun `what is dropped while the page is open comes to the page, and otherwise to the workshop`() =
        looking { workshop ->
            arrivals.bring(OpenRequest.OfFiles(AnyClass.few.take(1)))
            advanceUntilIdle()
            assertEquals(listOf("Ada"), workshop.names)
            workshop.handle(HandInsEvent.Closed)
            arrivals.bring(
                OpenRequest.OfFiles(listOf(AnyAssignment.file(Project(AnyAssignment.world.copy(title = "Other"))))),
            )
            advanceUntilIdle()
            assertNull(workshop.state.handIns)
            assertEquals("Other", workshop.state.world.title)
        }

    @Test
    fun `what a pupil hands in again takes the place of the first, and the comment stays`() = looking { workshop ->
        workshop.bring(listOf(AnyClass.file("Ada", AnyClass.short, tries = 1)))
        workshop.handle(HandInsEvent.CommentChanged("Ada", "Try again."))
        workshop.bring(listOf(AnyClass.file("Ada", AnyClass.solved, tries = 4)))
        val ada = workshop.page.rows.single()
        assertEquals(HandInVerdict.PASSED, ada.verdict)
        assertEquals("Try again.", ada.comment)
        assertContains((ada.submission as Submission.Usable).remarks, SubmissionRemark.OlderLeftOut(1))
    }

    @Test
    fun `hand-ins and comments are there again when the app has been closed`() {
        looking { workshop ->
            workshop.bring(AnyClass.few)
            workshop.handle(HandInsEvent.CommentChanged("Ben", "A little further."))
            workshop.saveDocumentNow()
        }
        looking { workshop ->
            assertEquals(listOf("Ada", "Ben", "Cleo", "Dina", "Emil", "Fritz"), workshop.names)
            assertEquals("A little further.", workshop.row("Ben").comment)
            assertTrue(workshop.page.rows.none { it.graded == null })
        }
        val other = AnyClass.teachers.copy(assignment = AnyClass.teachers.assignment?.copy(id = "another"))
        looking(other) { assertEquals(emptyList(), it.page.rows) }
    }

    @Test
    fun `removing asks, and then leaves nothing on the device`() = looking { workshop ->
        workshop.bring(AnyClass.few)
        workshop.handle(HandInsEvent.CommentChanged("Ben", "A little further."))
        workshop.handle(HandInsEvent.RemovalRequested)
        assertEquals(HandInsDialog.Removing(6), workshop.page.dialog)
        workshop.handle(HandInsEvent.DialogClosed)
        assertEquals(6, workshop.page.rows.size)
        workshop.handle(HandInsEvent.RemovalConfirmed)
        advanceUntilIdle()
        assertEquals(emptyList(), workshop.page.rows)
        assertEquals(emptyList(), store.names().filter { it.startsWith("hand-ins") })
        workshop.bring(AnyClass.few.take(1))
        assertEquals(listOf("" to HandInVerdict.PASSED), workshop.page.rows.map { it.comment to it.verdict })
    }

    @Test
    fun `a full device is told, and the hand-ins are open all the same`() = looking { workshop ->
        store.full = true
        workshop.bring(AnyClass.few.take(1))
        assertEquals(HandInsMessage.NotKept(""), workshop.page.told)
        assertEquals(HandInVerdict.PASSED, workshop.row("Ada").verdict)
    }

    @Test
    fun `more than there is room for is left out, and that is told`() = looking { workshop ->
        workshop.bring(List(1_001) { AnyClass.text("$it.robo", "forward $it") })
        assertIs<HandInsMessage.TooMany>(workshop.page.told)
        assertEquals(emptyList(), workshop.page.rows)
    }

    @Test
    fun `nothing in what was brought is told`() = looking { workshop ->
        workshop.bring(listOf(OpenedFile("empty.zip", zipOf(emptyList()))))
        assertTrue(
            workshop.page.told?.isError == true || workshop.page.rows.all {
                it.verdict == HandInVerdict.UNUSABLE
            },
        )
    }

    @Test
    fun `equal programs are marked, and stand side by side`() = looking { workshop ->
        val own = AnyClass.robolang(
            "pen down\nrepeat 4 times\n  forward 5\n  turn left 90\nend\nforward 20\nbeep\nshow 7\n",
        )
        val copy = AnyClass.robolang(
            "// mine\npen down\nrepeat 4 times\n  forward 5\n  turn left 90\nend\nforward 20\nbeep\nshow 7\n",
        )
        workshop.bring(
            listOf(AnyClass.file("Ada", own), AnyClass.file("Ben", copy), AnyClass.file("Cleo", AnyClass.short)),
        )
        assertEquals(listOf("Ben"), workshop.row("Ada").alike.map { it.name })
        assertEquals(listOf("Ada"), workshop.row("Ben").alike.map { it.name })
        assertEquals(emptyList(), workshop.row("Cleo").alike)
        workshop.handle(HandInsEvent.HandInChosen("Ada"))
        workshop.handle(HandInsEvent.ComparisonChosen("Ben"))
        assertEquals("Ben", workshop.page.opened?.beside)
        assertEquals(1, workshop.page.solution.size)
    }

    @Test
    fun `the table is ordered by name, or by who needs help first`() = looking { workshop ->
        workshop.bring(AnyClass.few)
        assertEquals(listOf("Fritz", "Dina", "Ben", "Emil", "Cleo", "Ada"), workshop.page.rows.map { it.name })
        workshop.handle(HandInsEvent.OrderChosen(HandInOrder.NAME))
        assertEquals(listOf("Ada", "Ben", "Cleo", "Dina", "Emil", "Fritz"), workshop.page.rows.map { it.name })
    }

    @Test
    fun `a replay is the failed run in the workshop, and leads back to the hand-ins`() = looking { workshop ->
        workshop.bring(AnyClass.few)
        val failed = checkNotNull(workshop.row("Cleo").results).runs.first { !it.grade.passed }
        workshop.handle(HandInsEvent.HandInChosen("Cleo"))
        val run = HandInRun(failed.world.name, failed.grade.seed)
        workshop.handle(HandInsEvent.ReplayRequested("Cleo", run))
        advanceUntilIdle()
        assertNull(workshop.state.handIns)
        assertEquals(Notice.HandInOpened("Cleo", run), workshop.state.notice)
        assertEquals(AnyClass.lucky.files.single().text, workshop.state.programText)
        workshop.advance(20_000)
        assertEquals(failed.grade.goals.map { it.status }, workshop.state.session.goals.map { it.status })
        workshop.handle(WorkshopEvent.NoticeDismissed)
        assertEquals(Notice.HandInOpen, workshop.state.notice)
        workshop.handle(WorkshopEvent.NoticeTaken)
        advanceUntilIdle()
        assertNull(workshop.state.notice)
        assertEquals("Cleo", workshop.page.opened?.id)
        assertEquals(AnyClass.teachers.assignment, workshop.project.assignment)
        assertEquals(listOf("Circle"), workshop.projectNames())
    }

    @Test
    fun `the menu leads back from a replay, too, and what was changed in it stays in My work`() = looking { workshop ->
        workshop.bring(AnyClass.few.take(1))
        workshop.handle(HandInsEvent.ReplayRequested("Ada", null))
        advanceUntilIdle()
        assertTrue(workshop.state.run.running || workshop.state.run.time > 0 || workshop.state.awake)
        workshop.handle(ProgramEvent.ProgramEdited("forward 3"))
        workshop.handle(HandInsEvent.Requested)
        advanceUntilIdle()
        assertEquals(listOf("Ada"), workshop.names)
        assertEquals(setOf("Circle", "Ada"), workshop.projectNames().toSet())
    }

    @Test
    fun `results are saved as a table, a page, and feedback files`() = looking { workshop ->
        workshop.bring(AnyClass.few)
        workshop.handle(HandInsEvent.CommentChanged("Ben", "A little further."))
        workshop.save(HandInsEvent.CsvRequested, "/home/class.csv").decodeToString().let { csv ->
            assertEquals(7, csv.trim().lines().size)
            assertContains(csv, "Ben,")
        }
        val page = workshop.save(HandInsEvent.PageRequested, "/home/class.html").decodeToString()
        assertContains(page, "A little further.")
        assertEquals(HandInsMessage.Saved("class.html"), workshop.page.told)
        val zip = workshop.save(HandInsEvent.FeedbackRequested, "/home/class.zip")
        assertContains(zip.decodeToString(), "Ben - feedback - ")
        val file = workshop.save(HandInsEvent.FeedbackFileRequested("Ben"), "/home/Ben.robotran").decodeToString()
        val project = assertIs<ProjectFileResult.Loaded>(readProject(file)).project
        assertEquals("A little further.", project.feedback?.comment)
        files.full = true
        workshop.handle(HandInsEvent.CsvRequested)
        advanceUntilIdle()
        assertEquals(HandInsMessage.NotSaved("", isFull = true), workshop.page.told)
    }

    @Test
    fun `time stands still behind the page`() = looking { workshop ->
        repeat(20) { workshop.frame(it * 16_000_000L) }
        assertEquals(0, workshop.state.run.time)
    }

    @Test
    fun `ending the scan closes the view of the scanner`() {
        var isOpen = false
        scanner = object : QrScanner {
            override val kinds = listOf(QrScannerKind.CAMERA)

            override suspend fun scan(
                kind: QrScannerKind,
                words: QrScannerWords,
                onFound: (String) -> Boolean,
            ): QrScanResult = try {
                isOpen = true
                awaitCancellation()
            } finally {
                isOpen = false
            }
        }
        looking { workshop ->
            workshop.handle(HandInsEvent.ScanRequested(QrScannerKind.CAMERA, NO_WORDS))
            advanceUntilIdle()
            assertEquals(listOf(true, true), listOf(isOpen, workshop.page.isScanning))
            workshop.handle(HandInsEvent.ScanEnded)
            advanceUntilIdle()
            assertEquals(listOf(false, false), listOf(isOpen, workshop.page.isScanning))
            workshop.handle(HandInsEvent.ScanRequested(QrScannerKind.CAMERA, NO_WORDS))
            advanceUntilIdle()
            workshop.handle(HandInsEvent.Closed)
            advanceUntilIdle()
            assertFalse(isOpen)
        }
    }

    @Test
    fun `a photo without a code is told otherwise than pictures without one`() {
        scanner = object : QrScanner {
            override val kinds = listOf(QrScannerKind.PHOTO, QrScannerKind.PICTURES)

            override suspend fun scan(
                kind: QrScannerKind,
                words: QrScannerWords,
                onFound: (String) -> Boolean,
            ): QrScanResult = QrScanResult.NoCodes
        }
        looking { workshop ->
            for (kind in QrScannerKind.entries.drop(1)) {
                workshop.handle(HandInsEvent.ScanRequested(kind, NO_WORDS))
                advanceUntilIdle()
                assertEquals(HandInsMessage.NoCodes(isPhoto = kind == QrScannerKind.PHOTO), workshop.page.told)
            }
        }
    }

    @Test
    fun `a removed hand-in is gone for good, and the others stay graded`() {
        looking { workshop ->
            workshop.bring(AnyClass.few)
            workshop.handle(HandInsEvent.CommentChanged("Cleo", "Luck."))
            workshop.handle(HandInsEvent.CommentChanged("Ben", "Further."))
            val graded = workshop.page.rows.associate { it.id to it.graded }
            workshop.handle(HandInsEvent.HandInChosen("Cleo"))
            workshop.handle(HandInsEvent.HandInRemoved("Cleo"))
            assertNull(workshop.page.progress)
            advanceUntilIdle()
            assertNull(workshop.page.opened)
            assertEquals(listOf("Ada", "Ben", "Dina", "Emil", "Fritz"), workshop.names)
            assertEquals(HandInsMessage.Removed("Cleo"), workshop.page.told)
            assertTrue(workshop.page.rows.all { it.graded === graded[it.id] })
            val csv = workshop.save(HandInsEvent.CsvRequested, "/home/class.csv").decodeToString()
            assertFalse("Cleo" in csv)
            workshop.saveDocumentNow()
        }
        looking { workshop ->
            assertEquals(listOf("Ada", "Ben", "Dina", "Emil", "Fritz"), workshop.names)
            assertEquals("Further.", workshop.row("Ben").comment)
            workshop.bring(AnyClass.few.take(3))
            assertEquals(HandInsMessage.Brought(1, 2), workshop.page.told)
            assertEquals("", workshop.row("Cleo").comment)
        }
        looking { workshop -> assertEquals(6, workshop.page.rows.size) }
    }

    @Test
    fun `a removal can be undone`() {
        looking { workshop ->
            workshop.bring(AnyClass.few)
            workshop.handle(HandInsEvent.CommentChanged("Cleo", "Luck."))
            val before = workshop.page.rows
            workshop.handle(HandInsEvent.HandInRemoved("Cleo"))
            advanceUntilIdle()
            workshop.handle(HandInsEvent.RemovalUndone)
            assertNull(workshop.page.progress)
            advanceUntilIdle()
            assertEquals(before.map { it.id to it.comment }, workshop.page.rows.map { it.id to it.comment })
            assertTrue(before.zip(workshop.page.rows).all { (one, other) -> one.graded === other.graded })
            assertNull(workshop.page.told)
            // There is nothing more to undo.
            workshop.handle(HandInsEvent.RemovalUndone)
            assertEquals(6, workshop.page.rows.size)
            workshop.saveDocumentNow()
        }
        looking { workshop -> assertEquals("Luck.", workshop.row("Cleo").comment) }
    }

    @Test
    fun `IDs stay with their hand-ins although one before them was removed`() {
        looking { workshop ->
            workshop.bring(listOf(AnyClass.file(AnyClass.handIn("Ida", AnyClass.solved), "one")))
            workshop.bring(listOf(AnyClass.file(AnyClass.handIn("Ida", AnyClass.short), "two")))
            workshop.handle(HandInsEvent.CommentChanged("Ida 2", "Further."))
            workshop.handle(HandInsEvent.HandInRemoved("Ida"))
            advanceUntilIdle()
            assertFalse(workshop.page.rows.single().hasNamesake)
            workshop.saveDocumentNow()
        }
        looking { workshop -> assertEquals("Further.", workshop.page.rows.single().comment) }
    }

    @Test
    fun `two pupils of one name are two rows, and the same file twice is one`() = looking { workshop ->
        val first = AnyClass.file(AnyClass.handIn("Ida", AnyClass.solved, tries = 2), "one")
        val second = AnyClass.file(AnyClass.handIn("Ida", AnyClass.short, tries = 5), "two")
        workshop.bring(listOf(first))
        workshop.bring(listOf(second))
        workshop.bring(listOf(OpenedFile("one again.robotran", first.bytes)))
        assertEquals(HandInsMessage.Brought(0, 1), workshop.page.told)
        val rows = workshop.page.rows.sortedBy { it.id }
        assertEquals(listOf("Ida" to true, "Ida" to true), rows.map { it.name to it.hasNamesake })
        assertEquals(listOf("one.robotran", "two.robotran"), rows.map { it.submission.origin })
        // From the same source a later one takes the place of the first.
        val later = AnyClass.file(AnyClass.handIn("Ida", AnyClass.lucky, tries = 3), "one")
        workshop.bring(listOf(later))
        workshop.bring(listOf(first))
        val now = workshop.page.rows.first { it.id == "Ida" }.submission as Submission.Usable
        assertEquals(listOf(2, 3), listOf(workshop.page.rows.size, now.handIn?.tries))
        assertEquals(listOf(SubmissionRemark.OlderLeftOut(1)), now.remarks)
    }

    @Test
    fun `what comes while others are graded does not disturb them`() {
        val begun = mutableListOf<String>()
        val next = Channel<Unit>(Channel.UNLIMITED)
        workers = object : GradingWorkers {
            override suspend fun start(assignment: Project, plan: GradingPlan, language: Language) =
                object : GradingCrew {
                    override val size = 1

                    override suspend fun grade(
                        submission: Submission.Usable,
                        onProgress: (runs: Int) -> Unit,
                    ): GradedHandIn {
                        begun += submission.name
                        next.receive()
                        return GradedHandIn.HasMistakes(submission, emptyList())
                    }

                    override fun close() = Unit
                }
        }
        looking { workshop ->
            workshop.bring(AnyClass.few.take(2))
            val first = begun.toList()
            workshop.bring(listOf(AnyClass.file("Gabi", AnyClass.solved)))
            workshop.handle(HandInsEvent.HandInRemoved("Gabi"))
            workshop.handle(HandInsEvent.RemovalUndone)
            advanceUntilIdle()
            assertEquals(first, begun)
            assertEquals(listOf(0, 3), workshop.page.progress?.run { listOf(handIns, of) })
            repeat(3) { next.trySend(Unit) }
            advanceUntilIdle()
            assertEquals(listOf("Ada", "Ben", "Gabi"), begun)
            assertTrue(workshop.page.rows.none { it.graded == null })
            assertNull(workshop.page.progress)
        }
    }

    @Test
    fun `a hand-in that is replaced while it is graded has the grade of the new one`() {
        val next = Channel<Unit>(Channel.UNLIMITED)
        workers = object : GradingWorkers {
            override suspend fun start(assignment: Project, plan: GradingPlan, language: Language) =
                object : GradingCrew {
                    override val size = 1

                    override suspend fun grade(
                        submission: Submission.Usable,
                        onProgress: (runs: Int) -> Unit,
                    ): GradedHandIn {
                        next.receive()
                        return GradedHandIn.HasMistakes(submission, listOf("${submission.handIn?.tries}"))
                    }

                    override fun close() = Unit
                }
        }
        looking { workshop ->
            workshop.bring(listOf(AnyClass.file("Ada", AnyClass.short, tries = 1)))
            workshop.bring(listOf(AnyClass.file("Ada", AnyClass.solved, tries = 4)))
            repeat(2) { next.trySend(Unit) }
            advanceUntilIdle()
            val graded = workshop.page.rows.single().graded as GradedHandIn.HasMistakes
            assertEquals(listOf("4"), graded.reasons)
        }
    }

    @Test
    fun `what is no hand-in is named, and gets no row`() = looking { workshop ->
        val teachers = AnyClass.file(AnyClass.teachers, "The assignment")
        workshop.bring(listOf(teachers))
        val note = "The assignment.robotran is the assignment itself, not a hand-in."
        assertEquals(HandInsMessage.NothingFound(listOf(note)), workshop.page.told)
        workshop.bring(listOf(AnyClass.file("Ada", AnyClass.solved), teachers))
        assertEquals(HandInsMessage.Brought(1, 0, listOf(note)), workshop.page.told)
        assertEquals(listOf("Ada"), workshop.page.rows.map { it.name })
        workshop.handle(HandInsEvent.LinksPasted(link(AnyClass.teachers)))
        advanceUntilIdle()
        val ofLink = "Pasted link 1 is the assignment itself, not a hand-in."
        assertEquals(HandInsMessage.NothingFound(listOf(ofLink)), workshop.page.told)
    }

    @Test
    fun `links have numbers and say so in the chosen language`() {
        val links = mutableListOf<String>()
        looking { workshop ->
            listOf("Gabi", "Hans", "Ina").mapTo(links) { link(AnyClass.handIn(it, AnyClass.solved)) }
            workshop.handle(HandInsEvent.LinksPasted("${links[0]} and ${links[1]}"))
            advanceUntilIdle()
            workshop.handle(HandInsEvent.LinksPasted("nothing at all"))
            advanceUntilIdle()
            assertEquals(HandInsMessage.NothingFound(), workshop.page.told)
        }
        looking { workshop ->
            workshop.handle(SettingsEvent.SettingsChanged(Settings(language = Language.GERMAN)))
            workshop.handle(HandInsEvent.Closed)
            workshop.handle(HandInsEvent.Requested)
            advanceUntilIdle()
            workshop.handle(HandInsEvent.LinksPasted(links[2]))
            advanceUntilIdle()
            assertEquals(
                listOf("Eingefügter Link 1", "Eingefügter Link 2", "Eingefügter Link 3"),
                workshop.page.rows.map { it.submission.origin }.sorted(),
            )
            assertTrue(workshop.page.rows.none { it.graded == null })
        }
    }

    @Test
    fun `any two hand-ins can be compared, the most similar first`() = looking { workshop ->
        val own = AnyClass.robolang("pen down\nrepeat 4 times\n  forward 5\n  turn left 90\nend\nforward 20\nbeep\n")
        workshop.bring(
            listOf(
                AnyClass.file("Ada", AnyClass.short),
                AnyClass.file("Ben", own),
                AnyClass.file("Cleo", AnyClass.java("class Circle { }")),
                AnyClass.file("Zoe", own),
                AnyClass.text("Fritz.robotran", "{ \"format\": \"robotran-project\""),
            ),
        )
        workshop.handle(HandInsEvent.HandInChosen("Ben"))
        assertEquals(listOf("Zoe", "Ada", "Cleo"), workshop.page.comparable.map { it.name })
        workshop.handle(HandInsEvent.ComparisonsRequested)
        assertEquals(HandInsDialog.Comparing, workshop.page.dialog)
        workshop.handle(HandInsEvent.ComparisonChosen("Ada"))
        assertEquals(null to "Ada", workshop.page.dialog to workshop.page.opened?.beside)
    }

    @Test
    fun `the page knows which hand-in was open last, also after a replay`() = looking { workshop ->
        workshop.bring(AnyClass.few)
        workshop.handle(HandInsEvent.HandInChosen("Cleo"))
        workshop.handle(HandInsEvent.HandInChosen(null))
        assertEquals("Cleo", workshop.page.last)
        workshop.handle(HandInsEvent.ReplayRequested("Ben", null))
        advanceUntilIdle()
        workshop.handle(HandInsEvent.Requested)
        advanceUntilIdle()
        assertEquals("Ben", workshop.page.last)
    }

    private lateinit var arrivals: OpenRequests
    private lateinit var time: TestScope

    private val Workshop.page: HandInsState get() = checkNotNull(state.handIns)

    /** From A to Z. */
    private val Workshop.names: List<String> get() = page.rows.map { it.name }.sorted()

    private fun Workshop.row(name: String): HandInRow = page.rows.single { it.name == name }

    private fun Workshop.bring(brought: List<OpenedFile>) {
        files.chosen = brought
        handle(HandInsEvent.FilesRequested)
        time.advanceUntilIdle()
    }

    private fun Workshop.save(event: HandInsEvent, place: String): ByteArray {
        files.location = place
        handle(event)
        time.advanceUntilIdle()
        return files.disk.getValue(place)
    }

    private fun Workshop.projectNames(): List<String> {
        handle(DocumentEvent.ProjectListRequested)
        time.advanceUntilIdle()
        val list = state.document.dialog as DocumentDialog.ProjectList
        return list.projects.orEmpty().map { it.entry.name }
    }

    private suspend fun link(handIn: Project): String =
        "https://school.example/" + assertIs<LinkCreation.Made>(linkOf(handIn)).fragment

    private suspend fun gradeAlone(row: HandInRow, world: World): String {
        val robot = world.robots.first().name
        val loads =
            readRobotLoads(world, ProgramCompiler(PENBOT_CALIBRATION), mapOf(robot to row.programs.map { it.source }))
        val session = Session(world, assertIs<RobotLoads.Ready>(loads).loads, loadPhysicsEngine())
        return session.runForGoals().report.toJson().also { session.close() }
    }

    private fun Project.withoutChecks() = copy(assignment = assignment?.copy(checks = null))

    /** Five milliseconds pass with each look at it. */
    private class TickingClock(private val clock: FixedClock = FixedClock(now = 1_000_000)) : WallClock by clock {
        override val now: Long get() = (clock.now + 5).also { clock.now = it }
    }

    /** Opens [assignment] and the page with hand-ins for it; only a new project for null. */
    private fun looking(assignment: Project? = AnyClass.teachers, test: suspend TestScope.(Workshop) -> Unit) =
        runTest {
            arrivals = OpenRequests()
            time = this
            val platform = MemoryPlatform(
                files = files,
                store = store,
                clock = TickingClock(),
                openRequests = arrivals,
                gradingWorkers = workers,
                qrScanner = scanner,
            )
            val scope = CoroutineScope(StandardTestDispatcher(testScheduler))
            val workshop = openWorkshop(platform = platform, scope = scope)
            val autosave = scope.launch { workshop.runAutosave() }
            try {
                if (assignment != null) {
                    workshop.handle(
                        DocumentEvent.FilesBrought(listOf(AnyAssignment.file(assignment, "Circle.robotran"))),
                    )
                    advanceUntilIdle()
                    workshop.handle(HandInsEvent.Requested)
                    advanceUntilIdle()
                }
                test(workshop)
            } finally {
                workshop.close()
                autosave.cancel()
            }
        }
}
