package robotran.workshop.service

import robotran.projects.Course

/** What has happened in the room in which pupils learn, or is asked of it. */
sealed interface SchoolRoomEvent : RoomEvent {
    /** The task has just been solved. */
    data object TaskSolved : SchoolRoomEvent

    /** A teacher looks at the hand-ins of [course]. */
    data class HandInsRequested(val course: Course) : SchoolRoomEvent
}
