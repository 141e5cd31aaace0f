package robotran.workshop.export

import kotlinx.coroutines.CompletableDeferred
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.ExperimentalCoroutinesApi
import kotlinx.coroutines.test.StandardTestDispatcher
import kotlinx.coroutines.test.TestScope
import kotlinx.coroutines.test.advanceUntilIdle
import kotlinx.coroutines.test.runCurrent
import kotlinx.coroutines.test.runTest
import robotran.animatedpicture.FrameSource
import robotran.workshop.Workshop
import robotran.workshop.documents.MemoryFilePicker
import robotran.workshop.event.ExportEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.openWorkshop
import robotran.workshop.platform.FileKind
import robotran.workshop.platform.FixedClock
import robotran.workshop.platform.MemoryPlatform
import robotran.workshop.platform.Posters
import robotran.workshop.platform.Printing
import robotran.workshop.platform.Sharing
import robotran.workshop.platform.VideoRecorder
import robotran.workshop.state.MadePicture
import robotran.workshop.state.MovingKind
import robotran.workshop.state.Poster
import robotran.workshop.state.ShowError
import robotran.workshop.state.ShowStep
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertNull
import kotlin.test.assertTrue

@OptIn(ExperimentalCoroutinesApi::class)
class ExportStateHolderTest {
    private val files = MemoryFilePicker().apply { location = "/home/square.gif" }
    private val camera = TestCamera()
    private val printer = TestPrinter()
    private val apps = TestApps()

    @Test
    fun `without a run there is only the sheet to show`() = shown { workshop ->
        workshop.handle(ExportEvent.Requested)
        assertEquals(false, workshop.state.show?.hasRun)
    }

    @Test
    fun `a run becomes a moving picture in a file`() = shown { workshop ->
        workshop.runFor(4_000)
        workshop.handle(ExportEvent.Requested)
        workshop.handle(ExportEvent.MovingChosen(MovingKind.PICTURE))
        assertEquals(4, assertIs<ShowStep.ChoosingSpeed>(workshop.step).chosen.seconds)
        workshop.handle(ExportEvent.MakingRequested)
        runCurrent()
        assertIs<ShowStep.Making>(workshop.step)
        advanceUntilIdle()
        val shown = assertIs<MadePicture.Moving>(assertIs<ShowStep.Made>(workshop.step).work.shown)
        assertEquals(51, shown.states.size)
        assertEquals(emptySet(), files.disk.keys)
        workshop.handle(ExportEvent.SaveRequested)
        advanceUntilIdle()
        assertEquals("square.gif", assertIs<ShowStep.Made>(workshop.step).savedAs)
        val file = files.disk.getValue("/home/square.gif")
        assertEquals("GIF89a", file.decodeToString(0, 6))
    }

    @Test
    fun `cancelling ends the work and returns to the choice`() = shown { workshop ->
        workshop.runFor(4_000)
        workshop.handle(ExportEvent.Requested)
        workshop.handle(ExportEvent.MovingChosen(MovingKind.PICTURE))
        workshop.handle(ExportEvent.MakingRequested)
        runCurrent()
        workshop.handle(ExportEvent.BackRequested)
        advanceUntilIdle()
        assertEquals(ShowStep.Choosing, workshop.step)
        assertEquals(emptySet(), files.disk.keys)
    }

    @Test
    fun `time stands still while the sheet is open, and goes on afterwards`() = shown { workshop ->
        workshop.runFor(1_000)
        workshop.handle(ExportEvent.Requested)
        repeat(20) { workshop.frame(it * FRAME) }
        assertEquals(1_000, workshop.state.run.time)
        workshop.handle(ExportEvent.Closed)
        repeat(20) { workshop.frame((20 + it) * FRAME) }
        assertTrue(workshop.state.run.time > 1_000)
    }

    @Test
    fun `a video is filmed where it can be, and a recorder that fails leads to the moving picture`() =
        shown { workshop ->
            workshop.runFor(1_000)
            workshop.handle(ExportEvent.Requested)
            assertEquals(true, workshop.state.show?.canRecord)
            workshop.handle(ExportEvent.MovingChosen(MovingKind.VIDEO))
            workshop.handle(ExportEvent.MakingRequested)
            advanceUntilIdle()
            assertEquals(14, camera.frames)
            assertIs<ShowStep.Making>(workshop.step)
            camera.film.complete(null)
            advanceUntilIdle()
            assertEquals(ShowStep.Failed(ShowError.NoVideo), workshop.step)
        }

    @Test
    fun `the sheet is saved as a picture, and a full disk is told`() = shown { workshop ->
        workshop.handle(ExportEvent.Requested)
        files.location = "/home/square.svg"
        workshop.handle(ExportEvent.StillChosen(FileKind.SVG))
        save(workshop)
        assertEquals("square.svg", assertIs<ShowStep.Made>(workshop.step).savedAs)
        files.full = true
        workshop.handle(ExportEvent.StillChosen(FileKind.PNG))
        save(workshop)
        val made = assertIs<ShowStep.Made>(workshop.step)
        assertEquals(ShowError.NotSaved("", isFull = true), made.error)
        assertEquals(FileKind.PNG, made.work.kind)
    }

    @Test
    fun `what was made is handed to another app, and stays in sight`() = shown { workshop ->
        workshop.handle(ExportEvent.Requested)
        assertEquals(true, workshop.state.show?.canShare)
        workshop.handle(ExportEvent.StillChosen(FileKind.PNG))
        advanceUntilIdle()
        workshop.handle(ExportEvent.ShareRequested)
        advanceUntilIdle()
        assertEquals(listOf("My first work.png"), apps.taken)
        assertNull(assertIs<ShowStep.Made>(workshop.step).error)
        apps.takes = false
        workshop.handle(ExportEvent.ShareRequested)
        advanceUntilIdle()
        assertEquals(ShowError.NotShared, assertIs<ShowStep.Made>(workshop.step).error)
    }

    @Test
    fun `a poster has the name that the pupil wants, and the date only if wanted`() = shown { workshop ->
        workshop.handle(ProgramEvent.ProgramEdited("forward 7"))
        workshop.handle(ExportEvent.Requested)
        workshop.handle(ExportEvent.PosterChosen)
        val first = assertIs<ShowStep.ChoosingPoster>(workshop.step).poster
        assertEquals(listOf("My first work", "", ""), listOf(first.title, first.maker, first.date))
        workshop.handle(ExportEvent.PosterChanged("A line", "Ada", isDated = true))
        val poster = assertIs<ShowStep.ChoosingPoster>(workshop.step).poster
        assertEquals(listOf("A line", "Ada", "day 2"), listOf(poster.title, poster.maker, poster.date))
        assertEquals("forward 7", poster.program.files.single().text)
        workshop.handle(ExportEvent.MakingRequested)
        advanceUntilIdle()
        workshop.handle(ExportEvent.PrintRequested)
        advanceUntilIdle()
        assertEquals(listOf(poster), printer.printed)
        files.location = "/home/poster.png"
        save(workshop)
        assertEquals("picture of A line by Ada", files.disk.getValue("/home/poster.png").decodeToString())
    }

    @Test
    fun `a poster is a drawing to enlarge if the pupil wants, or if nothing else can be made`() = shown { workshop ->
        workshop.handle(ExportEvent.Requested)
        workshop.handle(ExportEvent.PosterChosen)
        workshop.handle(ExportEvent.PosterKindChosen(FileKind.SVG))
        workshop.handle(ExportEvent.PosterChanged("A line", "Ada", isDated = false))
        assertEquals(FileKind.SVG, madePoster(workshop))
        printer.draws = false
        workshop.handle(ExportEvent.BackRequested)
        workshop.handle(ExportEvent.PosterChosen)
        assertEquals(FileKind.SVG, madePoster(workshop))
    }

    @Test
    fun `a printer that fails says so`() = shown { workshop ->
        printer.result = Printing.Failed("no paper")
        workshop.handle(ExportEvent.Requested)
        workshop.handle(ExportEvent.PosterChosen)
        workshop.handle(ExportEvent.MakingRequested)
        advanceUntilIdle()
        workshop.handle(ExportEvent.PrintRequested)
        advanceUntilIdle()
        assertEquals(ShowError.NotPrinted("no paper"), assertIs<ShowStep.Made>(workshop.step).error)
    }

    @Test
    fun `events of a step that is over change nothing`() = shown { workshop ->
        workshop.handle(ExportEvent.MakingRequested)
        assertNull(workshop.state.show)
        workshop.handle(ExportEvent.Requested)
        for (late in listOf(ExportEvent.MakingRequested, ExportEvent.PrintRequested, ExportEvent.SaveRequested)) {
            workshop.handle(late)
            advanceUntilIdle()
            assertEquals(ShowStep.Choosing, workshop.step)
        }
        assertFalse(files.disk.isNotEmpty())
    }

    private val Workshop.step: ShowStep? get() = state.show?.step

    private fun TestScope.madePoster(workshop: Workshop): FileKind {
        workshop.handle(ExportEvent.MakingRequested)
        advanceUntilIdle()
        val work = assertIs<ShowStep.Made>(workshop.step).work
        assertTrue(work.bytes.decodeToString().startsWith("poster "))
        return work.kind
    }

    private fun TestScope.save(workshop: Workshop) {
        advanceUntilIdle()
        workshop.handle(ExportEvent.SaveRequested)
        advanceUntilIdle()
    }

    private fun Workshop.runFor(milliseconds: Int) {
        handle(RunEvent.RunPressed)
        advance(milliseconds)
    }

    private fun shown(test: suspend TestScope.(Workshop) -> Unit) = runTest {
        val platform = MemoryPlatform(
            files = files,
            clock = FixedClock(now = 2 * 24 * 3_600_000L),
            videos = camera,
            posters = printer,
            sharing = apps,
        )
        val workshop = openWorkshop(platform = platform, scope = CoroutineScope(StandardTestDispatcher(testScheduler)))
        try {
            test(workshop)
        } finally {
            workshop.close()
        }
    }

    /** Takes all frames at once, and waits for the [film]. */
    private class TestCamera : VideoRecorder {
        val film = CompletableDeferred<ByteArray?>()
        var frames = 0
            private set

        override val isAvailable: Boolean get() = true

        override suspend fun record(source: FrameSource, onFrame: (Int) -> Unit): ByteArray? {
            frames = source.count
            onFrame(frames)
            return film.await()
        }
    }

    private class TestApps : Sharing {
        val taken = mutableListOf<String>()
        var takes = true

        override val canShareFiles: Boolean get() = true

        override suspend fun share(text: String): Boolean = false

        override suspend fun shareFile(name: String, kind: FileKind, bytes: ByteArray): Boolean {
            taken += name
            return takes
        }
    }

    private class TestPrinter : Posters {
        val printed = mutableListOf<Poster>()
        var result: Printing = Printing.HandedOver
        var draws = true

        override val canPrint: Boolean get() = true

        override fun svg(poster: Poster): String = "poster ${poster.title} by ${poster.maker}"

        override suspend fun png(poster: Poster): ByteArray? =
            "picture of ${poster.title} by ${poster.maker}".encodeToByteArray().takeIf { draws }

        override suspend fun print(poster: Poster): Printing {
            printed += poster
            return result
        }
    }

    private companion object {
        /** Nanoseconds. */
        const val FRAME = 16_000_000L
    }
}
