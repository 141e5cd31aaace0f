package robotran.workshop.sheet

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import robotran.workshop.event.SheetEvent
import robotran.workshop.state.SheetCamera
import robotran.workshop.state.SheetViewState

/** Holds the state of the world's view. */
class SheetStateHolder {
    var state: SheetViewState by mutableStateOf(SheetViewState())
        private set

    fun handle(event: SheetEvent) {
        state = when (event) {
            SheetEvent.WholeSheetRequested -> state.copy(camera = SheetCamera.FITTING, followed = null)

            is SheetEvent.CameraMoved -> state.copy(
                camera = event.camera,
                followed = state.followed.takeUnless {
                    event.pushed
                },
            )

            is SheetEvent.FollowChosen -> follow(event.robot)

            is SheetEvent.LayerSwitched -> state.copy(
                shown = if (event.on) {
                    state.shown + event.layer
                } else {
                    state.shown -
                        event.layer
                },
            )

            is SheetEvent.ElementChosen -> state.copy(chosen = event.thing)

            is SheetEvent.MeasuringChanged -> state.copy(measuring = event.measuring)
        }
    }

    /** Called when another world is loaded. */
    fun worldChanged() {
        state = SheetViewState(shown = state.shown)
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
