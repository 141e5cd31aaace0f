package robotran.workshop.service

import robotran.workshop.state.CompileStatus
import robotran.workshop.state.Snippet

/** What has happened in the room in which programs are written. */
sealed interface ProgramRoomEvent : RoomEvent {
    /** Programs have changed, or can run now. [byUser] is false for those that the app has put there. */
    data class Written(val byUser: Boolean) : ProgramRoomEvent

    /** Another program is shown. */
    data object Chosen : ProgramRoomEvent

    /** A breakpoint was set or removed, or the programs of another robot are shown. */
    data object DebuggingChanged : ProgramRoomEvent

    /** Programs are going to be compiled, which may stop the app. */
    data object CompileBegun : ProgramRoomEvent

    /** The programs were compiled, or could not be. */
    data class Compiled(val status: CompileStatus) : ProgramRoomEvent

    /** [snippet] is to run at once. */
    data class SnippetRequested(val snippet: Snippet) : ProgramRoomEvent
}
