package robotran.workshop

import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import robotran.brick.kind.ProgramUpload
import robotran.workshop.state.WorkshopState

/** The states of the [rooms], and what needs those of several. */
internal class RoomStates(private val rooms: Rooms, override val hasPage: Boolean) : WorkshopState {
    private val school get() = rooms.school

    override val programs get() = rooms.programs.state
    override val run get() = rooms.run.state
    override val sheet get() = rooms.world.sheet.state
    override val worldEdit get() = rooms.world.editors.world
    override val robotEdit get() = rooms.world.editors.robot
    override val document by derivedStateOf {
        rooms.document.state.copy(
            hasGoals = run.world.goals.isNotEmpty(),
            canSend = programs.brick.programUpload != ProgramUpload.NONE,
            hasFirmwareImage = programs.program.isForLegoFirmware,
        )
    }
    override val settings get() = rooms.settings.state
    override val learning by derivedStateOf { school.learning.state.copy(isInBlocks = programs.view.hasBlocks) }
    override val pane get() = rooms.screen.pane
    override val fullPane get() = rooms.screen.fullPane
    override val taskShown get() = rooms.screen.taskShown
    override val taskFolded get() = rooms.screen.taskFolded
    override val notice get() = rooms.notices.shown
    override val settingsShown get() = rooms.settings.shown
    override val siteRequested get() = rooms.settings.siteRequested
    override val send get() = school.send.state
    override val hubSend get() = school.hubSend.state
    override val microbitSend get() = school.microbitSend
    override val show get() = school.export.state
    override val handIns get() = school.handIns.state
    override val assignment get() = school.assignment.state
    override val handIn get() = school.assignment.handIn
    override val making get() = school.assignment.making
    override val course get() = school.course.state
}
