package robotran.workshop.handins

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.ExperimentalCoroutinesApi
import kotlinx.coroutines.launch
import kotlinx.coroutines.test.StandardTestDispatcher
import kotlinx.coroutines.test.TestScope
import kotlinx.coroutines.test.advanceUntilIdle
import kotlinx.coroutines.test.runTest
import robotran.language.Language
import robotran.projects.LinkCreation
import robotran.projects.Project
import robotran.projects.linkOf
import robotran.workshop.Workshop
import robotran.workshop.assignment.AnyAssignment
import robotran.workshop.documents.FillingStore
import robotran.workshop.documents.MemoryFilePicker
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.HandInsEvent
import robotran.workshop.openWorkshop
import robotran.workshop.platform.FixedClock
import robotran.workshop.platform.GradingWorkers
import robotran.workshop.platform.MemoryPlatform
import robotran.workshop.platform.OpenRequests
import robotran.workshop.platform.OpenedFile
import robotran.workshop.platform.QrScanner
import robotran.workshop.platform.WallClock
import robotran.workshop.state.HandInRow
import robotran.workshop.state.HandInsState
import kotlin.test.assertIs

/** Opens the page with hand-ins for tests, and does there what a teacher does. */
@OptIn(ExperimentalCoroutinesApi::class)
internal abstract class HandInsTesting {
    protected val files = MemoryFilePicker()
    protected val store = FillingStore()
    protected var workers: GradingWorkers? = null
    protected var scanner: QrScanner? = null
    protected lateinit var arrivals: OpenRequests
        private set
    protected lateinit var time: TestScope

    protected val Workshop.page: HandInsState get() = checkNotNull(state.handIns)

    /** From A to Z. */
    protected val Workshop.names: List<String> get() = page.rows.map { it.name }.sorted()

    protected fun Workshop.row(name: String): HandInRow = page.rows.single { it.name == name }

    protected fun Workshop.bring(brought: List<OpenedFile>) {
        files.chosen = brought
        handle(HandInsEvent.FilesRequested)
        time.advanceUntilIdle()
    }

    protected fun Workshop.save(event: HandInsEvent, place: String): ByteArray {
        files.location = place
        handle(event)
        time.advanceUntilIdle()
        return files.disk.getValue(place)
    }

    protected suspend fun link(handIn: Project): String =
        "https://school.example/" + assertIs<LinkCreation.Made>(linkOf(handIn, Language.ENGLISH)).fragment

    /** Five milliseconds pass with each look at it. */
    private class TickingClock(private val clock: FixedClock = FixedClock(now = 1_000_000)) : WallClock by clock {
        override val now: Long get() = (clock.now + 5).also { clock.now = it }
    }

    /** Opens [assignment] and the page with hand-ins for it; only a new project for null. */
    protected fun looking(assignment: Project? = AnyClass.teachers, test: suspend TestScope.(Workshop) -> Unit) =
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
