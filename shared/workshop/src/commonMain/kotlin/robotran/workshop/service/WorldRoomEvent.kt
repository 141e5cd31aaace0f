package robotran.workshop.service

import robotran.world.RobotDescription

/** What has happened in the editors of the world and its robots, or is asked of them. */
sealed interface WorldRoomEvent : RoomEvent {
    /** The user has changed the world in an editor. */
    data object Edited : WorldRoomEvent

    /** The world editor opens, for the world of the open project or for a [variation] of it. */
    data class EditorRequested(val variation: Int?) : WorldRoomEvent

    data object EditorOpening : WorldRoomEvent

    /** The world editor was closed; [leadsBack] is false if its world is tried out now. */
    data class EditorClosed(val leadsBack: Boolean) : WorldRoomEvent

    /** [robot] was opened from a file and takes the place of another one. */
    data class RobotOpened(val robot: RobotDescription) : WorldRoomEvent
}
