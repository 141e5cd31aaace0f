package robotran.workshop

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import robotran.language.Language
import robotran.projects.Project
import robotran.simulation.RecordedInput
import robotran.simulation.RunReport
import robotran.simulation.physics.PhysicsEngine
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.platform.MemoryPlatform
import robotran.workshop.platform.Platform
import robotran.workshop.service.Services
import robotran.workshop.state.Settings
import robotran.workshop.state.WorkshopState

/**
 * The view model of the app: takes each [WorkshopEvent], publishes the states of the rooms as one [WorkshopState], and
 * follows the life of the window. Not thread-safe.
 *
 * @param project the initial project; it gets the square program if it has none.
 * @param settings the stored settings of this machine.
 */
class Workshop(
    project: Project,
    physics: PhysicsEngine,
    private val platform: Platform = MemoryPlatform(),
    settings: Settings = Settings(),
    scope: CoroutineScope = CoroutineScope(Dispatchers.Unconfined),
) {
    private val rooms = Rooms(project, physics, platform, settings, scope)

    /** What the rooms share. */
    val services: Services get() = rooms.services

    /** The current UI state, always the same object. */
    val state: WorkshopState get() = rooms.state

    val project: Project get() = rooms.open.project

    /** [project] with the inputs of the session and the programs that Run started. It reproduces the session. */
    val replay: Project get() = rooms.open.replay

    /** The recorded inputs of the current session. */
    val inputs: List<RecordedInput> get() = rooms.open.inputs
    val settings: Settings get() = rooms.settings.settings
    val language: Language get() = rooms.settings.language
    val hasLessMotion: Boolean get() = rooms.settings.hasLessMotion

    /** Whether time runs on the sheet, so that frames are needed. */
    val isAwake: Boolean get() = rooms.run.state.awake

    /** Handles a user action. */
    fun handle(event: WorkshopEvent) = rooms.handle(event)

    /**
     * Restores the last project or opens the files passed to this window, and restores the learning progress. Must be
     * called once, before anything is shown. On the first run without a project shows the welcome page if [welcoming].
     */
    suspend fun start(welcoming: Boolean) {
        val isReloaded = platform.window.projectId != null
        rooms.school.assignment.start()
        rooms.school.course.start()
        rooms.document.start()
        if (isReloaded) rooms.school.handIns.restore()
        rooms.school.learning.start(welcoming && rooms.document.isFresh)
    }

    /**
     * Compiles Java programs in the pauses of typing; never returns. Call it once while the workshop is on the screen.
     */
    suspend fun runCompiler() {
        while (true) {
            rooms.programs.programs.awaitCompile()
            compilePrograms()
        }
    }

    /**
     * Watches that what was opened is compiled and drawn, so that it may be opened again; never returns. Call it once
     * while the workshop is on the screen, in the scope of its frames.
     */
    suspend fun runOpeningGuard() = OpeningGuard(rooms).run()

    /** Autosaves the project on changes; never returns. Call it once while the workshop is on the screen. */
    suspend fun runAutosave() = rooms.document.runAutosave()

    /** Autosaves changes at once; false on failure. */
    suspend fun saveDocumentNow(): Boolean {
        saveSettings()
        return rooms.document.saveNow()
    }

    /** Autosaves changes at once when the window is hidden, since it may be ended without notice. */
    suspend fun hideDocument() {
        rooms.document.windowHidden()
        saveSettings()
    }

    /** Saves changes at once and asks the user if that fails. Returns whether the window may close. */
    suspend fun closeDocument(): Boolean {
        saveSettings()
        return rooms.document.close()
    }

    private suspend fun saveSettings() {
        rooms.settings.saveNow()
        rooms.school.saveNow()
    }

    /** Compiles all programs that have changed, then runs the actions that waited for the result. */
    suspend fun compilePrograms() {
        rooms.programs.programs.compile()
        rooms.programs.programs.loadHelp()
    }

    /** Called before each frame. [nanoseconds] is monotonic time; virtual time follows it while [isAwake]. */
    fun frame(nanoseconds: Long) =
        with(rooms) { if (school.coversSheet) run.run.standStill() else run.frame(nanoseconds) }

    /** Advances virtual time by [milliseconds] at once, without the sounds of the brick. */
    fun advance(milliseconds: Int) = rooms.run.advance(milliseconds)

    /** The result of the run so far. */
    fun report(): RunReport = rooms.run.run.report()

    /** Releases the session and the document's claims. No function may be called afterwards. */
    fun close() {
        rooms.school.close()
        rooms.document.release()
        rooms.run.run.close()
    }
}
