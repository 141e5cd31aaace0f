package robotran.ui.world

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.border
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.runtime.compositionLocalOf
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.role
import androidx.compose.ui.semantics.selected
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.toggleableState
import androidx.compose.ui.state.ToggleableState
import androidx.compose.ui.unit.dp
import robotran.simulation.state.SessionState
import robotran.ui.world.tags.WorldTags
import robotran.ui.world.texts.SheetTexts
import robotran.uikit.*
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SheetEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.CameraKind
import robotran.workshop.state.SheetLayer
import robotran.workshop.state.SheetViewState

/** Whether runs are heard; null where that cannot be switched. */
val LocalHearsRun = compositionLocalOf<Boolean?> { null }

/**
 * A button that opens the list of how the sheet is looked at: from where, with which of its layers, and in words. A
 * camera follows the selected robot, or else the pupil's own.
 */
@Composable
internal fun ViewMenu(view: SheetViewState, session: SessionState, onEvent: (WorkshopEvent) -> Unit) {
    val robot = robotToFollow(view)
    var open by remember { mutableStateOf(false) }
    Box {
        IconButton(SheetIcons.LAYERS, SheetTexts.show(spoken), WorldTags.SHEET_SHOW, IconButtonKind.FLOATING) {
            open =
                true
        }
        AppMenu(open, { open = false }) {
            if (view.isIn3D) {
                for (kind in CameraKind.entries) {
                    CameraItem(kind, kind == view.cameraKind) {
                        open = false
                        onEvent(SheetEvent.CameraKindChosen(kind, robot))
                    }
                }
            } else {
                val follows = view.followed != null
                SwitchItem(SheetTexts.follow(spoken), WorldTags.SHEET_FOLLOW, follows) {
                    open = false
                    onEvent(SheetEvent.FollowChosen(if (follows) null else robot))
                }
            }
            HorizontalDivider()
            for (layer in SheetLayer.entries) {
                val on = layer in view.shown
                SwitchItem(layer.words(spoken), WorldTags.layer(layer), on) {
                    onEvent(SheetEvent.LayerSwitched(layer, !on))
                }
            }
            HorizontalDivider()
            // The others are beside what is told, so that the menu stays short.
            for (kind in if (view.isIn3D) listOf(WordsKind.WHERE) else WordsKind.entries) {
                MenuItem(kind.label(spoken), WorldTags.ofMenu(kind.tag)) {
                    open = false
                    onEvent(askFor(kind, view, session))
                }
            }
            LocalHearsRun.current?.let { hears ->
                SwitchItem(SheetTexts.hearRun(spoken), WorldTags.HEAR_RUN, hears) {
                    open = false
                    onEvent(RunEvent.HearingSwitched)
                }
            }
        }
    }
}

@Composable
private fun CameraItem(kind: CameraKind, isChosen: Boolean, onClick: () -> Unit) = MenuItem(
    kind.words(spoken),
    WorldTags.camera(kind),
    Modifier.semantics {
        role = Role.RadioButton
        selected = isChosen
    },
    { RadioMark(isChosen) },
    onClick = onClick,
)

@Composable
private fun SwitchItem(label: String, tag: String, on: Boolean, onClick: () -> Unit) = MenuItem(
    label,
    tag,
    Modifier.semantics {
        role = Role.Checkbox
        toggleableState = ToggleableState(on)
    },
    { Tick(on) },
    onClick = onClick,
)

@Composable
private fun Tick(on: Boolean) {
    val colour = LocalRobotranColours.current.onPane
    Box(Modifier.size(24.dp).border(2.dp, colour, Shapes.TINY).padding(3.dp)) {
        if (on) Canvas(Modifier.matchParentSize()) { with(SheetIcons.TICK) { draw(colour) } }
    }
}

private val SheetLayer.words: Label
    get() = when (this) {
        SheetLayer.SENSORS -> SheetTexts::layerSensors
        SheetLayer.TRAIL -> SheetTexts::layerTrail
        SheetLayer.NAMES -> SheetTexts::layerNames
        SheetLayer.GRID -> SheetTexts::layerGrid
        SheetLayer.GOALS -> SheetTexts::layerGoals
    }

internal val CameraKind.words: Label
    get() = when (this) {
        CameraKind.ORBIT -> SheetTexts::spaceCameraOrbit
        CameraKind.FOLLOW -> SheetTexts::spaceCameraFollow
        CameraKind.ROBOT_EYE -> SheetTexts::spaceCameraEye
    }
