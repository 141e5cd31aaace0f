package robotran.workshop

import kotlinx.coroutines.CoroutineScope
import robotran.projects.Project
import robotran.simulation.physics.PhysicsEngine
import robotran.workshop.documents.DocumentStateHolder
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.CourseEvent
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.HandInsEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RobotEditEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SchoolEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.event.WorldEvent
import robotran.workshop.platform.Platform
import robotran.workshop.programs.ProgramRoom
import robotran.workshop.run.RunRoom
import robotran.workshop.school.SchoolRoom
import robotran.workshop.screen.ScreenStateHolder
import robotran.workshop.service.ProjectRoomEvent
import robotran.workshop.service.RoomEvent
import robotran.workshop.service.RoomEvents
import robotran.workshop.service.Services
import robotran.workshop.settings.SettingsStateHolder
import robotran.workshop.state.LearningPage
import robotran.workshop.state.Settings
import robotran.workshop.world.WorldRoom

/**
 * Composes the rooms and what they share, and hands each [WorkshopEvent] to the room that it is for. What a room must
 * tell others are [RoomEvent]s.
 */
internal class Rooms(
    project: Project,
    physics: PhysicsEngine,
    platform: Platform,
    settings: Settings,
    scope: CoroutineScope,
) {
    private val events = RoomEvents()
    val settings = SettingsStateHolder(platform, scope, settings, events)
    val screen: ScreenStateHolder =
        ScreenStateHolder(events, { state.hasTask }) { handle(SettingsEvent.SiteRequested) }
    val notices: NoticeStateHolder =
        NoticeStateHolder({ school.handIns.isVisiting }, { noticeActions.canUndo(it) }) { run.state.outcome }
    val open: OpenProject = OpenProject(project, events, { programs.programs }, { run.run })

    /** What the rooms share. */
    val services: Services = Services(
        platform = platform,
        scope = scope,
        preferences = this.settings,
        current = open,
        editor = open,
        assignments = open,
        navigator = screen,
        notices = notices,
        events = events,
        tabs = { programs },
        runControls = { run },
    )
    val programs: ProgramRoom = ProgramRoom(project, services, open::roomForPrograms)
    val run: RunRoom = RunRoom(project, physics, programs.programs, services)
    val world = WorldRoom(services) { school.assignment.state?.isWorldLocked == true }
    val document: DocumentStateHolder =
        DocumentStateHolder(services, { school.course.opened(it) }) { school.handIns.takes(it) }
    val school: SchoolRoom<DocumentStateHolder> =
        SchoolRoom(services, physics, document) { document.state.name.ifEmpty { open.world.title } }
    private val noticeActions: NoticeActions = NoticeActions(this)

    /** The states of all rooms, always the same object. */
    val state: RoomStates = RoomStates(this, hasPage = platform.pageAddress.isNotEmpty())

    init {
        // Each follows those before it: the task is shown as the lesson says, an undo is offered if it is still there.
        val subscribers = listOf<(RoomEvent) -> Unit>(
            programs::on,
            run::on,
            world::on,
            school::on,
            this.settings::on,
            screen::on,
            notices::on,
            document::on,
        )
        subscribers.forEach(events::subscribe)
    }

    fun handle(event: WorkshopEvent) {
        if (opensRoom(event)) programs.closeBlockSheet()
        when (event) {
            is ProgramEvent -> programs.handle(event)
            is RunEvent -> run.handle(event)
            is WorldEvent -> world.handle(event)
            is SchoolEvent -> school.handle(event)
            is DocumentEvent -> document.handle(event)
            is SettingsEvent -> settings.handle(event)
            is ScreenEvent -> screen.handle(event)
            WorkshopEvent.NoticeDismissed -> notices.dismiss()
            WorkshopEvent.NoticeTaken -> notices.take()?.let(noticeActions::perform)
        }
        events.publish(ProjectRoomEvent.Touched)
    }
}

/** Whether [event] leads to another room, so that a number that is open in the blocks would be in the way there. */
private fun opensRoom(event: WorkshopEvent): Boolean = when (event) {
    is LearningEvent.PageRequested -> event.page != LearningPage.HELP
    is SettingsEvent.SettingsShown -> event.shown
    LearningEvent.TutorialStarted, WorldEditEvent.EditorOpened, is RobotEditEvent.BenchOpened -> true
    HandInsEvent.Requested, AssignmentEvent.MakingRequested, CourseEvent.ListRequested -> true
    else -> false
}
