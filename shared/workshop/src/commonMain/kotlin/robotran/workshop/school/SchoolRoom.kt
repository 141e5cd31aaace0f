package robotran.workshop.school

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import robotran.brick.kind.ProgramUpload
import robotran.simulation.physics.PhysicsEngine
import robotran.workshop.assignment.AssignmentStateHolder
import robotran.workshop.course.CourseStateHolder
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.CourseEvent
import robotran.workshop.event.ExportEvent
import robotran.workshop.event.HandInsEvent
import robotran.workshop.event.HubSendEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.MicrobitSendEvent
import robotran.workshop.event.SchoolEvent
import robotran.workshop.event.SendEvent
import robotran.workshop.export.ExportStateHolder
import robotran.workshop.handins.HandInPreviews
import robotran.workshop.handins.HandInsStateHolder
import robotran.workshop.learning.LearningStateHolder
import robotran.workshop.send.HubProgramBuilder
import robotran.workshop.send.HubSendStateHolder
import robotran.workshop.send.MicrobitProgramBuilder
import robotran.workshop.send.MicrobitSendStateHolder
import robotran.workshop.send.ProgramImageBuilder
import robotran.workshop.send.SendStateHolder
import robotran.workshop.send.TowerRobotLink
import robotran.workshop.service.ProjectSwitcher
import robotran.workshop.service.RoomEvent
import robotran.workshop.service.Services
import robotran.workshop.service.StoredAssignments

/**
 * The room in which pupils learn and teachers look at their work: lessons, assignments, courses, hand-ins, and what a
 * finished program becomes.
 *
 * @param projects where projects are stored and opened, which is made after this.
 * @param title of the open project.
 */
internal class SchoolRoom<Projects>(
    private val services: Services,
    physics: PhysicsEngine,
    projects: Projects,
    title: () -> String,
) where Projects : ProjectSwitcher, Projects : StoredAssignments {
    val assignment = AssignmentStateHolder(services, physics)
    val course = CourseStateHolder(services, projects, projects)
    val learning = LearningStateHolder(services, projects)
    val handIns = HandInsStateHolder(services, physics, HandInPreviews(projects, services), title)
    val export = ExportStateHolder(services, title)
    val send = with(services) {
        SendStateHolder(platform, scope, current, tabs, ProgramImageBuilder(services), ::TowerRobotLink)
    }

    val hubSend = with(services) {
        HubSendStateHolder(platform, scope, current, tabs, HubProgramBuilder(this))
    }

    /** The sheet that gets programs onto a micro:bit. It is made with the first request, since few pupils need it. */
    private var microbit: MicrobitSendStateHolder? by mutableStateOf(null)
    val microbitSend get() = microbit?.state

    /** Whether a page or sheet covers the paper, so that time stands still there. */
    val coversSheet: Boolean get() = export.state != null || handIns.state != null

    fun on(event: RoomEvent) {
        assignment.on(event)
        course.on(event)
        learning.on(event)
        handIns.on(event)
    }

    fun handle(event: SchoolEvent) {
        when (event) {
            is LearningEvent -> learning.handle(event)
            is AssignmentEvent -> assignment.handle(event)
            is CourseEvent -> course.handle(event)
            is HandInsEvent -> handIns.handle(event)
            is ExportEvent -> export.handle(event)
            is SendEvent -> if (event == SendEvent.Requested) requestSending() else send.handle(event)
            is HubSendEvent -> hubSend.handle(event)
            is MicrobitSendEvent -> microbit?.handle(event)
        }
    }

    private fun requestSending() = when (services.current.shownRobot.description.brick.programUpload) {
        ProgramUpload.HUB -> hubSend.handle(HubSendEvent.Requested)
        ProgramUpload.MICROBIT -> requestMicrobit()
        ProgramUpload.TOWER, ProgramUpload.NONE -> send.handle(SendEvent.Requested)
    }

    private fun requestMicrobit() {
        val holder = microbit ?: with(services) {
            MicrobitSendStateHolder(platform, scope, current, tabs, MicrobitProgramBuilder(this))
        }
        microbit = holder
        holder.handle(MicrobitSendEvent.Requested)
    }

    /** Waits until everything is stored. */
    suspend fun saveNow() {
        learning.saveNow()
        handIns.saveNow()
        assignment.saveNow()
        course.saveNow()
    }

    /** Ends whatever is under way. */
    fun close() {
        send.close()
        hubSend.close()
        microbit?.close()
        export.close()
        handIns.close()
        assignment.close()
    }
}
