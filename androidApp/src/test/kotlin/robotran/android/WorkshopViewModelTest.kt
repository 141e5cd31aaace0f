package robotran.android

import android.app.Application
import android.os.Looper
import androidx.lifecycle.SavedStateHandle
import kotlinx.coroutines.runBlocking
import org.junit.Assert.assertEquals
import org.junit.Assert.assertFalse
import org.junit.Assert.assertTrue
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.RobolectricTestRunner
import org.robolectric.RuntimeEnvironment
import org.robolectric.Shadows.shadowOf
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.projects.ProjectFileResult
import robotran.projects.readProject
import robotran.workshop.Workshop
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.state.WorkshopStatus
import java.nio.file.Files
import java.util.concurrent.TimeUnit
import kotlin.io.path.readBytes
import kotlin.io.path.readText
import kotlin.io.path.writeText

@RunWith(RobolectricTestRunner::class)
class WorkshopViewModelTest {
    private val app: Application = RuntimeEnvironment.getApplication()
    private lateinit var kept: WorkshopViewModel

    @Test
    fun `the program text comes back after Android has ended the process`() {
        opened().handle(ProgramEvent.ProgramEdited("forward 7"))
        endTheProcess()
        assertEquals("forward 7", opened().state.programText)
    }

    @Test
    fun `all programs come back with all their files`() {
        val workshop = opened()
        workshop.handle(ProgramEvent.NewProgramRequested(ProgramLanguage.JAVA))
        workshop.handle(ProgramEvent.FileAdded)
        val programs = workshop.state.programs.programs
        endTheProcess()
        assertEquals(programs, opened().state.programs.programs)
    }

    @Test
    fun `a Java program is compiled and drives`() = runBlocking {
        val workshop = opened()
        workshop.handle(ProgramEvent.NewProgramRequested(ProgramLanguage.JAVA))
        workshop.compilePrograms()
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(3_000)
        assertEquals(WorkshopStatus.Ended(stopped = false), workshop.state.status)
        assertTrue(workshop.state.session.robot.pose.x > workshop.state.world.start.x + 30)
    }

    @Test
    fun `a long text comes back too`() {
        val long = "beep\n".repeat(30_000)
        opened().handle(ProgramEvent.ProgramEdited(long))
        endTheProcess()
        assertEquals(long, opened().state.programText)
    }

    @Test
    fun `sound that was switched off stays off after Android has ended the process`() {
        opened().handle(SettingsEvent.SoundSwitched(on = false))
        endTheProcess()
        assertFalse(opened().state.soundOn)
    }

    @Test
    fun `a run is written to a file of its own, which then takes the place of the one before`() {
        val file = app.noBackupFilesDir.resolve("run.robotran").toPath()
        file.writeText("the run before")
        val before = Files.createLink(file.resolveSibling("before"), file)
        val workshop = opened()
        workshop.handle(ProgramEvent.ProgramEdited("forward 7"))
        runBlocking { workshop.compilePrograms() }
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(500)
        endTheProcess()
        assertTrue(readProject(file.readBytes(), Language.ENGLISH) is ProjectFileResult.Success)
        assertEquals("the run before", before.readText())
    }

    private fun opened(): Workshop {
        kept = WorkshopViewModel(app, SavedStateHandle())
        waitUntil { kept.workshop != null }
        return checkNotNull(kept.workshop)
    }

    /** Stops the activity, then clears the process state. */
    private fun endTheProcess() {
        kept.rest()
        waitUntil { kept.resting?.isCompleted == true }
        kept.workshop?.close()
    }

    private fun waitUntil(isTrue: () -> Boolean) {
        val end = System.nanoTime() + TimeUnit.SECONDS.toNanos(30)
        while (!isTrue()) {
            check(System.nanoTime() < end) { "it does not come" }
            Thread.sleep(TURN_MILLISECONDS)
            shadowOf(Looper.getMainLooper()).idle()
        }
    }

    private companion object {
        const val TURN_MILLISECONDS = 10L
    }
}
