package robotran.ui.world

import androidx.compose.foundation.focusable
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.absoluteOffset
import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.runtime.State
import androidx.compose.runtime.key
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.onFocusChanged
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEvent
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.onKeyEvent
import androidx.compose.ui.input.key.type
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.CustomAccessibilityAction
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.customActions
import androidx.compose.ui.semantics.onClick
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.IntOffset
import androidx.compose.ui.unit.max
import robotran.simulation.SessionInput
import robotran.simulation.state.SessionState
import robotran.ui.world.tags.WorldTags
import robotran.ui.world.texts.SheetTexts
import robotran.uikit.*
import robotran.workshop.state.SheetElement
import robotran.workshop.state.SheetElementKind
import robotran.world.World
import robotran.world.geometry.Pose

/**
 * Focusable, accessible handles over the sheet for all movable elements.
 *
 * @param places where the elements are in the picture.
 * @param announced the throttled session for screen readers, see [rememberAnnounced].
 */
@Composable
internal fun ElementHandles(
    world: World,
    session: SessionState,
    announced: SessionState,
    places: HandlePlaces,
    onInput: (SessionInput) -> Unit,
    onChosen: (SheetElement) -> Unit,
) {
    val now = rememberUpdatedState(session)
    val words = movementWords()
    for (thing in movableElements(world)) {
        val pose = poseOf(thing, world, session) ?: continue
        val announcedPose = poseOf(thing, world, announced) ?: continue
        key(world, thing) {
            val mover = remember { ElementMover(thing, world, now, onInput) }
            val place = places.of(pose, reachOf(thing, world))
            ElementHandle(
                mover,
                place.middle,
                place.radius * 2,
                describeElement(thing, announcedPose, world, announced),
                words,
                onChosen,
            )
        }
    }
}

/** A place of the picture, in pixels. */
internal class HandlePlace(val middle: Offset, val radius: Float)

/** Tells where something at a pose, with a reach in centimetres, is in the picture. */
internal fun interface HandlePlaces {
    fun of(pose: Pose, reach: Double): HandlePlace
}

@Composable
private fun ElementHandle(
    mover: ElementMover,
    middle: Offset,
    pixels: Float,
    description: String,
    words: MovementWords,
    onChosen: (SheetElement) -> Unit,
) {
    val size = with(LocalDensity.current) { max(Dimensions.TARGET, pixels.toDp()) }
    val thing = mover.thing
    val actions = remember(words) { mover.actions(words) }
    Box(
        Modifier
            .absoluteOffset { IntOffset((middle.x - size.toPx() / 2).toInt(), (middle.y - size.toPx() / 2).toInt()) }
            .size(size)
            .testTag(WorldTags.thing(thing.kind, thing.number))
            .onFocusChanged { if (it.isFocused) onChosen(thing) }
            .focusRing(size / 2)
            .onKeyEvent(mover::key)
            .focusable()
            .semantics {
                contentDescription = description
                customActions = actions
                if (thing.kind == SheetElementKind.LAMP) onClick(words.switch, mover::switch)
            },
    )
}

/** Applies keyboard and accessibility actions to [thing]. */
private class ElementMover(
    val thing: SheetElement,
    private val world: World,
    private val now: State<SessionState>,
    private val onInput: (SessionInput) -> Unit,
) {
    fun key(event: KeyEvent): Boolean {
        val isPress = event.type == KeyEventType.KeyDown && event.key in PRESSES
        if (isPress && thing.kind == SheetElementKind.LAMP) return switch()
        val pose = poseOf(thing, world, now.value) ?: return false
        val input = inputOf(event, thing, pose) ?: return false
        onInput(input)
        return true
    }

    fun switch(): Boolean {
        val lamp = now.value.lamps.getOrNull(thing.number) ?: return false
        onInput(SessionInput.SwitchLamp(thing.number, !lamp.on))
        return true
    }

    fun actions(words: MovementWords): List<CustomAccessibilityAction> = listOf(
        CustomAccessibilityAction(words.left) { move(-STEP, 0.0) },
        CustomAccessibilityAction(words.right) { move(STEP, 0.0) },
        CustomAccessibilityAction(words.up) { move(0.0, STEP) },
        CustomAccessibilityAction(words.down) { move(0.0, -STEP) },
    ) + if (thing.kind == SheetElementKind.LAMP) {
        emptyList()
    } else {
        listOf(
            CustomAccessibilityAction(words.turnLeft) {
                turn(TURN)
            },
            CustomAccessibilityAction(words.turnRight) { turn(-TURN) },
        )
    }

    private fun move(x: Double, y: Double): Boolean {
        onInput(moved(thing, poseOf(thing, world, now.value) ?: return false, x, y))
        return true
    }

    private fun turn(degrees: Double): Boolean {
        onInput(turned(thing, poseOf(thing, world, now.value) ?: return false, degrees) ?: return false)
        return true
    }

    private companion object {
        val PRESSES = setOf(Key.Enter, Key.NumPadEnter, Key.Spacebar)
    }
}

private data class MovementWords(
    val left: String,
    val right: String,
    val up: String,
    val down: String,
    val turnLeft: String,
    val turnRight: String,
    val switch: String,
)

@Composable
private fun movementWords() = MovementWords(
    left = SheetTexts.moveLeft(spoken),
    right = SheetTexts.moveRight(spoken),
    up = SheetTexts.moveUp(spoken),
    down = SheetTexts.moveDown(spoken),
    turnLeft = SheetTexts.turnLeft(spoken),
    turnRight = SheetTexts.turnRight(spoken),
    switch = SheetTexts.lampSwitch(spoken),
)
