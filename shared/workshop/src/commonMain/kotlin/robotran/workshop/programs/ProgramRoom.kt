package robotran.workshop.programs

import robotran.language.source.Diagnostic
import robotran.programs.Program
import robotran.projects.Project
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.service.ProgramRoomEvent
import robotran.workshop.service.ProgramTabs
import robotran.workshop.service.ProjectRoomEvent
import robotran.workshop.service.RoomEvent
import robotran.workshop.service.RunRoomEvent
import robotran.workshop.service.SchoolRoomEvent
import robotran.workshop.service.Services
import robotran.workshop.service.WindowRoomEvent
import robotran.workshop.service.WorldRoomEvent
import robotran.workshop.state.Pane
import robotran.workshop.state.ProgramsState

/**
 * The room in which programs are written. Publishes what others must know about a change of the programs.
 *
 * @param roomInFile how many characters all programs may take in the project's file.
 */
internal class ProgramRoom(project: Project, private val services: Services, roomInFile: () -> Int) : ProgramTabs {
    val programs = ProgramsStateHolder(project, services, roomInFile)
    val state: ProgramsState get() = programs.state

    fun on(event: RoomEvent) {
        when (event) {
            is ProjectRoomEvent.Opened -> programs.open(event.project)

            is ProjectRoomEvent.WorldChanged -> {
                programs.worldChanged(event.project.world)
                if (event.isAnother) programs.removePrograms(event.isLeftBehind, event.beginning)
            }

            is ProjectRoomEvent.WorldSaved -> if (event.isRenamed) programs.worldChanged(event.world)
            is ProjectRoomEvent.RunSettingsChanged -> programs.runJava(event.project.settings.java)
            is WindowRoomEvent.LanguageChanged -> programs.setLanguage(event.language)
            is ProjectRoomEvent.Leaving, ProjectRoomEvent.AssignmentChanged, ProjectRoomEvent.Touched,
            is WindowRoomEvent.SettingsChanged, WindowRoomEvent.PagesLeft, is ProgramRoomEvent, is RunRoomEvent,
            is WorldRoomEvent, is SchoolRoomEvent,
            -> Unit
        }
    }

    fun handle(event: ProgramEvent) = handle(event, byUser = true)

    /** Closes what is open over the blocks, such as a number. */
    fun closeBlockSheet() {
        if (state.blocks?.sheet != null) handle(BlockEvent.DialogShown(null))
    }

    private fun handle(event: ProgramEvent, byUser: Boolean) {
        val before = programs.written
        programs.handle(event)
        if (event is BlockEvent.ViewChosen) {
            with(services.preferences) { change(settings.copy(programView = event.view)) }
        }
        if (event is BlockEvent.SnippetRequested) {
            programs.snippet(event.load)?.let { services.publish(ProgramRoomEvent.SnippetRequested(it)) }
        }
        // Selections and caret movements are nobody else's business.
        when {
            programs.written != before -> services.publish(ProgramRoomEvent.Written(byUser))
            event is ProgramEvent.ProgramChosen -> services.publish(ProgramRoomEvent.Chosen)
        }
        if (event is ProgramEvent.BreakpointToggled || event is ProgramEvent.RobotChosen) {
            services.publish(ProgramRoomEvent.DebuggingChanged)
        }
    }

    override fun addProgram(program: Program, replacing: Boolean) {
        val index = state.programs.indexOfFirst { it.name == program.name }
        if (!replacing || index < 0 || program.files.size > 1) {
            handle(ProgramEvent.ProgramAdded(program), byUser = false)
        } else {
            handle(ProgramEvent.ProgramChosen(index), byUser = false)
            handle(ProgramEvent.ProgramEdited(program.files.single().text), byUser = false)
        }
    }

    override fun chooseProgram(index: Int) = handle(ProgramEvent.ProgramChosen(index))

    override fun removeProgram(index: Int) {
        handle(ProgramEvent.ProgramClosed(index))
        handle(ProgramEvent.ClosedMessageDismissed)
    }

    override fun removePrograms(isMeant: (Program) -> Boolean) {
        programs.removePrograms(isMeant)
        services.publish(ProgramRoomEvent.Written(byUser = false))
    }

    override fun replacePrograms(programs: List<Program>) {
        this.programs.replacePrograms(programs)
        services.publish(ProgramRoomEvent.Written(byUser = false))
    }

    override fun showLine(index: Int, line: Int) {
        programs.showLine(index, line)
        services.publish(ProgramRoomEvent.Chosen)
    }

    override fun showDiagnostic(diagnostic: Diagnostic) = programs.showDiagnostic(diagnostic)

    /** Lets the user change the first length of the shown program. */
    fun editFirstLength() {
        services.navigator.show(Pane.PROGRAM)
        programs.editFirstLength()
    }
}
