package robotran.workshop.sheet

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import robotran.workshop.event.SheetEvent
import robotran.workshop.service.Preferences
import robotran.workshop.service.ProgramRoomEvent
import robotran.workshop.service.ProjectRoomEvent
import robotran.workshop.service.RoomEvent
import robotran.workshop.service.RunRoomEvent
import robotran.workshop.service.SchoolRoomEvent
import robotran.workshop.service.WindowRoomEvent
import robotran.workshop.service.WorldRoomEvent
import robotran.workshop.state.SheetCamera
import robotran.workshop.state.SheetViewState
import robotran.workshop.state.SheetWords
import robotran.workshop.state.SpaceCamera

/** Holds the state of the world's view. Whether it is in 3D, and its kind of camera, are settings of this machine. */
class SheetStateHolder(private val preferences: Preferences) {
    private var view: SheetViewState by mutableStateOf(SheetViewState())

    val state: SheetViewState
        get() = preferences.settings.let {
            view.copy(isIn3D = it.isIn3D, cameraKind = it.cameraKind, tellsRuns = it.tellsRuns)
        }

    fun handle(event: SheetEvent) {
        view = when (event) {
            SheetEvent.WholeSheetRequested -> {
                state.copy(
                    camera = SheetCamera.FITTING,
                    followed = null,
                    spaceCamera = SpaceCamera(robot = state.spaceCamera.robot),
                )
            }

            is SheetEvent.CameraMoved -> {
                state.copy(
                    camera = event.camera,
                    followed = state.followed.takeUnless {
                        event.pushed
                    },
                )
            }

            is SheetEvent.PlaceRequested -> {
                val space = state.spaceCamera
                state.copy(
                    camera = state.camera.copy(centre = event.place),
                    followed = null,
                    spaceCamera = if (space.zoom > SpaceCamera.MIN_ZOOM) space.copy(centre = event.place) else space,
                )
            }

            is SheetEvent.FollowChosen -> follow(event.robot)

            is SheetEvent.LayerSwitched -> {
                state.copy(
                    shown = if (event.on) {
                        state.shown + event.layer
                    } else {
                        state.shown -
                            event.layer
                    },
                )
            }

            is SheetEvent.ElementChosen -> state.copy(chosen = event.thing)

            is SheetEvent.SpaceSwitched -> {
                preferences.change(preferences.settings.copy(isIn3D = event.on))
                // Ruler and protractor lie flat on the sheet.
                if (event.on) state.copy(measuring = null, words = null) else state
            }

            is SheetEvent.CameraKindChosen -> {
                preferences.change(preferences.settings.copy(cameraKind = event.kind))
                state.copy(spaceCamera = SpaceCamera(robot = event.robot))
            }

            is SheetEvent.SpaceCameraMoved -> state.copy(spaceCamera = event.camera)

            is SheetEvent.MeasuringChanged -> {
                if (event.measuring != null && state.isIn3D) {
                    preferences.change(preferences.settings.copy(isIn3D = false))
                }
                state.copy(measuring = event.measuring, words = state.words.takeUnless { it is SheetWords.Explored })
            }

            is SheetEvent.WordsChanged -> tell(event.words)
        }
    }

    fun on(event: RoomEvent) {
        when (event) {
            is ProjectRoomEvent.Opened, is ProjectRoomEvent.WorldChanged -> view = SheetViewState(shown = state.shown)
            is RunRoomEvent.PointShown -> handle(SheetEvent.PlaceRequested(event.point))
            is RunRoomEvent.Told -> view = tell(SheetWords.Told(event.story))
            is ProjectRoomEvent.Leaving, is ProjectRoomEvent.WorldSaved, is ProjectRoomEvent.RunSettingsChanged,
            ProjectRoomEvent.AssignmentChanged, ProjectRoomEvent.Touched, RunRoomEvent.Pressed, is RunRoomEvent.Started,
            is RunRoomEvent.Changed, is ProgramRoomEvent, is WorldRoomEvent, is SchoolRoomEvent, is WindowRoomEvent,
            -> Unit
        }
    }

    /** The cross of the explorer lies flat on the sheet, and a finger moves either it or the ruler. */
    private fun tell(words: SheetWords?): SheetViewState {
        if (words !is SheetWords.Explored) return state.copy(words = words)
        if (state.isIn3D) preferences.change(preferences.settings.copy(isIn3D = false))
        return state.copy(words = words, measuring = null)
    }

    /** If the whole sheet is visible, following a robot would have no effect, so this zooms in. */
    private fun follow(robot: Int?): SheetViewState {
        val nearer = robot != null && state.camera.zoom < MIN_FOLLOWING_ZOOM
        return state.copy(followed = robot, camera = if (nearer) SheetCamera(FOLLOWING_ZOOM) else state.camera)
    }

    private companion object {
        const val MIN_FOLLOWING_ZOOM = 1.5
        const val FOLLOWING_ZOOM = 2.5
    }
}
