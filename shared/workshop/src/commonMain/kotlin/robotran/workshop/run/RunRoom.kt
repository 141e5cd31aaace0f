package robotran.workshop.run

import robotran.projects.Project
import robotran.runcontrol.RecordedRun
import robotran.simulation.physics.PhysicsEngine
import robotran.workshop.event.RunEvent
import robotran.workshop.service.ProgramRoomEvent
import robotran.workshop.service.ProgramsToRun
import robotran.workshop.service.ProjectRoomEvent
import robotran.workshop.service.RoomEvent
import robotran.workshop.service.RunControls
import robotran.workshop.service.RunRoomEvent
import robotran.workshop.service.SchoolRoomEvent
import robotran.workshop.service.Services
import robotran.workshop.service.WindowRoomEvent
import robotran.workshop.service.WorldRoomEvent
import robotran.workshop.state.RunPaneState
import robotran.workshop.state.Settings

/** The room in which programs run. Publishes each change of the run. */
internal class RunRoom(
    project: Project,
    physics: PhysicsEngine,
    private val programs: ProgramsToRun,
    private val services: Services,
) : RunControls {
    val run = RunStateHolder(project.worldToRun, physics, programs, services, project.inputs)
    val state: RunPaneState get() = run.state
    private val teller = RunTeller(services, { state }, run::story)

    init {
        hear(services.preferences.settings)
    }

    fun on(event: RoomEvent) {
        when (event) {
            is ProjectRoomEvent.Opened -> {
                teller.forget()
                run.changeWorld(event.project.worldToRun, event.project.inputs)
            }

            is ProjectRoomEvent.WorldChanged -> run.changeWorld(event.project.worldToRun)
            is ProjectRoomEvent.RunSettingsChanged -> run.changeWorld(event.project.worldToRun)
            is ProgramRoomEvent.Written, ProgramRoomEvent.DebuggingChanged -> run.programsChanged()

            is ProgramRoomEvent.Compiled -> {
                run.programsCompiled(event.status)
                publishRun()
            }

            is ProgramRoomEvent.SnippetRequested -> run.runSnippet(event.snippet)
            is WindowRoomEvent.SettingsChanged -> hear(event.settings)

            is WindowRoomEvent.LanguageChanged -> {
                run.programsCompiled(programs.compileStatus)
                run.setLanguage(event.language)
            }

            SchoolRoomEvent.TaskSolved -> if (!services.preferences.hasLessMotion) run.celebrate()

            is ProjectRoomEvent.Leaving, is ProjectRoomEvent.WorldSaved, ProjectRoomEvent.AssignmentChanged,
            ProjectRoomEvent.Touched, ProgramRoomEvent.Chosen, ProgramRoomEvent.CompileBegun,
            is SchoolRoomEvent.HandInsRequested, WindowRoomEvent.PagesLeft, is RunRoomEvent, is WorldRoomEvent,
            -> Unit
        }
    }

    private fun hear(settings: Settings) = run.setSound(settings.soundOn, isHeard = settings.hearsRun)

    fun handle(event: RunEvent) {
        val wasRunning = state.running
        if (event == RunEvent.RunPressed) services.publish(RunRoomEvent.Pressed)
        run.handle(event)
        val byUser = event == RunEvent.RunPressed || (!wasRunning && isStartButton(event))
        if (byUser || (!wasRunning && state.running)) services.publish(RunRoomEvent.Started(byUser))
        publishRun()
        if (event == RunEvent.StoryRequested) teller.tell()
        if (event is RunEvent.ShortfallShown) {
            event.shortfall.place?.let { services.publish(RunRoomEvent.PointShown(it)) }
        }
    }

    private fun isStartButton(event: RunEvent): Boolean =
        event is RunEvent.ButtonPressed && event.button == state.brick.kind.startButton && state.brick.poweredOn

    /** Called before each frame, see [RunStateHolder.frame]. */
    fun frame(nanoseconds: Long) {
        run.frame(nanoseconds)
        publishRun()
    }

    /** Advances virtual time by [milliseconds] at once, without the sounds of the brick. */
    fun advance(milliseconds: Int) {
        run.advance(milliseconds)
        publishRun()
    }

    override fun run() = handle(RunEvent.RunPressed)

    override fun startOver() = handle(RunEvent.StartedOver)

    override suspend fun playInputs() {
        programs.compile()
        handle(RunEvent.RecordingPlayed)
    }

    override fun recordedRun(): RecordedRun = run.recorded()

    private fun publishRun() {
        services.publish(RunRoomEvent.Changed(state.session, state.outcome, run.endedTry))
        teller.look()
    }
}
