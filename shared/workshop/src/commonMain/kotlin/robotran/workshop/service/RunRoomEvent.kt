package robotran.workshop.service

import robotran.narration.RunStory
import robotran.runcontrol.RunOutcome
import robotran.simulation.state.SessionState
import robotran.workshop.state.EndedAttempt
import robotran.world.geometry.Point

/** What has happened in the room in which programs run. */
sealed interface RunRoomEvent : RoomEvent {
    /** Run was pressed in the run bar; nothing has started yet. */
    data object Pressed : RunRoomEvent

    /** Programs were started. [byUser] is false for a program that started by itself, such as by a message. */
    data class Started(val byUser: Boolean) : RunRoomEvent

    /**
     * The run goes on, or another one is shown.
     *
     * @property ended the try that is over, the same object until that changes.
     */
    class Changed(val session: SessionState, val outcome: RunOutcome, val ended: EndedAttempt?) : RunRoomEvent

    /** What happened in the run is told in words. */
    class Told(val story: RunStory) : RunRoomEvent

    /** The user looks at [point] of the sheet, where a goal was missed. */
    data class PointShown(val point: Point) : RunRoomEvent
}
